// The editor's own data about objects in the file, under the key "editor": groups, locked and hidden objects.
// No simulation reads it, and the game does not show it:
//     "editor": {"groups": [["door", "hinge post"]], "locked": ["floor"], "hidden": ["backboard"]}
// Names that no object has are ignored; the next of these commands drops them.
#pragma once

#include "puzzle/edit/document/command.hpp"

#include <string>
#include <vector>

namespace trembler::edit {

[[nodiscard]] bool isLocked(Json const& level, std::string const& name);
[[nodiscard]] bool isHidden(Json const& level, std::string const& name);
/// The members of the object's group, itself included, in the order of the file; only itself without a group.
[[nodiscard]] std::vector<std::string> groupOf(Json const& level, std::string const& name);
/// The objects and all members of their groups, each once: the objects that a click selects.
[[nodiscard]] std::vector<std::string> withGroups(Json const& level, std::vector<std::string> const& names);
/// The objects without the locked ones.
[[nodiscard]] std::vector<std::string> unlocked(Json const& level, std::vector<std::string> const& names);

/// Makes a group of at least two objects; they leave their former groups.
[[nodiscard]] Command groupObjects(Json const& level, std::vector<std::string> const& names);
/// Dissolves the groups of these objects.
[[nodiscard]] Command ungroupObjects(Json const& level, std::vector<std::string> const& names);
/// A locked object can be looked at and referred to, but commands that arrange or remove objects leave it
/// out.
[[nodiscard]] Command lockObjects(Json const& level, std::vector<std::string> const& names, bool lock);
/// A hidden object is not drawn while editing.
[[nodiscard]] Command hideObjects(Json const& level, std::vector<std::string> const& names, bool hide);

/// Drops names that no object has. For commands that remove objects.
void tidyEditorState(Json& level);

} // namespace trembler::edit
