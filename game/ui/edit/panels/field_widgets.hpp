// Widgets for fields of properties, made from their descriptions.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "puzzle/edit/inspect/inspector.hpp"

#include <optional>
#include <string>

namespace trembler::ui {

/// A name on the left, with a tip; the widget that follows takes the rest of the line.
void fieldName(std::string const& name, std::string const& help);
/// A text that is taken when the field is left or Enter is pressed; true in that picture. `lines` above 1: a
/// larger field.
[[nodiscard]] bool committedText(EditParts& parts, std::string const& item, std::string& text,
                                 float lines = 1);
/// A number to drag or type. True while it changes; EditParts::widget is then the gesture of its changes.
[[nodiscard]] bool numberField(EditParts& parts, std::string const& item, double& value, double low,
                               double high, std::string const& unit, bool whole = false);
/// One of several texts. True when another one was chosen.
[[nodiscard]] bool choiceField(EditParts& parts, std::string const& item, std::string& chosen,
                               std::vector<std::string> const& choices);

/// The field's widget; the value that the designer gives it in this picture, in the form of files. Lists are
/// not drawn.
[[nodiscard]] std::optional<edit::Json> fieldWidget(EditParts& parts, edit::InspectedField const& field,
                                                    std::string const& item);
/// Runs a command made by a widget: the changes of one widget in use are one step of undo.
void runWidget(EditParts& parts, std::function<edit::Command(edit::Json const&)> const& make,
               bool continuous);

/// Numbers of an area: of a box its place and size, of a polygon its corners. The area with the numbers that
/// the designer gives it in this picture.
[[nodiscard]] std::optional<Area> areaFields(EditParts& parts, Area const& area, std::string const& item);

/// A small button with words; named `item` in the layout.
[[nodiscard]] bool smallButton(EditParts& parts, char const* label, std::string const& item,
                               char const* tip = nullptr);
/// The small button with this label, which follows, comes beside the last widget if there is room; else
/// below.
void besideIfRoom(char const* label);
void pageHeading(char const* text);

} // namespace trembler::ui
