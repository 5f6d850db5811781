// The functions behind the editor's commands, and when they are available.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "puzzle/edit/commands/shapes.hpp"
#include "runtime/math/vec2.hpp"

#include <filesystem>
#include <string>

namespace trembler::ui::actions {

// Files and the program.
void newLevel(EditParts& parts);
void openLevel(EditParts& parts);
void save(EditParts& parts);
void saveAs(EditParts& parts);
/// Saves to the path, or to the document's own file if it is empty; reports the result to the designer.
bool saveTo(EditParts& parts, std::filesystem::path const& path, edit::LevelDocument::Overwrite overwrite);
/// Saves if there is a file; else opens the browser and returns false.
bool saveNow(EditParts& parts);
void showPalette(EditParts& parts);
void openMenu(EditParts& parts);
void back(EditParts& parts);
void switchFullscreen(EditParts& parts);
/// Does it at once, or after asking for unsaved changes.
void leaveFor(EditParts& parts, std::function<void(EditParts&)> const& then);

// Test play.
void testPlay(EditParts& parts);
/// Plays a recorded solution; with `again` the new recording replaces it.
void playSolution(EditParts& parts, std::string const& name, bool again);
/// Plays a run that need not be recorded in the level.
void playRun(EditParts& parts, Solution const& solution);
void endTest(EditParts& parts);
void recordSolution(EditParts& parts);
[[nodiscard]] bool isTesting(EditParts const& parts);

// Finding out about the level, beside the designer's work.
/// Shows the page, and makes the report again or, while it is made, stops it.
void makeReport(EditParts& parts);
void measureCosts(EditParts& parts);
/// Shows the page, and begins the search, or stops it.
void searchSolutions(EditParts& parts);
/// Adds a solution that the search has found to the level, by its number from 0.
void keepFound(EditParts& parts, std::size_t found);
[[nodiscard]] bool isReporting(EditParts const& parts);
[[nodiscard]] bool isSearching(EditParts const& parts);
/// The document's text without the editor's own data, and without recorded solutions, which a search ignores.
/// Equal texts: the same level.
[[nodiscard]] std::string const& stateOf(EditParts const& parts, bool withSolutions);

// Changes.
void undo(EditParts& parts);
void redo(EditParts& parts);
[[nodiscard]] bool canUndo(EditParts const& parts);
[[nodiscard]] bool canRedo(EditParts const& parts);
void cut(EditParts& parts);
void copy(EditParts& parts);
void paste(EditParts& parts);
void duplicate(EditParts& parts);
void deleteSelected(EditParts& parts);
void selectAll(EditParts& parts);
/// The next object, and after the last one joints, connections and areas.
void selectNext(EditParts& parts);
/// Adds the next object to the selection.
void selectAlso(EditParts& parts);
void askPartName(EditParts& parts);
/// Writes the selected objects as a part into the folder of the designer's own; `putHere`: it replaces them.
void makePart(EditParts& parts, std::string const& name, bool putHere);
[[nodiscard]] bool hasSelection(EditParts const& parts);
[[nodiscard]] bool hasSeveral(EditParts const& parts);
[[nodiscard]] bool hasThree(EditParts const& parts);
[[nodiscard]] bool canDelete(EditParts const& parts);
[[nodiscard]] bool canPaste(EditParts const& parts);
[[nodiscard]] bool canMakePart(EditParts const& parts);
[[nodiscard]] bool canScale(EditParts const& parts);
[[nodiscard]] bool canMove(EditParts const& parts);

// Arranging.
void move(EditParts& parts, Vec2 steps);
void rotate(EditParts& parts, int steps);
/// Turns the selected objects; corners on the grid stay on it, unless snapping is off.
[[nodiscard]] edit::Command rotation(EditParts const& parts, edit::Json const& level, double degrees,
                                     Vec2 centre);
void resize(EditParts& parts, double factor);
void mirrorAcross(EditParts& parts);
void mirrorDown(EditParts& parts);
void alignTo(EditParts& parts, Alignment alignment);
void distributeAlong(EditParts& parts, bool sideways);
void group(EditParts& parts);
void ungroup(EditParts& parts);
void lock(EditParts& parts);
void unlockAll(EditParts& parts);
void hide(EditParts& parts);
void showAll(EditParts& parts);

template <int x, int y>
void nudge(EditParts& parts) {
    move(parts, {x, y});
}
template <int steps>
void turn(EditParts& parts) {
    rotate(parts, steps);
}
template <int steps>
void scale(EditParts& parts) {
    resize(parts, steps > 0 ? 1.1 : 1 / 1.1);
}
template <Alignment alignment>
void align(EditParts& parts) {
    alignTo(parts, alignment);
}
template <bool sideways>
void distribute(EditParts& parts) {
    distributeAlong(parts, sideways);
}

// Tools.
/// Takes the tool; one that is in the hand already makes its thing in the middle of the view.
void take(EditParts& parts, Tool tool);
/// Adds a wooden object with a drawn shape; its name is `name` if that is free.
[[nodiscard]] edit::Command shapeCommand(edit::Json const& level, edit::DrawnShape const& drawn,
                                         std::string const& name);
void addDrawn(EditParts& parts, std::function<edit::Command(edit::Json const&)> const& make);
/// Puts the part at a place.
void addPart(EditParts& parts, std::string const& part, Vec2 at);
void joinObjects(EditParts& parts, std::string const& a, std::string const& b, Vec2 at, Vec2 atB);
void connectObjects(EditParts& parts, std::string const& a, std::string const& b);
void addArea(EditParts& parts, Tool tool, Area const& area);

template <Tool tool>
void pick(EditParts& parts) {
    take(parts, tool);
}
template <Tool tool>
[[nodiscard]] bool isTool(EditParts const& parts) {
    return parts.tool == tool;
}

// Looking.
void frameSelection(EditParts& parts);
void frameAll(EditParts& parts);
void zoomBy(EditParts& parts, int notches);
template <int notches>
void zoom(EditParts& parts) {
    zoomBy(parts, notches);
}
/// Moves the view by tenths of the window.
void lookBy(EditParts& parts, int right, int up);
template <int right, int up>
void look(EditParts& parts) {
    lookBy(parts, right, up);
}
void switchSnap(EditParts& parts);
void switchNames(EditParts& parts);
void switchElectricity(EditParts& parts);
[[nodiscard]] bool snaps(EditParts const& parts);
[[nodiscard]] bool showsNames(EditParts const& parts);
[[nodiscard]] bool showsElectricity(EditParts const& parts);
void focusPanel(EditParts& parts);
template <Tab tab>
void showTab(EditParts& parts) {
    parts.tab = tab;
}
template <Tab tab>
[[nodiscard]] bool isTab(EditParts const& parts) {
    return parts.tab == tab;
}

} // namespace trembler::ui::actions
