// Copying between levels, as text.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/math/vec2.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::edit {

/// A text for the clipboard: JSON with the objects, the joints and connections among them, and their groups:
///     {"trembler": "objects", "version": 2, "objects": [...], "joints": [...], "connections": [...]}
/// Throws CommandError if an object does not exist.
[[nodiscard]] std::string copiedText(GameData const& data, Json const& level,
                                     std::vector<std::string> const& names);
/// Whether a text from the clipboard can be pasted.
[[nodiscard]] bool canPaste(std::string const& text);
/// Adds the objects of a text that copiedText() made, from this level or another. Names that are taken get a
/// number, and references among the objects follow. The middle of the objects' centres comes to `at`; without
/// it, they come where they were copied from, or 0.2 m to the right and below if an object already lies
/// there. Throws CommandError for text that was not copied from a level.
[[nodiscard]] Command pasteText(GameData const& data, Json const& level, std::string const& text,
                                std::optional<Vec2> at = {});
/// Removes the objects, under the name "Cut ...". The caller has put copiedText() onto the clipboard.
[[nodiscard]] Command cutObjects(GameData const& data, Json const& level,
                                 std::vector<std::string> const& names);

} // namespace trembler::edit
