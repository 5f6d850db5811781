// The size of letters, buttons and line widths, from the number of pixels of the window.
#pragma once

#include "render/gl/image.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {

/// The room that every screen of the program needs at least, pixels at UI scale 1.
inline constexpr Size leastRoom{800, 450};

/// The factor on every length of the interface; 1 at 1280x720, about 1.4 at 1920x1080 and 2.5 at 3840x2160.
/// It grows a little slower than the window, so that a larger screen shows larger letters and also more.
/// `request` is the player's own setting (0.5 to 3, else it is clamped). It enlarges only as far as the
/// window still has room for `leastRoom`, for which every screen is laid out. The result lies between 0.375
/// and 12.
[[nodiscard]] inline float uiScaleFor(Size pixels, float request = 1.F) {
    float const fit =
        std::min(static_cast<float>(pixels.width) / 1280.F, static_cast<float>(pixels.height) / 720.F);
    float const own = std::isfinite(request) ? std::clamp(request, 0.5F, 3.F) : 1.F;
    float const grown = std::clamp(std::pow(std::max(fit, 0.01F), 0.85F), 0.75F, 4.F);
    float const most = std::min(static_cast<float>(pixels.width) / static_cast<float>(leastRoom.width),
                                static_cast<float>(pixels.height) / static_cast<float>(leastRoom.height));
    // In a small window letters stay legible as long as there is room.
    float const usual = std::max(grown, std::min(0.9F, most));
    return std::min(usual * own, std::max(usual * std::min(own, 1.F), most));
}

} // namespace trembler::render
