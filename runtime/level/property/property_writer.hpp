// Writing properties as files state them: the counterpart of property_reader.hpp.
#pragma once

#include "runtime/level/property/name_table.hpp"
#include "runtime/level/property/property_set.hpp"
#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

namespace trembler {

/// Turns a reference to an object into its name; "" for none.
using NameOf = std::string (*)(void const* names, ObjectId id);

/// The names by which object fields are written: those of a file's name table, or of a running world.
class ObjectNames {
public:
    /// No object field has a name.
    ObjectNames() = default;
    explicit ObjectNames(NameTable const& table);
    explicit ObjectNames(Store const& store);
    [[nodiscard]] std::string operator()(ObjectId id) const {
        return nameOf_ == nullptr ? std::string() : nameOf_(source_, id);
    }

private:
    void const* source_ = nullptr;
    NameOf nameOf_ = nullptr;
};

/// The JSON that readProperty() reads back as the same value. Fields that have their initial value are left
/// out, but for required ones. Numbers are written so that they read back bit for bit.
[[nodiscard]] nlohmann::ordered_json writeProperty(PropertyValue const& value, ObjectNames const& names = {});

/// An object with one member per property whose place is `place`; taken-away ones are `false`.
[[nodiscard]] nlohmann::ordered_json writeProperties(PropertySet const& set, PropertyPlace place,
                                                     ObjectNames const& names = {});

/// The property of one object in a running world, whole, with every field: for inspectors and dumps. Null if
/// the object does not have it.
[[nodiscard]] nlohmann::ordered_json writeColumn(ColumnBase const& column, ObjectId id,
                                                 ObjectNames const& names = {});

} // namespace trembler
