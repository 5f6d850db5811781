#include "lua/attach/parameter_value.hpp"

#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::lua {

std::optional<std::string> faultOf(Parameter const& parameter, Value const& value) {
    if (value.index() != parameter.initial.index()) {
        return fmt::format("{}; expected {}", kindOf(value), kindOf(parameter.initial));
    }
    if (!isFinite(value)) {
        return std::string("not finite; expected a finite number");
    }
    if (double const* const number = std::get_if<double>(&value)) {
        if (!(*number >= parameter.minimum && *number <= parameter.maximum)) {
            return fmt::format("{} {}; expected \"number\" from {} to {}", *number, parameter.unit,
                               parameter.minimum, parameter.maximum);
        }
    }
    if (std::string const* const text = std::get_if<std::string>(&value)) {
        if (text->size() > longestText) {
            return fmt::format("a text of {} bytes; expected at most {}", text->size(), longestText);
        }
        auto const& choices = parameter.choices;
        if (!choices.empty() && std::find(choices.begin(), choices.end(), *text) == choices.end()) {
            return fmt::format("'{}'; expected {}", *text, listed(choices));
        }
    }
    return std::nullopt;
}

Value valueOf(ScriptSetting const& setting, Parameter const& parameter) {
    switch (parameter.initial.index()) {
    case 0:
        return setting.on;
    case 1:
        return setting.number;
    case 2:
        return setting.vector;
    default:
        return setting.text;
    }
}

ScriptSetting settingOf(std::string const& parameter, Value const& value) {
    ScriptSetting made;
    made.parameter = parameter;
    if (bool const* const on = std::get_if<bool>(&value)) {
        made.on = *on;
    } else if (double const* const number = std::get_if<double>(&value)) {
        made.number = *number;
    } else if (Vec2 const* const vector = std::get_if<Vec2>(&value)) {
        made.vector = *vector;
    } else {
        made.text = std::get<std::string>(value);
    }
    return made;
}

Value valueFor(ScriptUse const* use, Parameter const& parameter) {
    if (use != nullptr) {
        auto const at =
            std::find_if(use->settings.begin(), use->settings.end(),
                         [&](ScriptSetting const& setting) { return setting.parameter == parameter.name; });
        if (at != use->settings.end()) {
            return valueOf(*at, parameter);
        }
    }
    return parameter.initial;
}

} // namespace trembler::lua
