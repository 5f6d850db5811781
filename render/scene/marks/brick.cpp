#include "render/scene/marks/brick.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {
namespace {

constexpr double brickLength = 0.36; // m
constexpr double course = 0.16;      // m
constexpr double mostBricks = 4000;
constexpr Colour mortar = rgb(0xE4CDB4);

} // namespace

void drawMortar(Canvas& canvas, Shape const& shape, Pose const& pose, float alpha) {
    Stroke const line{.colour = mortar, .width = 0.014, .pixels = 1.F, .alpha = alpha};
    for (ShapePiece const& piece : shape.pieces) {
        std::vector<Point> const outline = insetOutline(outlineOf(piece), canvas.metres(2));
        Extent const own = extentOf(piece, {});
        Point const half = own.half();
        bool const small = 2 * half.y <= 1.7 * course || 2 * half.x <= 1.2 * brickLength;
        if (small || outline.size() < 3 || 4 * half.x * half.y > mostBricks * brickLength * course) {
            continue;
        }
        // A whole number of courses from the lower edge up.
        int const courses = std::max(1, static_cast<int>(std::lround(2 * half.y / course)));
        double const height = 2 * half.y / courses;
        for (int row = 0; row < courses; ++row) {
            double const bottom = own.lower.y + row * height;
            if (auto const bed = clipLine(outline, {0, bottom}, {1, 0}); bed && row > 0) {
                canvas.line(toWorld(pose, (*bed)[0]), toWorld(pose, (*bed)[1]), line);
            }
            double const shift = row % 2 == 0 ? 0.5 : 1.0;
            int const bricks = static_cast<int>(2 * half.x / brickLength) + 1;
            for (int i = 0; i < bricks; ++i) {
                double const x = own.lower.x + (shift + i) * brickLength;
                if (x > own.upper.x - 0.05) {
                    break;
                }
                auto const joint = clipLine(outline, {x, 0}, {0, 1});
                double const from = joint ? std::max((*joint)[0].y, bottom) : 0;
                double const to = joint ? std::min((*joint)[1].y, bottom + height) : 0;
                if (to > from) {
                    canvas.line(toWorld(pose, {x, from}), toWorld(pose, {x, to}), line);
                }
            }
        }
    }
}

} // namespace trembler::render
