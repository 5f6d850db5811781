// Wires of worlds that are built without a level.
#pragma once

#include "physics/electricity/rules/initial_connections.hpp"
#include "physics/electricity/rules/wire.hpp"

#include <optional>
#include <string>

namespace trembler {

/// Connects two objects as a level's "connections" do. Returns the fault and the expected condition, in
/// words, and changes nothing, if an object does not exist or is no conductor, or both are the same;
/// otherwise returns nothing. Before the first frame only.
[[nodiscard]] inline std::optional<std::string> connectInitially(Store& store, ObjectId a, ObjectId b) {
    if (auto wrong = refuseWire(store, a, b)) {
        return wrong;
    }
    layWire(store, a, b);
    return std::nullopt;
}

} // namespace trembler
