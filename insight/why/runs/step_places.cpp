#include "insight/why/runs/step_places.hpp"

#include "insight/why/story/story.hpp"
#include "physics/dynamics/properties/shapes/placed_shape.hpp"
#include "runtime/placement.hpp"
#include "runtime/trace/tracer.hpp"
#include "runtime/world/entry.hpp"

#include <optional>

namespace trembler::insight {
namespace {

std::optional<Vec2> placeOf(Store const& store, Event const& event, StepKind kind) {
    if (event.objects.empty()) {
        return std::nullopt;
    }
    ObjectId const first = store.find(event.objects[0]);
    if (kind == StepKind::contact && event.objects.size() == 2) {
        auto const a = placedShapeOf(store, first);
        auto const b = placedShapeOf(store, store.find(event.objects[1]));
        if (a && b) {
            ShapeGap const gap = gapBetween(*a, *b);
            return 0.5 * (gap.a + gap.b);
        }
    }
    Position const* const position = entryOf<Position>(store, first);
    return position == nullptr ? std::nullopt : std::optional(position->value);
}

} // namespace

void StepPlaces::look(World const& world) {
    Tracer const* const tracer = world.tracer();
    if (tracer == nullptr) {
        return;
    }
    std::span<Event const> const events = tracer->events();
    for (; seen_ < events.size(); ++seen_) {
        Event const& event = events[seen_];
        auto const kind = kindOf(event);
        auto const place = kind ? placeOf(world.store(), event, *kind) : std::nullopt;
        if (place) {
            places_.emplace_hint(places_.end(), event.id, *place);
        }
    }
}

Vec2 StepPlaces::of(EventId event, Vec2 otherwise) const {
    auto const at = places_.find(event);
    return at == places_.end() ? otherwise : at->second;
}

} // namespace trembler::insight
