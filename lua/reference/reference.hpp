// Everything that scripts can read and call, gathered from the descriptions of a registry: for the reference
// page and for editors.
#pragma once

#include "runtime/component/role_info.hpp"
#include "runtime/world/registry.hpp"

#include <string>
#include <vector>

namespace trembler::lua {

/// A field of a property, of an entry in a list, or an argument of a function.
struct ReferenceField {
    FieldInfo info;
    FieldKind kind = FieldKind::number;
    std::vector<std::string> choices{};  ///< of a choice: its values
    bool entriesHaveFields = false;      ///< of a list; otherwise its entries are values
    std::vector<ReferenceField> entry{}; ///< of a list: the fields of an entry, or the one value
    std::string initial{};               ///< of an argument that can be left out: its value then
};

enum class PropertyHome {
    objects, ///< object.Mass
    world,   ///< world.Gravity: of the object "world"; nil where a level states none
    state,   ///< world.contacts: of a resolver or a derived property set
};

struct ReferenceProperty {
    PropertyInfo const* info = nullptr;
    PropertyHome home = PropertyHome::objects;
    std::vector<std::string> offeredBy{}; ///< names of the components that compute it
    std::vector<ReferenceField> fields{};
    std::string body{};    ///< an example: the body of apply, without indentation
    std::string example{}; ///< the script around it
};

struct ReferenceFunction {
    RoleInfo const* role = nullptr;
    CallDescription const* call = nullptr;
    std::vector<ReferenceField> arguments{};
    std::string example{}; ///< a script
};

struct Reference {
    std::vector<ReferenceProperty> properties; ///< of objects first, in order of registration
    std::vector<ReferenceFunction> functions;  ///< by resolver, in order of registration
};

/// All properties that scripts can read and all functions that they can call. The registry must live as long
/// as the result.
[[nodiscard]] Reference makeReference(Registry const& registry);

/// "object.Mass", "world.Gravity", "world[\"F_G\"]": how a script reaches a property.
[[nodiscard]] std::string expressionOf(ReferenceProperty const& property);
/// `of` and a field of it, as Lua: "shape.form", or "shape[\"repeat\"]" if the name is a keyword of Lua.
[[nodiscard]] std::string memberOf(std::string_view of, std::string_view name);
/// The name by which examples declare a property: its name if that needs no quotes, else its key.
[[nodiscard]] std::string_view scriptName(PropertyInfo const& info);
/// "number", "vec2", "one of a, b": the type of a value that a script reads or states.
[[nodiscard]] std::string kindText(ReferenceField const& field);
/// "0 to 60", "above 0", "" if it is not limited.
[[nodiscard]] std::string rangeText(ReferenceField const& field);

} // namespace trembler::lua
