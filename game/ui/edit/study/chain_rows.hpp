// Why recorded solutions meet the goals, and how their kinds differ, in the editor's report.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "insight/report/level_report.hpp"

namespace trembler::ui {

/// The chain of causes of each goal, as sentences.
void drawChains(EditParts& parts, insight::SolutionReport const& solution);
/// For each kind from the second on, its differences from the kind nearest to it.
void drawComparisons(EditParts& parts, insight::LevelReport const& report);

} // namespace trembler::ui
