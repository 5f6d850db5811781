// What Ctrl+P finds besides commands: parts, which are then in the hand, and kinds of joints.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

#include <vector>

namespace trembler::ui {

[[nodiscard]] std::vector<PaletteEntry> partsAndJoints(EditParts const& parts);
/// `entry`: one of these.
void takeFound(EditParts& parts, PaletteEntry const& entry);

} // namespace trembler::ui
