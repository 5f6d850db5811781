// Whether the words of a screen can be read, in any language and at any size.
#pragma once

#include "tests/game/ui/player.hpp"

#include <string>

namespace trembler::ui::test {

/// No words lie on each other, leave the window or are cut, and no number is broken across lines.
void expectReadable(std::string const& where);
/// Words whose middle is on a button do not reach beyond it.
void expectWordsFit(Player& player, std::string const& where);

} // namespace trembler::ui::test
