#include "render/scene/overlays/overlay_sound.hpp"

#include "render/draw/palette.hpp"

#include <algorithm>

namespace trembler::render {

void drawRipples(Canvas& canvas, std::span<Ripple const> ripples) {
    for (Ripple const& ripple : ripples) {
        double const strength = std::clamp(ripple.strength, 0.0, 1.0);
        if (!(strength > 0)) {
            continue;
        }
        canvas.ring(ripple.at, ripple.radius,
                    {.colour = palette::sound,
                     .pixels = static_cast<float>(1.2 + 1.3 * strength),
                     .alpha = static_cast<float>(0.15 + 0.45 * strength)});
    }
}

} // namespace trembler::render
