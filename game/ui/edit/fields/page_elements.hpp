// Buttons and headings of the editor's pages.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace trembler::ui {

/// A small button with words; named `item` in the layout.
[[nodiscard]] bool smallButton(EditParts& parts, char const* label, std::string const& item,
                               char const* tip = nullptr);
/// Two arrows that move an entry of a list, in a row with the element that was drawn last: the place to which
/// the designer moves it in this picture. They are called `item` "up" and "down" in the layout.
[[nodiscard]] std::optional<std::size_t> orderArrows(EditParts& parts, std::string const& item,
                                                     std::size_t index, std::size_t count);
/// The width of both with the gaps before them, pixels.
[[nodiscard]] float orderArrowsWidth();
/// The small button with this label, which follows, comes beside the last widget if there is room; else
/// below.
void besideIfRoom(char const* label);
void pageHeading(char const* text);

} // namespace trembler::ui
