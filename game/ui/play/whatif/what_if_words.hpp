// The changes of a what-if in words.
#pragma once

#include "insight/whatif/change.hpp"
#include "puzzle/session/session.hpp"

#include <string>

namespace trembler::ui {

/// "iron ball: moved", in the player's language. Window thread only.
[[nodiscard]] std::string wordsOf(insight::Change const& change, World const& world);

/// A key of a file as people read it, in the player's language: "break_force" as "break force".
[[nodiscard]] std::string spokenField(std::string const& key);

} // namespace trembler::ui
