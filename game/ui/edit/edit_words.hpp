// The editor's texts, in one place and in British English; the names of commands are in their table.
#pragma once

#include <string>

namespace trembler::ui::words {

// Files.
inline constexpr char const* openTitle = "Open a level";
inline constexpr char const* saveAsTitle = "Save the level as";
inline constexpr char const* fileName = "Name";
inline constexpr char const* openFile = "Open";
inline constexpr char const* saveFile = "Save";
inline constexpr char const* replaceIt = "Replace it";
inline constexpr char const* cancel = "Cancel";
inline constexpr char const* parentFolder = "..  (the folder above)";
inline constexpr char const* newLevel = "New level";
[[nodiscard]] inline std::string cannotReadFolder(std::string const& folder, std::string const& why) {
    return "The folder " + folder + " cannot be read: " + why;
}
[[nodiscard]] inline std::string noSuchFile(std::string const& name) {
    return "There is no file \"" + name + "\" here.";
}
[[nodiscard]] inline std::string replaceFile(std::string const& name) {
    return "There is a file \"" + name + "\" already. Replace it?";
}
[[nodiscard]] inline std::string savedTo(std::string const& name) {
    return "Saved: " + name;
}
inline constexpr char const* unsavedTitle = "Save your changes?";
inline constexpr char const* unsavedText = "This level has changes that are in no file yet.";
inline constexpr char const* saveAndGo = "Save";
inline constexpr char const* dropChanges = "Do not save";
inline constexpr char const* recoveryTitle = "Bring your work back?";
inline constexpr char const* recoveryText =
    "The editor ended without saving. What you last did is kept, and can be brought back.";
inline constexpr char const* recover = "Bring it back";
inline constexpr char const* forgetRecovery = "Forget it";
inline constexpr char const* readOnlyTitle = "Only to look at";
inline constexpr char const* readOnly = "Read-only: the file has errors, or is from a newer version";
inline constexpr char const* understood = "Look at it";
inline constexpr char const* editNevertheless = "Edit it nevertheless";
inline constexpr char const* later = "Later";
inline constexpr char const* conflictTitle = "Replace the file?";
inline constexpr char const* makePartTitle = "Make a part";
inline constexpr char const* makePartText =
    "The selected objects become a part with this name, for this and other levels. The first one that was "
    "selected is its main object.";
inline constexpr char const* makePart = "Make the part";
inline constexpr char const* makePartHere = "Make it and put it in their place";

// Panels.
inline constexpr char const* tabParts = "Parts";
inline constexpr char const* tabOutline = "Outline";
inline constexpr char const* tabProperties = "Properties";
inline constexpr char const* tabGoals = "Goals";
inline constexpr char const* tabLevel = "Level";
inline constexpr char const* tabSolutions = "Solutions";
inline constexpr char const* tabProblems = "Problems";
inline constexpr char const* search = "Search";
inline constexpr char const* nothingFound = "No part is called that.";
inline constexpr char const* nothingSelected =
    "Nothing is selected. Click an object, or drag a box around several.";
inline constexpr char const* noProblems = "Nothing is wrong with this level.";
inline constexpr char const* severalValues = "several values";
inline constexpr char const* objectsHeading = "Objects";
inline constexpr char const* jointsHeading = "Joints";
inline constexpr char const* connectionsHeading = "Wires and other connections";
inline constexpr char const* addProperty = "Add a property …";
inline constexpr char const* resetTip = "Back to the value of the part";
inline constexpr char const* removeTip = "Without it";

inline constexpr char const* commandsTitle = "All commands";

inline constexpr char const* lockedMark = "  (locked)";
inline constexpr char const* hiddenMark = "  (hidden)";
inline constexpr char const* nameField = "Name";
inline constexpr char const* partField = "Part";
inline constexpr char const* partFieldTip =
    "The part that it is made from; its own properties take precedence";
inline constexpr char const* severalObjects = "%zu objects";
inline constexpr char const* fromField = "From";
inline constexpr char const* toField = "To";
inline constexpr char const* kindField = "Kind";
inline constexpr char const* kindFieldTip = "Such as \"wire\"; empty: it follows from the objects";
inline constexpr char const* cornerField = "Corner";
inline constexpr char const* sizeField = "Size";
inline constexpr char const* reset = "reset";
inline constexpr char const* removeShort = "×";
inline constexpr char const* removeIt = "Remove";
inline constexpr char const* addEntry = "Add one more";
inline constexpr char const* upIt = "Up";
inline constexpr char const* fromPart = "As the part states it";
inline constexpr char const* takenAway = "Taken away, though the part has it";
inline constexpr char const* scriptsHeading = "Scripts";
inline constexpr char const* addScript = "Add a script …";

// Goals.
inline constexpr char const* noGoals = "There is no goal yet.";
inline constexpr char const* addGoal = "Add a goal";
inline constexpr char const* forSeconds = "For";
inline constexpr char const* forSecondsTip = "How long it must hold without a break; 0: a moment is enough";
inline constexpr char const* goalId = "Id";
inline constexpr char const* goalText = "Text";
inline constexpr char const* goalTextTip = "Left empty, it is made from the condition";
inline constexpr char const* wrapTip = "Put this goal inside";
inline constexpr char const* unwrap = "Unwrap";
inline constexpr char const* unwrapTip = "Put the only inner goal in its place";

// Level.
inline constexpr char const* textsHeading = "Texts";
inline constexpr char const* titleField = "Title";
inline constexpr char const* storyField = "Text before the level";
inline constexpr char const* demonstrationField = "Demonstration: solves itself";
inline constexpr char const* hintsHeading = "Hints";
inline constexpr char const* addHint = "Add a hint";
inline constexpr char const* newHint = "A hint";
inline constexpr char const* toolboxHeading = "Toolbox";
inline constexpr char const* addToolTip = "Add a part to the player's toolbox";
inline constexpr char const* worldHeading = "World";
inline constexpr char const* boundsField = "Bounds";
inline constexpr char const* boundsTip = "Left and lower edge; width and height";
inline constexpr char const* noBounds = "Without bounds";
inline constexpr char const* giveBounds = "Give it bounds";
inline constexpr char const* anywhere = "Parts may be placed anywhere";
inline constexpr char const* anywhereTip = "Remove all placing areas";
inline constexpr char const* detailHeading = "Detail";
inline constexpr char const* detailTip = "How exactly the effect is computed; –: the scene decides";
inline constexpr char const* modsHeading = "Mods";
inline constexpr char const* modsTip = "Mods count once the level is saved and opened again.";

// Solutions.
inline constexpr char const* noSolutions = "No run is recorded yet. Test the level, solve it, and record it.";
inline constexpr char const* solvesLevel = "must solve the level";
inline constexpr char const* watch = "Watch";
inline constexpr char const* watchTip = "Play this run";
inline constexpr char const* again = "Re-record";
inline constexpr char const* againTip = "Play with these parts; what you then record replaces this run";
inline constexpr char const* recordNew = "Play to record a new one";
inline constexpr char const* recordNewTip =
    "Play the level; the button at the lower right records what you did";

// Tools.
inline constexpr char const* gridStep = "Grid";
inline constexpr char const* angleStep = "Angle";
inline constexpr char const* radius = "Radius";
inline constexpr char const* jointField = "Joint";
inline constexpr char const* toolSettings = "Drawing";
inline constexpr char const* numberTip = "Drag, or double-click to type a number";
inline constexpr char const* snapTip = "Snap places and angles to the grid";
inline constexpr char const* readOnlyShort = "read-only";
inline constexpr char const* notSaved = "not saved yet";
inline constexpr char const* allSaved = "saved";
inline constexpr char const* testBack = "Back to the editor";
inline constexpr char const* playing = "Test play";
inline constexpr char const* recordIt = "Record as a solution";
inline constexpr char const* recordAgainIt = "Record it again";
inline constexpr char const* runFirst = "Run it first: what is recorded is what you placed and did.";
inline constexpr char const* newSolution = "solution";
inline constexpr char const* recordedSolved = "Recorded: a solution that solves the level";
inline constexpr char const* recordedUnsolved = "Recorded: a run that does not solve the level";
inline constexpr char const* selectTwo = "Select the two objects first, or drag from one to the other.";
inline constexpr char const* selectForGoal = "Select the object that is to come there first.";
[[nodiscard]] inline std::string cannotTest(std::string const& why) {
    return "This cannot be played yet: " + why;
}
[[nodiscard]] inline std::string undone(std::string const& name) {
    return "Undone: " + name;
}
[[nodiscard]] inline std::string redone(std::string const& name) {
    return "Redone: " + name;
}
[[nodiscard]] inline std::string partMade(std::string const& name, std::string const& file) {
    return "The part \"" + name + "\" is in " + file;
}

} // namespace trembler::ui::words
