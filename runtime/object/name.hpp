// The name of an object, by which people, files and traces refer to it.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

struct Name {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Name", "name", "The name of the object, unique in its world.",
                                       PropertyPlace::placement};
    std::string value;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "", .meaning = "unique name", .required = true}, self.value);
    }
};

} // namespace trembler
