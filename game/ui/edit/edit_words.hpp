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
inline constexpr char const* understood = "Understood";

// Panels.
inline constexpr char const* tabParts = "Parts";
inline constexpr char const* tabOutline = "Outline";
inline constexpr char const* tabProperties = "Properties";
inline constexpr char const* tabGoals = "Goals";
inline constexpr char const* tabLevel = "Level";
inline constexpr char const* tabSolutions = "Solutions";
inline constexpr char const* tabProblems = "Problems";
inline constexpr char const* search = "Search";
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

// Tools.
inline constexpr char const* gridStep = "Grid";
inline constexpr char const* angleStep = "Angle";
inline constexpr char const* testBack = "Back to the editor";
inline constexpr char const* playing = "Test play";

} // namespace trembler::ui::words
