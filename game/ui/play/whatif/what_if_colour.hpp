// The colour of everything that is of the other run.
#pragma once

#include "render/draw/palette.hpp"

namespace trembler::ui {

/// Of the palette in use. Nothing else is drawn in it but a second hand, which the past does not show.
[[nodiscard]] inline render::Colour whatIfColour() {
    return render::palette::secondHand;
}

} // namespace trembler::ui
