#include "render/scene/overlays/overlay_buoyancy.hpp"

#include "physics/buoyancy/properties/results.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/overlays/overlay_magnetism.hpp"

#include <algorithm>

namespace trembler::render {

void drawBuoyancy(Canvas& canvas, World const& world) {
    auto const* const forces = world.find<BuoyancyForce>();
    auto const* const centres = world.find<CentreOfBuoyancy>();
    if (forces == nullptr || centres == nullptr) {
        return;
    }
    std::size_t const count = std::min(forces->forces.size(), centres->centres.size());
    for (std::size_t i = 0; i < count; ++i) {
        Vec2 const force = forces->forces[i].force;
        Point const from = toPoint(centres->centres[i].world);
        canvas.circle({from, 0}, canvas.metres(4.5),
                      {.tint = palette::force, .outline = 1.2F, .height = 0.F});
        double const strength = length(force);
        double const reach = arrowLength(strength, canvas.metres(forceDecade));
        if (reach > canvas.metres(2)) {
            canvas.arrow(from, from + (reach / strength) * toPoint(force),
                         {.colour = palette::force, .pixels = 5.F, .outline = 1.2F, .height = 0.6F});
        }
    }
}

} // namespace trembler::render
