// The card of a what-if: its changes, further possible changes, and their consequences.
#pragma once

#include "game/ui/play/whatif/what_if_tool.hpp"
#include "game/ui/shared/commands/command_buttons.hpp"
#include "puzzle/session/session.hpp"

namespace trembler::ui {

/// While the card has the keyboard, ImGui moves its own ring among the widgets. Once per picture, also while
/// the card is not drawn.
void passKeysToCard(bool pass);

/// `above`: how far from the bottom, pixels at UI scale 1. Between Gui::beginFrame and endFrame.
void drawWhatIfCard(CommandButtons& buttons, Session const& session, WhatIfView& view, WhatIfTool& tool,
                    float above);

} // namespace trembler::ui
