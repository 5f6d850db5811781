// The single entries of a recorded solution, each with a form.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

#include <string>

namespace trembler::ui {

/// Placements, wires, inputs and changes of accuracy: to change, add, remove and order. `stated` is the
/// solution as the file has it. Between Gui::beginFrame and endFrame, on a page of the panel.
void drawSolutionEntries(EditParts& parts, std::string const& solution, edit::Json const& stated);

} // namespace trembler::ui
