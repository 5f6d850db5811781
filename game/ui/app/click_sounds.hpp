// The sounds of buttons, and of refusals outside of levels.
#pragma once

#include "game/ui/shared/ui_context.hpp"

#include <cstdint>

namespace trembler::ui {

/// Every button that is pressed, by mouse or key, is heard, unless the screen has a sound of its own for what
/// it does. Window thread only.
class ClickSounds {
public:
    /// Once for every picture, after all its widgets.
    void look(UiContext const& context);

private:
    std::uint64_t touched_ = 0; // sounds up to the last picture
    std::uint64_t atPress_ = 0; // before the mouse button went down
    std::uint64_t troubles_ = 0;
};

} // namespace trembler::ui
