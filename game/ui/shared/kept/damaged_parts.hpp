// The player's own parts whose files are damaged, in the window.
#pragma once

#include "runtime/file/kept_file.hpp"

#include <span>
#include <string>
#include <vector>

namespace trembler::ui {

/// Moves each damaged file aside and puts its last good version in its place, as with the other files of the
/// player. Returns a sentence for each, in the language in use; of those that are good by now none.
[[nodiscard]] std::vector<std::string> moveDamagedAside(std::span<DamagedFile const> damaged);

} // namespace trembler::ui
