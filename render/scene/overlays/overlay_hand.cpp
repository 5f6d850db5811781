#include "render/scene/overlays/overlay_hand.hpp"

#include "render/scene/facts/shape_geometry.hpp"
#include "runtime/input/input_resolver.hpp"

namespace trembler::render {

namespace {

void drawBand(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf,
              Hand const* hand, std::optional<Point> place, Colour colour) {
    if (hand == nullptr || !world.store().alive(hand->object)) {
        return;
    }
    Facts const held = reader.of(hand->object);
    if (held.position == nullptr) {
        return;
    }
    Point const from = toWorld(poseOf(held), toPoint(hand->localPoint));
    Point const to = place.value_or(toPoint(hand->target));
    // The further the cord is stretched, the thinner it gets.
    double const stretch = length(to - from) / canvas.metres(60);
    auto const pixels = static_cast<float>(2.2 + 3.4 / (1 + stretch));
    canvas.line(from, to,
                {.colour = colour, .pixels = pixels, .outline = 1.1F, .round = true, .height = 1.F});
    canvas.circle({from, 0}, canvas.metres(5),
                  {.pattern = Pattern::Plastic, .tint = colour, .outline = 1.3F, .height = 0.6F});
    canvas.ring(to, canvas.metres(10), {.colour = colour, .pixels = 3.F, .outline = 0.F, .alpha = 0.9F});
}

} // namespace

void drawHand(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf,
              HandPlaces const& places) {
    drawBand(canvas, world, reader, poseOf, world.find<Hand>(), places[0], palette::accent);
    SecondHand const* const second = world.find<SecondHand>();
    drawBand(canvas, world, reader, poseOf, second == nullptr ? nullptr : &second->grip, places[1],
             palette::secondHand);
}

} // namespace trembler::render
