// The rows of the report about one recorded solution.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "insight/report/level_report.hpp"

#include <cstddef>

namespace trembler::ui {

/// A row that can be chosen; when it is, it shows the solution's needs and the places where its parts may
/// lie. `index` is that in the report.
void drawReportedSolution(EditParts& parts, insight::LevelReport const& report, std::size_t index);

} // namespace trembler::ui
