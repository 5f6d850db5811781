// The scripts that an object names: 7.1.1's "'Scripts' property that would be a set of interaction scripts
// that act on this object".
#pragma once

#include "runtime/property/description.hpp"

#include <string>
#include <vector>

namespace trembler::lua {

/// A parameter of a script as an object states it. Which of the fields counts is the parameter's kind.
struct ScriptSetting {
    std::string parameter;
    double number = 0;
    Vec2 vector{};
    bool on = false;
    std::string text{};

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "param", .unit = "", .meaning = "name of the parameter", .required = true},
              self.parameter);
        visit(FieldInfo{.key = "number",
                        .unit = "",
                        .meaning = "its value, if it is a number, in the unit that the script states",
                        .minimum = -1e300,
                        .maximum = 1e300},
              self.number);
        visit(FieldInfo{.key = "vector",
                        .unit = "",
                        .meaning = "its value, if it is a vector",
                        .minimum = -1e300,
                        .maximum = 1e300,
                        .geometry = FieldGeometry::invariant},
              self.vector);
        visit(FieldInfo{.key = "on", .unit = "", .meaning = "its value, if it is true or false"}, self.on);
        visit(FieldInfo{.key = "text", .unit = "", .meaning = "its value, if it is a text"}, self.text);
    }
    friend bool operator==(ScriptSetting const&, ScriptSetting const&) = default;
};

/// A script that acts on the object.
struct ScriptUse {
    std::string script;
    std::vector<ScriptSetting> settings;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "script",
                        .unit = "",
                        .meaning = "name of the interaction, such as \"Dynamics <- Wind\"",
                        .required = true},
              self.script);
        visit(FieldInfo{.key = "set",
                        .unit = "",
                        .meaning = "parameters that differ from the script's defaults"},
              self.settings);
    }
    friend bool operator==(ScriptUse const&, ScriptUse const&) = default;
};

struct Scripts {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Scripts", "scripts",
                                       "The scripted interactions that act on the object."};
    std::vector<ScriptUse> uses;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "", .meaning = "each script once"}, self.uses);
    }
};

} // namespace trembler::lua
