// The page of keys: what each key does on the current screen with the player's bindings, and the mouse's
// gestures.
#pragma once

#include "game/ui/shared/screen.hpp"
#include "game/ui/shared/ui_context.hpp"

#include <cstdint>

namespace trembler::ui {

enum class HelpChoice : std::uint8_t { stay, back, changeKeys };

/// Call between Gui::beginFrame and endFrame; `behind` is the screen that it describes.
HelpChoice drawHelp(UiContext& context, Screen& behind);

} // namespace trembler::ui
