#include "insight/search/thing.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"

#include <algorithm>

namespace trembler::insight {

double distance(Outline const& a, Outline const& b) {
    double const x = std::max({0.0, a.low.x - b.high.x, b.low.x - a.high.x});
    double const y = std::max({0.0, a.low.y - b.high.y, b.low.y - a.high.y});
    return length(Vec2{x, y});
}

Outline outlineOf(std::span<Vec2 const> points) {
    Outline outline{points.front(), points.front()};
    for (Vec2 const p : points) {
        outline.low = {std::min(outline.low.x, p.x), std::min(outline.low.y, p.y)};
        outline.high = {std::max(outline.high.x, p.x), std::max(outline.high.y, p.y)};
    }
    return outline;
}

std::optional<Outline> outlineOf(PartLibrary const& parts, Placement const& placement) {
    std::vector<Vec2> corners;
    for (PlacedPiece const& piece : placedPieces(parts, placement)) {
        Shape const* const shape = piece.properties.find<Shape>();
        Position const* const position = piece.properties.find<Position>();
        Rotation const* const rotation = piece.properties.find<Rotation>();
        if (shape != nullptr && position != nullptr) {
            auto const [low, high] =
                extentOf({*shape, position->value, rotation == nullptr ? 0 : rotation->angle});
            corners.push_back(low);
            corners.push_back(high);
        }
    }
    return corners.empty() ? std::nullopt : std::optional(outlineOf(corners));
}

std::vector<Thing> thingsIn(World const& world) {
    std::vector<Thing> things;
    auto const* const shapes = world.store().findColumn<Shape>();
    auto const* const positions = world.store().findColumn<Position>();
    if (shapes == nullptr || positions == nullptr) {
        return things;
    }
    std::vector<std::pair<ObjectId, Thing>> found;
    forEach(
        [&](ObjectId id, Shape const& shape, Position const& position) {
            Rotation const* const rotation = world.find<Rotation>(id);
            auto const [low, high] =
                extentOf({shape, position.value, rotation == nullptr ? 0 : rotation->angle});
            Thing thing;
            thing.name = world.store().nameOf(id);
            if (Prototype const* const part = world.store().prototypeOf(id)) {
                thing.part = part->name;
            }
            thing.at = position.value;
            thing.outline = {low, high};
            thing.liquid = world.find<Liquid>(id) != nullptr;
            thing.movable = !thing.liquid && world.find<Fixed>(id) == nullptr;
            thing.conductor = world.find<Conductor>(id) != nullptr;
            MagneticStrength const* const magnetic = world.find<MagneticStrength>(id);
            thing.magnet = magnetic != nullptr && magnetic->strength > 0;
            found.emplace_back(id, std::move(thing));
        },
        *shapes, *positions);
    std::sort(found.begin(), found.end(), [](auto const& a, auto const& b) { return a.first < b.first; });
    for (auto& [id, thing] : found) {
        things.push_back(std::move(thing));
    }
    return things;
}

} // namespace trembler::insight
