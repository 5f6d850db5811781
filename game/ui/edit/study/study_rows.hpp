// The rows that both pages about the level have.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/edit/study/background_work.hpp"

#include <string>

namespace trembler::ui {

/// A button that begins work, or stops it while it runs; below it the current step, with a bar, and whether
/// the work failed. `item` names the button in the layout. True when it is pressed.
[[nodiscard]] bool drawWorkButton(EditParts& parts, AnyWork const* work, char const* label, char const* tip,
                                  std::string const& item);
/// Says that the results below are of an older state of the level, or incomplete because they were stopped.
/// Nothing if neither holds.
void drawStateOfWork(bool older, bool stopped);
/// Wrapped text in the small font.
void studyText(std::string const& text);
/// A name at the left and a value at the right of the line.
void valueRow(std::string const& name, std::string const& value);

} // namespace trembler::ui
