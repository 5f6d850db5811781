// Parts by their titles and pictures, as the catalogue of parts has them.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// One of several parts, by their names; "" is none, for which `none` is shown. True when another one was
/// chosen.
[[nodiscard]] bool partChoice(EditParts& parts, std::string const& item, std::string& chosen,
                              std::vector<std::string> const& names, char const* none = "–");
/// As fieldName(): a part's picture and title on the left, and its description as a tip.
void partFieldName(EditParts& parts, std::string const& part);

} // namespace trembler::ui
