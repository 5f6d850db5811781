// Values of a script's parameters: the allowed values, and the values that objects state.
#pragma once

#include "lua/attach/scripts_property.hpp"
#include "lua/interaction/manifest.hpp"

#include <optional>
#include <string>

namespace trembler::lua {

/// The fault of a value of a parameter, in words: another kind, out of range, not finite, a text that
/// is too long or none of the choices. Nothing if it is right.
[[nodiscard]] std::optional<std::string> faultOf(Parameter const& parameter, Value const& value);

/// The value that a setting states, of the kind that the parameter has.
[[nodiscard]] Value valueOf(ScriptSetting const& setting, Parameter const& parameter);
/// The setting that states a value.
[[nodiscard]] ScriptSetting settingOf(std::string const& parameter, Value const& value);
/// The value for an object: the one that it states, else the script's default. `use` may be nullptr.
[[nodiscard]] Value valueFor(ScriptUse const* use, Parameter const& parameter);

} // namespace trembler::lua
