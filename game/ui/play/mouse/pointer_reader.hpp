// Reads the mouse on a screen with a world and cards: from input events to a Pointer for the tools.
#pragma once

#include "game/ui/shared/pointer.hpp"
#include "game/ui/shared/ui_context.hpp"
#include "render/draw/camera.hpp"

namespace trembler::ui {

/// Remembers where the right button went down, to distinguish a click from a drag.
class PointerReader {
public:
    /// To be called once per picture. `busy`: a tool holds something, so panels do not take the mouse from
    /// it.
    [[nodiscard]] Pointer read(UiContext const& context, render::Camera const& camera, bool busy);

private:
    render::Point rightPressedAt_; // pixels
};

} // namespace trembler::ui
