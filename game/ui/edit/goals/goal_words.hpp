// The words of goals while they are edited: kinds of conditions and their fields.
#pragma once

#include <string>

namespace trembler::ui {

/// A kind of condition, a key inside one, or a direction, in the language in use; others stay as they are.
[[nodiscard]] std::string shownGoalWord(std::string const& word);

} // namespace trembler::ui
