// The choice of the components that a scene needs, with reasons: a pure function of their descriptions and of
// a few facts about the scene. It does not depend on a world or a store, so it can be tested separately.
#pragma once

#include "runtime/world/component_graph.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler {

/// Why a component is chosen, or is not.
enum class ChoiceReason : std::uint8_t {
    undecided, ///< no selection has been made yet
    // Chosen:
    levelAskedFor, ///< its detail level was requested
    onlyCandidate, ///< none of its alternatives is a candidate
    leastRank,     ///< it has the least rank of the candidates that suit the scene
    noneSuits,     ///< no candidate suits the scene, and it is the first of them
    // Not chosen:
    noObjects,         ///< the scene has no objects with `property`, or with any of the properties needed
    noResolver,        ///< it is an interaction, and no resolver of its role is chosen
    noProvider,        ///< it reads `property`, which no candidate offers
    notRead,           ///< it, or its alternative, is computed on demand, and its properties have no readers
    alternativeChosen, ///< another component that serves the same need is chosen
};

/// The decision about one component.
struct Choice {
    ChoiceReason reason = ChoiceReason::undecided;
    /// With noObjects: the first property that it needs and no object has, or nullptr if it needs any one of
    /// several. With noProvider: the first property that it reads and no candidate offers.
    PropertyInfo const* property = nullptr;
    /// Of a component that is not chosen: the number of the alternative that is, if any.
    std::optional<std::size_t> alternative{};

    [[nodiscard]] bool chosen() const {
        return reason >= ChoiceReason::levelAskedFor && reason <= ChoiceReason::noneSuits;
    }
};

/// The facts on which the choice depends besides the descriptions of the components.
struct SelectionFacts {
    std::vector<std::string_view> inhabited;   ///< keys of the object properties that objects have; ascending
    std::vector<std::string_view> subscribed;  ///< keys of the properties with readers outside; ascending
    std::map<std::string, std::string> detail; ///< effect -> the requested detail level
    /// Whether a component, by its number, suits the scene. Called only if there are several candidates and
    /// no detail level is requested, in order of rank, at most once for each component. The result must
    /// depend on the scene alone. An empty function: every component suits.
    std::function<bool(std::size_t)> suits;
};

/// The choice about each component, at the component's number. In three steps:
///
/// 1. A component is a *candidate* if the objects that it needs exist, if candidates offer all resolver and
///    derived properties that it reads and, for an interaction, if one of them is a resolver of its role.
///    This is the least such set: components that need each other in a circle are no candidates.
/// 2. Of candidates that are alternatives one is chosen: the first whose detail level is requested; else the
///    one of least rank among the candidates that suit the scene, the first of equals; else the first.
///    "First" is by number.
/// 3. A chosen component that is computed on demand is removed, with its alternatives, if neither a chosen
///    component nor a subscription reads a property that it offers. The interactions that call it are removed
///    with it. This repeats, as removed components are no longer readers. A resolver on demand stays while an
///    interaction that calls it reads its properties.
///
/// As resolvers read object properties only and derived property sets no derived properties (5.4, 5.5), the
/// order of removals in step 3 does not matter.
///
/// O(components + the properties that they name), times the logarithm of the number of facts.
[[nodiscard]] std::vector<Choice> selectComponents(ComponentGraph const& graph, SelectionFacts const& facts);

} // namespace trembler
