// Helpers shared by the tests of the editor's document.
#pragma once

#include "puzzle/edit/document/level_document.hpp"
#include "tests/puzzle/edit/any_command.hpp"

#include <functional>
#include <string>

namespace trembler::edit {

[[nodiscard]] GameData const& editData();
[[nodiscard]] std::string fileText(std::filesystem::path const& path);
void writeText(std::filesystem::path const& path, std::string const& text);
/// A new empty folder of the running test.
[[nodiscard]] std::filesystem::path testFolder();
/// A level with a table, two crates, a ball made from a part, a hinge, a rope, a wire, goals and a solution.
[[nodiscard]] std::string const& smallLevel();
[[nodiscard]] LevelDocument smallDocument();
/// The message with which a command is refused; "" if it is not.
[[nodiscard]] std::string refusalOf(std::function<void()> const& what);
} // namespace trembler::edit
