#include "insight/why/runs/step_places.hpp"

#include "insight/why/story/story.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "runtime/placement.hpp"
#include "runtime/trace/tracer.hpp"

#include <optional>

namespace trembler::insight {
namespace {

template <class P>
P const* propertyOf(Store const& store, ObjectId object) {
    auto const* const column = store.findColumn<P>();
    return column == nullptr || !object.valid() ? nullptr : column->find(object);
}

std::optional<PlacedShape> placedShapeOf(Store const& store, ObjectId object) {
    Shape const* const shape = propertyOf<Shape>(store, object);
    Position const* const position = propertyOf<Position>(store, object);
    if (shape == nullptr || position == nullptr || shape->pieces.empty()) {
        return std::nullopt;
    }
    Rotation const* const rotation = propertyOf<Rotation>(store, object);
    return PlacedShape{*shape, position->value, rotation == nullptr ? 0 : rotation->angle};
}

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
    Position const* const position = propertyOf<Position>(store, first);
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
