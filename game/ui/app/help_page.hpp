// The page of keys: what each does on this screen, as bound, and what the mouse does.
#pragma once

#include "game/ui/shared/screen.hpp"
#include "game/ui/shared/ui_context.hpp"

#include <cstdint>

namespace trembler::ui {

enum class HelpChoice : std::uint8_t { stay, back, changeKeys };

/// Between Gui::beginFrame and endFrame; `behind` is the screen that it tells of.
HelpChoice drawHelp(UiContext& context, Screen& behind);

} // namespace trembler::ui
