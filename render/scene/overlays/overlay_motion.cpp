#include "render/scene/overlays/overlay_motion.hpp"

#include "render/draw/path.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "runtime/input/input_resolver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace trembler::render {
namespace {

void drawCentre(Canvas& canvas, Pose const& pose) {
    double const radius = canvas.metres(6.5);
    canvas.circle({pose.at, 0}, radius, {.tint = palette::paperLight, .outline = 1.5F, .height = 0.F});
    for (double const start : {0.0, std::numbers::pi}) {
        std::vector<Point> quarter{{0, 0}};
        for (int i = 0; i <= 6; ++i) {
            double const angle = start + 0.5 * std::numbers::pi * i / 6;
            quarter.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        canvas.polygon(pose, quarter, {.tint = palette::ink, .outline = 0.F, .height = 0.F});
    }
}

} // namespace

void drawMotion(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf) {
    constexpr double slow = 0.05; // m/s
    for (Facts const& facts : reader.drawOrder()) {
        if (facts.fixed || facts.shape == nullptr) {
            continue;
        }
        Pose const pose = poseOf(facts);
        Pose const centre{toWorld(pose, centroidOf(*facts.shape)), pose.angle};
        if (Velocity const* const velocity = world.find<Velocity>(facts.id); velocity != nullptr) {
            double const speed = length(velocity->value);
            double const reach = canvas.metres(30) * std::log10(1 + speed / slow);
            if (std::isfinite(speed) && reach > canvas.metres(9)) {
                canvas.arrow(centre.at, centre.at + (reach / speed) * toPoint(velocity->value),
                             {.colour = palette::accent, .pixels = 4.F, .outline = 1.F, .height = 0.5F});
            }
        }
        drawCentre(canvas, centre);
    }
}

void drawHand(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf) {
    Hand const* const hand = world.find<Hand>();
    if (hand == nullptr || !world.store().alive(hand->object)) {
        return;
    }
    Facts const held = reader.of(hand->object);
    if (held.position == nullptr) {
        return;
    }
    Point const from = toWorld(poseOf(held), toPoint(hand->localPoint));
    Point const to = toPoint(hand->target);
    // The further it is drawn out, the thinner rubber gets.
    double const stretch = length(to - from) / canvas.metres(60);
    auto const pixels = static_cast<float>(2.2 + 3.4 / (1 + stretch));
    canvas.line(from, to,
                {.colour = palette::accent, .pixels = pixels, .outline = 1.1F, .round = true, .height = 1.F});
    canvas.circle({from, 0}, canvas.metres(5),
                  {.pattern = Pattern::Plastic, .tint = palette::accent, .outline = 1.3F, .height = 0.6F});
    canvas.ring(to, canvas.metres(10),
                {.colour = palette::accent, .pixels = 3.F, .outline = 0.F, .alpha = 0.9F});
}

} // namespace trembler::render
