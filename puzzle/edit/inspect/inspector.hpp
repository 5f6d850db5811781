// The inspector without a window: the properties of one or many objects, made from their descriptions.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/level/property/field_outline.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::edit {

/// Where the shown value of a property comes from.
enum class ValueOrigin {
    own,     ///< the object states it, and its part does not
    changed, ///< the object states it in place of its part's: can be reset
    part,    ///< the part states it, or the placement's initial value
    removed, ///< the object states that it does not have it (`false`), though its part has
    mixed,   ///< differs among the objects
};

/// One field of a property, ready to be shown and edited. Values have the form and unit of files: degrees.
struct InspectedField {
    std::string place; ///< a JSON pointer inside the property, as setField() takes it; "" for a bare one
    std::string name;  ///< for people: "Motor speed"
    std::string unit;  ///< of the value as shown: "m", "°", "°/s"; empty for none
    std::string help;
    FieldType type = FieldType::number;
    std::vector<std::string> choices{}; ///< of a choice, and the level's names for an object
    double minimum = 0;                 ///< of numbers, whole numbers and vectors, in the shown unit
    double maximum = 0;
    bool minimumExcluded = false;
    bool required = false; ///< has no initial value
    bool stated = false;   ///< the file states it; else `value` is the initial one
    bool mixed = false;    ///< the objects' values differ; `value` is then the first one's
    Json value{};
    Json initial{}; ///< its value if it is not stated; null if required
    /// Of a list: the entries, each as a field whose own `entries` are the fields of the entry; a list of
    /// bare values has one field per value. Empty if the lists of several objects differ in length.
    std::vector<InspectedField> entries{};
};

struct InspectedProperty {
    std::string key;
    std::string name;
    std::string help;
    PropertyPlace place = PropertyPlace::properties;
    ValueOrigin origin = ValueOrigin::own;
    bool onAll = true;      ///< whether all the objects have it
    bool canReset = false;  ///< resetProperty() would change something
    bool canRemove = false; ///< removeProperty() would change something
    bool marker = false;    ///< it has no fields: it is there or not
    std::vector<InspectedField> fields{};
};

/// A property that could be added.
struct AddableProperty {
    std::string key;
    std::string name;
    std::string help;
};

/// A piece of objects that are made from composite parts.
struct InspectedPiece {
    std::string name;    ///< as "pieces" of their entries states it
    bool main = false;   ///< without a statement of its own, the objects' own properties are about it
    bool stated = false; ///< the entry of at least one of them states something about it
};

/// The properties of objects: first those of placement, then the others by name. Values that cannot be read
/// are left out (they are problems). Unknown objects are ignored. An object made from a composite part has
/// those of its main piece. With a name from inspectPieces(), the properties of that piece of each object.
[[nodiscard]] std::vector<InspectedProperty> inspectObjects(GameData const& data, Json const& level,
                                                            std::vector<std::string> const& names,
                                                            std::string const& piece = {});
/// The properties that at least one of the objects, or of their pieces, does not have, by name.
[[nodiscard]] std::vector<AddableProperty> addableProperties(GameData const& data, Json const& level,
                                                             std::vector<std::string> const& names,
                                                             std::string const& piece = {});
/// The pieces that all the objects have or state something about, by name; also pieces that their parts do
/// not have, which are problems.
[[nodiscard]] std::vector<InspectedPiece> inspectPieces(GameData const& data, Json const& level,
                                                        std::vector<std::string> const& names);
/// The properties of the world, stated or not, by name; setWorldField() changes them.
[[nodiscard]] std::vector<InspectedProperty> inspectWorld(GameData const& data, Json const& level);
/// The fields of a joint that its form has; setJointField() changes them. Empty if there is no such joint.
[[nodiscard]] std::vector<InspectedField> inspectJoint(GameData const& data, Json const& level,
                                                       std::size_t joint);

} // namespace trembler::edit
