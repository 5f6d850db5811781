// Which part of the world is seen, and how large.
#pragma once

#include "render/draw/geometry.hpp"
#include "render/gl/image.hpp"

namespace trembler::render {

/// Screen positions are in pixels from the top left corner, y down; world positions in metres, y up. Plain
/// data, usable from any thread.
struct Camera {
    static constexpr double smallestScale = 1e-3; ///< pixels per metre
    static constexpr double largestScale = 1e6;

    Point centre;                ///< the world point in the middle of the view
    double pixelsPerMetre = 100; ///< positive and finite
    Size viewport{1280, 720};    ///< pixels

    [[nodiscard]] Point toScreen(Point world) const;
    [[nodiscard]] Point toWorld(Point screen) const;

    /// Enlarges by `factor` (clamped so that the scale stays between the two limits; ignored unless positive
    /// and finite) and keeps the world point under `screen` where it is.
    void zoomAt(Point screen, double factor);
    /// Moves the world along with a cursor that moved by `pixels`.
    void pan(Point pixels);
    /// Shows the whole rectangle between two corners, with `margin` pixels around it. An empty or non-finite
    /// rectangle, or a view without pixels, changes nothing.
    void fit(Point lower, Point upper, double margin);
};

} // namespace trembler::render
