// The page of settings.
#pragma once

#include "game/ui/shared/ui_context.hpp"

#include <cstdint>

namespace trembler::ui {

/// Every change applies and is saved in the profile at once. Window thread only.
class SettingsPage {
public:
    enum class Choice : std::uint8_t { stay, back, changeKeys };
    /// Call between Gui::beginFrame and endFrame.
    Choice draw(UiContext& context);

private:
    float rows_ = 0; // height of all rows in the last picture, pixels
};

/// Applies the profile's settings to the window, the loudspeaker and the texts.
void applySettings(UiContext& context);
/// Saves and applies the settings.
void changeSettings(UiContext& context, Settings const& settings);

} // namespace trembler::ui
