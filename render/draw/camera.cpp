#include "render/draw/camera.hpp"

#include <algorithm>

namespace trembler::render {

Point Camera::toScreen(Point world) const {
    return {0.5 * viewport.width + (world.x - centre.x) * pixelsPerMetre,
            0.5 * viewport.height - (world.y - centre.y) * pixelsPerMetre};
}

Point Camera::toWorld(Point screen) const {
    return {centre.x + (screen.x - 0.5 * viewport.width) / pixelsPerMetre,
            centre.y - (screen.y - 0.5 * viewport.height) / pixelsPerMetre};
}

void Camera::zoomAt(Point screen, double factor) {
    if (!std::isfinite(factor) || factor <= 0) {
        return;
    }
    Point const fixed = toWorld(screen);
    pixelsPerMetre = std::clamp(pixelsPerMetre * factor, smallestScale, largestScale);
    centre = centre + (fixed - toWorld(screen));
}

void Camera::pan(Point pixels) {
    centre.x -= pixels.x / pixelsPerMetre;
    centre.y += pixels.y / pixelsPerMetre;
}

void Camera::fit(Point lower, Point upper, double margin) {
    double const width = upper.x - lower.x;
    double const height = upper.y - lower.y;
    double const across = viewport.width - 2 * margin;
    double const down = viewport.height - 2 * margin;
    if (!(width > 0 && height > 0 && across > 0 && down > 0) || !finite(lower) || !finite(upper)) {
        return;
    }
    centre = 0.5 * (lower + upper);
    pixelsPerMetre = std::clamp(std::min(across / width, down / height), smallestScale, largestScale);
}

} // namespace trembler::render
