// Parts by their titles and pictures, as the catalogue of parts has them.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

#include <functional>
#include <string>
#include <vector>

namespace trembler::ui {

/// One of several parts, by their names; "" is none, for which `none` is shown. True when another one was
/// chosen.
[[nodiscard]] bool partChoice(EditParts& parts, std::string const& item, std::string& chosen,
                              std::vector<std::string> const& names, char const* none = "–");
/// Its title, with its description as a tip, above the widgets that `draw` draws, and its picture beside
/// both.
void partRow(EditParts& parts, std::string const& part, std::function<void()> const& draw);

} // namespace trembler::ui
