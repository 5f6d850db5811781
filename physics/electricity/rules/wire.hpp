// Which objects a wire of a level may connect.
#pragma once

#include "physics/electricity/rules/completion.hpp"
#include "runtime/world/store.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace trembler {

/// Whether an object conducts: as stated or, before its completion, because of its material.
[[nodiscard]] inline bool conducts(Store const& store, ObjectId id) {
    auto const* const conductors = store.findColumn<Conductor>();
    auto const* const made = store.findColumn<MadeOf>();
    auto const* const without = store.findColumn<Without>();
    return (conductors != nullptr && conductors->has(id)) ||
           conductsByMaterial(made == nullptr ? nullptr : made->find(id),
                              without == nullptr ? nullptr : without->find(id));
}

/// Why a wire cannot connect two objects and the expected condition, in words; nothing if it can.
[[nodiscard]] inline std::optional<std::string> refuseWire(Store const& store, ObjectId a, ObjectId b) {
    for (ObjectId const id : {a, b}) {
        if (!store.alive(id)) {
            return "one end of the connection is no object; expected two objects that conduct electricity";
        }
        if (!conducts(store, id)) {
            return fmt::format("'{}' is no conductor; expected two objects with the property '{}'",
                               store.nameOf(id), Conductor::text.key);
        }
    }
    if (a == b) {
        return fmt::format("'{}' is connected to itself; expected two different objects", store.nameOf(a));
    }
    return std::nullopt;
}

} // namespace trembler
