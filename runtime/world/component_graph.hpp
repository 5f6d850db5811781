// The needs, reads, offers and calls of components as numbers: made once from the descriptions, so that
// selecting components, which happens whenever objects are created or destroyed, compares no names and
// searches no lists.
#pragma once

#include "runtime/component/info.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace trembler {

/// Components, properties and groups of alternatives as numbers. The number of a component is its place in
/// the list from which the graph was made.
struct ComponentGraph {
    using Numbers = std::vector<std::size_t>;

    struct Component {
        ComponentInfo const* info = nullptr;
        Numbers neededAll; ///< object properties
        Numbers neededAny; ///< object properties
        Numbers reads;     ///< offered properties; no object properties, which need no provider
        Numbers offers;    ///< offered properties
        std::size_t group = 0;
        std::optional<std::size_t> resolvers{}; ///< of an interaction: the group of resolvers that it calls
    };

    /// A resolver or derived property.
    struct Offered {
        PropertyInfo const* info = nullptr;
        Numbers readers;   ///< components, ascending; twice if a component lists it twice
        Numbers providers; ///< components, ascending
    };

    /// Alternatives (see areAlternatives()), of which a world has one at most. Each interaction is a group of
    /// its own.
    struct Group {
        Numbers members; ///< ascending
        Numbers callers; ///< of resolvers: the interactions that call them, ascending
    };

    ComponentGraph() = default;
    /// `components` must outlive the graph. Alternatives must offer the same properties, and no other
    /// component may offer one of these, as Registry::check() verifies. O(n log n) in the number of
    /// properties that the components name.
    explicit ComponentGraph(std::span<ComponentInfo const* const> components);

    std::vector<Component> components;
    std::vector<PropertyInfo const*>
        objectProperties;         ///< that objects must have for components to be needed; by key
    std::vector<Offered> offered; ///< by key
    std::vector<Group> groups;
};

} // namespace trembler
