// The editor's texts, in one place and in British English, from which every other language is looked up:
// assets/text/LANGUAGE/editor.json. The names of commands are in their tables.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

namespace trembler::ui::words {

/// As said(), and counted among the editor's.
[[nodiscard]] char const* const& editWord(char const* english);
/// The English texts of all of them, for a test.
[[nodiscard]] std::vector<char const*> allEditWords();

/// A text with "{}" replaced by the arguments.
template <class... Arguments>
[[nodiscard]] std::string filledIn(char const* text, Arguments const&... arguments) {
    try {
        return fmt::format(fmt::runtime(text), arguments...);
    } catch (fmt::format_error const&) { // a test excludes it
        return text;
    }
}

// Menus.
inline char const* const& menuFile = editWord("File");
inline char const* const& menuEdit = editWord("Edit");
inline char const* const& menuArrange = editWord("Arrange");
inline char const* const& menuTools = editWord("Tools");
inline char const* const& menuView = editWord("View");

// Files.
inline char const* const& openTitle = editWord("Open a level");
inline char const* const& openSolutionTitle = editWord("Open a solution");
inline char const* const& saveAsTitle = editWord("Save the level as");
inline char const* const& fileName = editWord("Name");
inline char const* const& openFile = editWord("Open");
inline char const* const& saveFile = editWord("Save");
inline char const* const& replaceIt = editWord("Replace it");
inline char const* const& cancel = editWord("Cancel");
inline char const* const& parentFolder = editWord("..  (the folder above)");
inline char const* const& newLevel = editWord("New level");
inline char const* const& cannotReadFolderText = editWord("The folder {} cannot be read: {}");
[[nodiscard]] inline std::string cannotReadFolder(std::string const& folder, std::string const& why) {
    return filledIn(cannotReadFolderText, folder, why);
}
inline char const* const& noSuchFileText = editWord("There is no file \"{}\" here.");
[[nodiscard]] inline std::string noSuchFile(std::string const& name) {
    return filledIn(noSuchFileText, name);
}
inline char const* const& replaceFileText = editWord("There is a file \"{}\" already. Replace it?");
[[nodiscard]] inline std::string replaceFile(std::string const& name) {
    return filledIn(replaceFileText, name);
}
inline char const* const& savedToText = editWord("Saved: {}");
[[nodiscard]] inline std::string savedTo(std::string const& name) {
    return filledIn(savedToText, name);
}
inline char const* const& unsavedTitle = editWord("Save your changes?");
inline char const* const& unsavedText = editWord("This level has changes that are in no file yet.");
inline char const* const& saveAndGo = editWord("Save");
inline char const* const& dropChanges = editWord("Do not save");
inline char const* const& recoveryTitle = editWord("Bring your work back?");
inline char const* const& recoveryText =
    editWord("The editor ended without saving. What you last did is kept, and can be brought back.");
inline char const* const& recover = editWord("Bring it back");
inline char const* const& forgetRecovery = editWord("Forget it");
inline char const* const& readOnlyTitle = editWord("Only to look at");
inline char const* const& readOnly = editWord("Read-only: the file has errors, or is from a newer version");
inline char const* const& understood = editWord("Look at it");
inline char const* const& editNevertheless = editWord("Edit it nevertheless");
inline char const* const& takeLastGoodText = editWord("Take the last good version, {}");
[[nodiscard]] inline std::string takeLastGood(std::string const& file) {
    return filledIn(takeLastGoodText, file);
}
inline char const* const& later = editWord("Later");
inline char const* const& conflictTitle = editWord("Replace the file?");
inline char const* const& makePartTitle = editWord("Make a part");
inline char const* const& makePartText = editWord(
    "The selected objects become a part with this name, for this and other levels. The first one that was "
    "selected is its main object.");
inline char const* const& makePart = editWord("Make the part");
inline char const* const& makePartHere = editWord("Make it and put it in their place");

// Panels.
inline char const* const& tabParts = editWord("Parts");
inline char const* const& tabOutline = editWord("Outline");
inline char const* const& tabProperties = editWord("Properties");
inline char const* const& tabGoals = editWord("Goals");
inline char const* const& tabLevel = editWord("Level");
inline char const* const& tabSolutions = editWord("Solutions");
inline char const* const& tabProblems = editWord("Problems");
inline char const* const& search = editWord("Search");
inline char const* const& nothingFound = editWord("No part is called that.");
inline char const* const& nothingSelected =
    editWord("Nothing is selected. Click an object, or drag a box around several.");
inline char const* const& noProblems = editWord("Nothing is wrong with this level.");
inline char const* const& severalValues = editWord("several values");
inline char const* const& objectsHeading = editWord("Objects");
inline char const* const& jointsHeading = editWord("Joints");
inline char const* const& connectionsHeading = editWord("Wires and other connections");
inline char const* const& typeToFind = editWord("Type to search");
inline char const* const& addProperty = editWord("Add a property …");
inline char const* const& resetTip = editWord("Back to the value of the part");
inline char const* const& removeTip = editWord("Without it");

inline char const* const& commandsTitle = editWord("Commands, parts and joints");
inline char const* const& nothingCalled = editWord("Nothing is called that.");
inline char const* const& jointKind = editWord("Joint");

inline char const* const& lockedMark = editWord("  (locked)");
inline char const* const& hiddenMark = editWord("  (hidden)");
inline char const* const& nameField = editWord("Name");
inline char const* const& partField = editWord("Part");
inline char const* const& partFieldTip =
    editWord("The part that it is made from; its own properties take precedence");
inline char const* const& pieceField = editWord("Piece");
inline char const* const& pieceFieldTip = editWord(
    "One piece of a part that consists of several; *: it is changed here; –: the whole, with the properties "
    "of its main piece");
inline char const* const& resetPiece = editWord("Reset this piece");
inline char const* const& resetPieceTip = editWord("Everything about it as the part states it");
inline char const* const& pieceStaysText =
    editWord("A piece of a part cannot be removed; {} selects the whole object");
[[nodiscard]] inline std::string pieceStays(std::string const& back) {
    return filledIn(pieceStaysText, back);
}
inline char const* const& mirroredTip =
    editWord("Left and right swapped, about its own vertical axis, before it is turned");
inline char const* const& severalObjectsText = editWord("{} objects");
[[nodiscard]] inline std::string severalObjects(std::size_t count) {
    return filledIn(severalObjectsText, count);
}
inline char const* const& fromField = editWord("From");
inline char const* const& toField = editWord("To");
inline char const* const& kindField = editWord("Kind");
inline char const* const& kindFieldTip = editWord("Such as \"wire\"; empty: it follows from the objects");
inline char const* const& cornerField = editWord("Corner");
inline char const* const& sizeField = editWord("Size");
inline char const* const& reset = editWord("reset");
inline char const* const& removeShort = editWord("×");
inline char const* const& removeIt = editWord("Remove");
inline char const* const& addEntry = editWord("Add one more");
inline char const* const& addEntryOfText = editWord("Add one more: {}");
/// `list`: of what, as "Corners".
[[nodiscard]] inline std::string addEntryOf(std::string const& list) {
    return filledIn(addEntryOfText, list);
}
inline char const* const& upIt = editWord("Move up");
inline char const* const& downIt = editWord("Move down");
inline char const* const& fromPart = editWord("As the part states it");
inline char const* const& takenAway = editWord("Taken away, though the part has it");
inline char const* const& scriptsHeading = editWord("Scripts");
inline char const* const& addScript = editWord("Add a script …");

// Goals.
inline char const* const& noGoals = editWord("There is no goal yet.");
inline char const* const& addGoal = editWord("Add a goal");
inline char const* const& listOfObjects = editWord("Several");
inline char const* const& listOfObjectsTip = editWord("A list: it is enough if one of them does it");
inline char const* const& oneMore = editWord("One more");
inline char const* const& ownGoals = editWord("By itself");
inline char const* const& ownGoalsTip = editWord("What the demonstration reaches without the player");
inline char const* const& taskGoals = editWord("Task");
inline char const* const& taskTip = editWord("What a player of the demonstration is asked to reach");
inline char const* const& noTask =
    editWord("No task yet: whoever opens the demonstration only watches it. Choose a kind below.");
inline char const* const& forSeconds = editWord("For");
inline char const* const& forSecondsTip =
    editWord("How long it must hold without a break; 0: a moment is enough");
inline char const* const& goalId = editWord("Id");
inline char const* const& goalText = editWord("Text");
inline char const* const& goalTextTip = editWord("Left empty, it is made from the condition");
inline char const* const& wrapTip = editWord("Put this goal inside");
inline char const* const& unwrap = editWord("Unwrap");
inline char const* const& unwrapTip = editWord("Put the only inner goal in its place");

// Level.
inline char const* const& textsHeading = editWord("Texts");
inline char const* const& titleField = editWord("Title");
inline char const* const& storyField = editWord("Text before the level");
inline char const* const& demonstrationField = editWord("Demonstration: solves itself");
inline char const* const& translationsHeading = editWord("Other languages");
inline char const* const& languageField = editWord("Language");
inline char const* const& addLanguageField = editWord("Add a language");
inline char const* const& addLanguageTipText = editWord("Two small letters, like de or fr; then {}");
[[nodiscard]] inline std::string addLanguageTip(std::string const& key) {
    return filledIn(addLanguageTipText, key);
}
inline char const* const& removeLanguage = editWord("Remove this language");
inline char const* const& hintField = editWord("Hint {}");
inline char const* const& goalWithId = editWord("Goal \"{}\"");
inline char const* const& goalWithoutId =
    editWord("This goal needs an id on the page of goals before its text can be translated.");
inline char const* const& lostGoal = editWord("No goal has this id any more.");
inline char const* const& generatedGoal = editWord("(a sentence that the game makes)");
inline char const* const& notTranslated = editWord("not translated");
inline char const* const& allTranslated = editWord("Everything is translated.");
inline char const* const& missingTexts = editWord("Not translated: {}");
inline char const* const& hintsHeading = editWord("Hints");
inline char const* const& addHint = editWord("Add a hint");
inline char const* const& newHint = editWord("A hint");
inline char const* const& toolboxHeading = editWord("Toolbox");
inline char const* const& addTool = editWord("Add a part …");
inline char const* const& addToolTip = editWord("Add a part to the player's toolbox");
inline char const* const& wiresField = editWord("Wires");
inline char const* const& anyNumber = editWord("any number");
inline char const* const& unlimitedTip = editWord("Any number, without a limit");
inline char const* const& limitedTip = editWord("A certain number again");
inline char const* const& wiresTip = editWord("How many wires the player may lay");
inline char const* const& teachingHeading = editWord("Teaching");
inline char const* const& addStep = editWord("Add a step …");
inline char const* const& addStepTip = editWord("Add a step of what a beginner is shown");
inline char const* const& stepNeedsPart = editWord("Put a part into the toolbox first.");
inline char const* const& stepNeedsObjects = editWord("There are not enough objects for this step.");
inline char const* const& placeField = editWord("Place");
inline char const* const& mirroredField = editWord("Mirrored");
inline char const* const& objectField = editWord("Object");
inline char const* const& worldHeading = editWord("World");
inline char const* const& boundsField = editWord("Bounds");
inline char const* const& boundsTip = editWord("Left and lower edge; width and height");
inline char const* const& noBounds = editWord("Without bounds");
inline char const* const& giveBounds = editWord("Give it bounds");
inline char const* const& anywhere = editWord("Parts may be placed anywhere");
inline char const* const& anywhereTip = editWord("Remove all placing areas");
inline char const* const& detailHeading = editWord("Detail");
inline char const* const& detailTip = editWord("How exactly the effect is computed; –: the scene decides");
inline char const* const& modsHeading = editWord("Mods");
inline char const* const& modsTip = editWord("Mods count once the level is saved and opened again.");

// Solutions.
inline char const* const& noSolutions =
    editWord("No run is recorded yet. Test the level, solve it, and record it.");
inline char const* const& solvesLevel = editWord("must solve the level");
inline char const* const& framesField = editWord("Frames");
inline char const* const& framesTip =
    editWord("How long it is run, in sixtieths of a second; 0: as long as it takes");
inline char const* const& watch = editWord("Watch");
inline char const* const& watchTip = editWord("Play this run");
inline char const* const& again = editWord("Re-record");
inline char const* const& againTip =
    editWord("Play with these parts; what you then record replaces this run");
inline char const* const& showEntries = editWord("Edit the entries");
inline char const* const& hideEntries = editWord("Hide the entries");
inline char const* const& entriesTip =
    editWord("The single placements, wires, inputs and changes of this run, as the file states them");
inline char const* const& entriesFrom = editWord("From entry");
inline char const* const& entriesFromTip = editWord("The number of the first entry that is shown");
inline char const* const& recordNew = editWord("Play to record a new one");
inline char const* const& recordNewTip =
    editWord("Play the level; the button at the lower right records what you did");

// Tools.
inline char const* const& gridStep = editWord("Grid");
inline char const* const& angleStep = editWord("Angle");
inline char const* const& radius = editWord("Radius");
inline char const* const& jointField = editWord("Joint");
inline char const* const& toolSettings = editWord("Drawing");
inline char const* const& numberTip = editWord("Click to type a number; drag to change it");
inline char const* const& snapTip = editWord("Snap places and angles to the grid");
inline char const* const& readOnlyShort = editWord("read-only");
inline char const* const& notSaved = editWord("not saved yet");
inline char const* const& allSaved = editWord("saved");
inline char const* const& notSafe = editWord("not safe from a crash");
inline char const* const& testBack = editWord("Back to the editor");
inline char const* const& playing = editWord("Test play");
inline char const* const& recordIt = editWord("Record as a solution");
inline char const* const& recordAgainIt = editWord("Record it again");
inline char const* const& runFirst = editWord("Run it first: what is recorded is what you placed and did.");
/// In the file, so in one language.
inline constexpr char const* newSolution = "solution";
inline char const* const& recordedSolved = editWord("Recorded: a solution that solves the level");
inline char const* const& recordedUnsolved = editWord("Recorded: a run that does not solve the level");
inline char const* const& selectTwo =
    editWord("Select the two objects first, or drag from one to the other.");
inline char const* const& jointBegins =
    editWord("Drag from one object to another, or click one to hold it to the world");
inline char const* const& jointToWorld = editWord("Held to the world here");
inline char const* const& jointThere = editWord("There is such a joint here already");
inline char const* const& selectForGoal = editWord("Select the object that is to come there first.");
inline char const* const& cannotTestText = editWord("This cannot be played yet: {}");
[[nodiscard]] inline std::string cannotTest(std::string const& why) {
    return filledIn(cannotTestText, why);
}
inline char const* const& undoneText = editWord("Undone: {}");
[[nodiscard]] inline std::string undone(std::string const& name) {
    return filledIn(undoneText, name);
}
inline char const* const& redoneText = editWord("Redone: {}");
[[nodiscard]] inline std::string redone(std::string const& name) {
    return filledIn(redoneText, name);
}
inline char const* const& partMadeText = editWord("The part \"{}\" is in {}");
[[nodiscard]] inline std::string partMade(std::string const& name, std::string const& file) {
    return filledIn(partMadeText, name, file);
}

} // namespace trembler::ui::words
