#include "render/scene/overlays/overlay_magnetism.hpp"

#include "physics/magnetism/properties.hpp"
#include "render/draw/path.hpp"
#include "render/scene/overlays/field_lines.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {

double arrowLength(double newtons, double decade) {
    return std::isfinite(newtons) && newtons > 0 ? decade * std::log10(1 + newtons / leastForce) : 0;
}

void drawMagneticForces(Canvas& canvas, World const& world) {
    auto const* const forces = world.find<MagneticForce>();
    if (forces == nullptr) {
        return;
    }
    for (MagneticForce::Entry const& entry : forces->forces) {
        double const strength = length(entry.force);
        double const reach = arrowLength(strength, canvas.metres(forceDecade));
        if (!(reach > canvas.metres(2))) {
            continue;
        }
        Point const from = toPoint(entry.point);
        canvas.circle({from, 0}, canvas.metres(4.5),
                      {.tint = palette::force, .outline = 1.2F, .height = 0.F});
        canvas.arrow(from, from + (reach / strength) * toPoint(entry.force),
                     {.colour = palette::force, .pixels = 5.F, .outline = 1.2F, .height = 0.6F});
    }
}

void drawFieldLines(Canvas& canvas, World const& world) {
    std::vector<FieldPole> const poles = activePoles(world);
    Extent const around = viewOf(canvas.camera());
    // Lines that leave the view may come back.
    double const margin = 0.5 * std::max(around.half().x, around.half().y);
    Stroke const line{.colour = palette::fieldLine, .pixels = 1.8F, .alpha = 0.75F};
    for (auto const& points : fieldLines(poles, around.widened(margin))) {
        // Points are denser than a picture needs.
        std::vector<Point> thin;
        for (std::size_t i = 0; i < points.size(); i += 3) {
            thin.push_back(points[i]);
        }
        thin.push_back(points.back());
        canvas.polyline(thin, line);
        double const total = pathLength(points);
        double const head = canvas.metres(10);
        if (double const at = std::min(0.5 * total, canvas.metres(90)); total > 4 * head) {
            canvas.arrow(pointAlong(points, at), pointAlong(points, at + head),
                         {.colour = palette::fieldLine, .pixels = 3.2F});
        }
    }
}

} // namespace trembler::render
