// Which components may run at the same time, derived from what they declare (5.7.1).
#pragma once

#include "runtime/component/info.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

/// Why two resolvers must not run at the same time.
struct Conflict {
    enum class Kind : std::uint8_t {
        bothWrite,        ///< write(A) and write(B) share a property
        firstWritesRead,  ///< write(A) and read(B) share a property
        secondWritesRead, ///< write(B) and read(A) share a property
    };
    Kind kind;
    PropertyInfo const* property; ///< nullptr: one of the two writes every property
};

/// All conflicts between two resolvers; none exactly if the three conditions of 5.7.1 hold.
[[nodiscard]] std::vector<Conflict> conflicts(ComponentInfo const& a, ComponentInfo const& b);
[[nodiscard]] inline bool mayRunTogether(ComponentInfo const& a, ComponentInfo const& b) {
    return conflicts(a, b).empty();
}

/// Throws RuleBroken, with both names, if two resolvers write one property.
void refuseDoubleWriters(ComponentInfo const& a, ComponentInfo const& b);

/// The order that a set of resolvers, given in registration order, must keep: pairs (earlier, later) of all
/// that conflict. Resolvers that no pairs connect may run at the same time. Derived property sets and
/// interactions have no edges among themselves (5.7.1).
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>>
deriveEdges(std::span<ComponentInfo const* const> resolvers);

} // namespace trembler
