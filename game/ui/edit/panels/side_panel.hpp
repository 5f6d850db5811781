// The panel at the right: its pages are the parts, the outline, properties, goals, texts, solutions, the
// report on the level, the search for other solutions, problems.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

namespace trembler::ui {

/// Events in the panel that other parts of the editor must react to.
struct PanelUse {
    bool tookPart = false; ///< a part of the catalogue was pressed, and may be dragged out
};

/// Between Gui::beginFrame and endFrame.
[[nodiscard]] PanelUse drawSidePanel(EditParts& parts, CommandSet const& commands);

// The pages; each draws inside the panel.
[[nodiscard]] bool drawPartsPage(EditParts& parts);
void drawOutlinePage(EditParts& parts);
void drawPropertiesPage(EditParts& parts);
void drawGoalsPage(EditParts& parts);
/// A card with the tree of goals and their states, while the level is test-played; `top` in pixels at UI
/// scale 1.
void drawLiveGoals(EditParts& parts, float top);
void drawLevelPage(EditParts& parts);
/// The section of the level's page about the first lesson.
void drawTeachingSteps(EditParts& parts);
/// The section about the level's texts in other languages.
void drawTranslations(EditParts& parts);
void drawSolutionsPage(EditParts& parts);
/// The pages of the level's studies, see study/.
void drawReportPage(EditParts& parts);
void drawSearchPage(EditParts& parts);
void drawProblemsPage(EditParts& parts);

} // namespace trembler::ui
