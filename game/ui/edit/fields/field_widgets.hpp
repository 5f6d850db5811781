// Widgets for fields of properties, made from their descriptions.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/edit/fields/number_field.hpp"
#include "puzzle/edit/inspect/inspector.hpp"

#include <functional>
#include <optional>
#include <string>

namespace trembler::ui {

/// The name of a field, and one of the values that it may have, in the language in use.
[[nodiscard]] std::string shownField(std::string const& name);
[[nodiscard]] std::string shownChoice(std::string const& choice);
/// A name on the left, with a tip; the widget that follows takes the rest of the line.
void fieldName(std::string const& name, std::string const& help);
/// A text that is taken when the field is left or Enter is pressed; true in that picture. `lines` above 1: a
/// larger field.
[[nodiscard]] bool committedText(EditParts& parts, std::string const& item, std::string& text,
                                 float lines = 1);
/// One of several texts, shown as they are or in words; for "" `none` is shown. True when another one was
/// chosen.
[[nodiscard]] bool choiceField(EditParts& parts, std::string const& item, std::string& chosen,
                               std::vector<std::string> const& choices,
                               std::function<std::string(std::string const&)> const& inWords = {},
                               char const* none = "–");

/// The field's widget; the value that the designer gives it in this picture, in the form of files. Lists are
/// not drawn.
[[nodiscard]] std::optional<edit::Json> fieldWidget(EditParts& parts, edit::InspectedField const& field,
                                                    std::string const& item);
/// Whether its widget is dragged, and so changes the value many times in one gesture.
[[nodiscard]] bool isContinuous(edit::InspectedField const& field);
/// Runs a command made by a widget: the changes of one widget in use are one step of undo.
void runWidget(EditParts& parts, std::function<edit::Command(edit::Json const&)> const& make,
               bool continuous);

/// Numbers of an area: of a box its place and size, of a polygon its corners. The area with the numbers that
/// the designer gives it in this picture.
[[nodiscard]] std::optional<Area> areaFields(EditParts& parts, Area const& area, std::string const& item);

} // namespace trembler::ui
