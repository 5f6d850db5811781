// Which of the registered components a scene calls for, and why: a pure function of a few facts about the
// scene. It knows no world and no store, so it can be tested by itself.
#pragma once

#include "runtime/world/component_graph.hpp"

#include <cstddef>
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
    levelAskedFor, ///< its detail level was asked for
    onlyCandidate, ///< it has no alternative that could be there as well
    leastRank,     ///< of the candidates that suit the scene it has the least rank
    noneSuits,     ///< no candidate suits the scene, and it was registered before the others
    // Not chosen:
    noObjects,         ///< the scene has no objects with `property`, or with any of the properties needed
    noResolver,        ///< it is an interaction, and no resolver of its role is chosen
    noProvider,        ///< it reads `property`, which no component that could be there offers
    notRead,           ///< it is computed on demand, or would stand in for such a one, and nobody reads it
    alternativeChosen, ///< another component that serves the same need is chosen
};

/// What was decided about one component.
struct Choice {
    ChoiceReason reason = ChoiceReason::undecided;
    /// With noObjects: the first property that it needs objects with and no object has, or nullptr where any
    /// one of several would do. With noProvider: the first property that it reads and nobody offers.
    PropertyInfo const* property = nullptr;
    /// Of a component that is not chosen: the number of the alternative that is, if any.
    std::optional<std::size_t> alternative{};

    [[nodiscard]] bool chosen() const {
        return reason >= ChoiceReason::levelAskedFor && reason <= ChoiceReason::noneSuits;
    }
};

/// What the choice depends on besides the descriptions of the components.
struct SelectionFacts {
    std::vector<std::string_view> inhabited;   ///< keys of the object properties that objects have; ascending
    std::vector<std::string_view> subscribed;  ///< keys of the properties with readers outside; ascending
    std::map<std::string, std::string> detail; ///< effect -> the detail level that was asked for
    /// Whether a component, by its number, suits the scene. Asked only where candidates differ by nothing
    /// else, at most once for each; it must follow from the scene alone. None: every component suits.
    std::function<bool(std::size_t)> suits;
};

/// What is decided about each component, at its number.
///
/// A component is a *candidate* if the objects that it needs exist and if everything that it reads, and the
/// resolver that it calls, can be there without it: provided by candidates in turn, whose reads are provided,
/// and so on; two that wait for each other are none. Of candidates that are alternatives one is chosen: the
/// first whose detail level is asked for, else the one of least rank that suits the scene, the first
/// registered among equals, else the first. Then what is computed on demand is taken away if neither a chosen
/// component nor a subscription reads it, its alternatives and the interactions that call it with it; and so
/// on, as these were readers, too. Two on demand that read each other's results stay.
///
/// O(components + properties that they name), times the logarithm of the facts.
[[nodiscard]] std::vector<Choice> selectComponents(ComponentGraph const& graph, SelectionFacts const& facts);

} // namespace trembler
