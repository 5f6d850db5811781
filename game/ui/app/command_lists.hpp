// The commands of all screens of the program.
#pragma once

#include "game/ui/commands/key_bindings.hpp"

#include <vector>

namespace trembler::ui {

/// One list for each screen; a new screen's table is added here. The lists refer to static data.
[[nodiscard]] std::vector<CommandList> commandLists();

} // namespace trembler::ui
