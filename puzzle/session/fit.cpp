#include "puzzle/session/fit.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/overlap.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

CollisionGroups groupsOf(CollisionGroups const* stated) {
    return stated == nullptr ? CollisionGroups{} : *stated;
}

} // namespace

std::optional<std::string> whyItDoesNotFit(World const& world, PartLibrary const& parts,
                                           Placement const& placement, std::span<ObjectId const> ignored) {
    PartDefinition const* const part = parts.find(placement.part);
    Shape const* const shape = part == nullptr ? nullptr : part->properties.find<Shape>();
    auto const* const shapes = world.store().findColumn<Shape>();
    auto const* const positions = world.store().findColumn<Position>();
    if (shape == nullptr || shapes == nullptr || positions == nullptr) {
        return {};
    }
    CollisionGroups const groups = groupsOf(part->properties.find<CollisionGroups>());
    PlacedShape const candidate{*shape, placement.at, placement.angle};
    auto const [lowest, highest] = extentOf(candidate);
    Vec2 const lower = lowest; // clang 14 lets no lambda use the names above
    Vec2 const upper = highest;
    std::optional<std::string> why;
    forEach(
        [&](ObjectId id, Shape const& other, Position const& position) {
            if (why || std::find(ignored.begin(), ignored.end(), id) != ignored.end()) {
                return;
            }
            if (!canHit(groups, groupsOf(world.find<CollisionGroups>(id))) ||
                world.find<Liquid>(id) != nullptr) {
                return; // nothing can collide with a board in the background, or with water
            }
            Rotation const* const rotation = world.find<Rotation>(id);
            PlacedShape const there{other, position.value, rotation == nullptr ? 0 : rotation->angle};
            auto const [low, high] = extentOf(there);
            bool const near = low.x < upper.x && lower.x < high.x && low.y < upper.y && lower.y < high.y;
            if (near && overlap(candidate, there, allowedOverlap)) {
                why = fmt::format("it would overlap the {}", world.store().nameOf(id));
            }
        },
        *shapes, *positions);
    return why;
}

} // namespace trembler
