#include "physics/dynamics/properties/shapes/placed_shape.hpp"

#include "runtime/placement.hpp"
#include "runtime/world/entry.hpp"

namespace trembler {

std::optional<PlacedShape> placedShapeOf(Store const& store, ObjectId object) {
    Shape const* const shape = entryOf<Shape>(store, object);
    Position const* const position = entryOf<Position>(store, object);
    if (shape == nullptr || position == nullptr || shape->pieces.empty()) {
        return std::nullopt;
    }
    Rotation const* const rotation = entryOf<Rotation>(store, object);
    return PlacedShape{*shape, position->value, rotation == nullptr ? 0 : rotation->angle};
}

} // namespace trembler
