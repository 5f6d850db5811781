// Widgets for the parameters of scripts, made from the scripts' statements about them.
#pragma once

#include "game/ui/shared/layout.hpp"
#include "lua/interaction/manifest.hpp"

#include <optional>
#include <string>

namespace trembler::ui {

/// Draws one line: the parameter's name, and a slider (a number with a range), a field to drag (a number
/// without one), a tick box, two fields (a vector), a drop-down (a text with choices) or a field to type
/// into. Returns the value that the player sets in this picture; it always is one that the parameter may
/// have. `item` names the widget in the layout. Between Gui::beginFrame and endFrame, inside a card.
[[nodiscard]] std::optional<lua::Value> parameterWidget(Layout& layout, lua::Parameter const& parameter,
                                                        lua::Value const& value, std::string const& item);

/// A name of a file as people read it: "half_angle" becomes "half angle".
[[nodiscard]] std::string spokenName(std::string name);
/// The value in words: "12", "yes", "1, 0", "red"; without its unit.
[[nodiscard]] std::string valueInWords(lua::Value const& value);

} // namespace trembler::ui
