// The fields of an object that can be set while it runs.
#pragma once

#include "insight/whatif/change.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/world/world.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace trembler::insight {

struct SettableField {
    PropertyInfo const* property = nullptr;
    std::string key;
    std::string unit; ///< SI, angles in rad
    std::string meaning;
    FieldType type = FieldType::number; ///< boolean, integer, number, vector or choice
    double least = 0;
    double most = 0;
    std::vector<std::string_view> choices; ///< of a choice: its names
    FieldAmount now;
};

/// The fields of an object of a running world that some component at work reads: setting one changes what
/// follows. Places are left out, as objects are moved; and texts, lists and references to objects. In order
/// of the properties' keys.
[[nodiscard]] std::vector<SettableField> settableFields(World const& world, ObjectId object);

/// Sets a field, clamped to its range; between frames. `rules` are those of files: if the object breaks one
/// with the new value, the old one stays. False if nothing was set: it has no such field, or a rule forbids
/// it. A value that it has already is not written.
bool setField(World& world, std::span<ObjectRule const> rules, ObjectId object, std::string_view property,
              std::string_view field, FieldAmount const& amount);

} // namespace trembler::insight
