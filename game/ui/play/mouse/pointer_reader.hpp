// The mouse on a screen with a world and cards: from events to what the tools want to know.
#pragma once

#include "game/ui/shared/pointer.hpp"
#include "game/ui/shared/ui_context.hpp"
#include "render/draw/camera.hpp"

namespace trembler::ui {

/// Remembers from picture to picture what a click is.
class PointerReader {
public:
    /// Once per picture. `busy`: a tool holds something, so panels do not take the mouse from it.
    [[nodiscard]] Pointer read(UiContext const& context, render::Camera const& camera, bool busy);

private:
    render::Point rightPressedAt_; // pixels
};

} // namespace trembler::ui
