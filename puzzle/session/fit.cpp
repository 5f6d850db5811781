#include "puzzle/session/fit.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/overlap.hpp"
#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

CollisionGroups groupsOf(CollisionGroups const* stated) {
    return stated == nullptr ? CollisionGroups{} : *stated;
}

/// Whether joints hold it, all of them springs.
bool onSpringsOnly(World const& world, ObjectId id) {
    auto const* const joints = world.store().findColumn<Joint>();
    bool held = false;
    bool springs = true;
    if (joints != nullptr) {
        forEach(
            [&](ObjectId, Joint const& joint) {
                if (joint.a == id || joint.b == id) {
                    held = true;
                    springs = springs && joint.form == JointForm::spring;
                }
            },
            *joints);
    }
    return held && springs;
}

/// Whether two shapes are of one kind that hits nothing but its own kind and hangs on springs, as the contact
/// rings of two cogs: those are there to be pressed together, and give way.
bool giveWay(World const& world, ObjectId id, CollisionGroups const& there,
             CollisionGroups const& candidate) {
    bool const apart = there.category == there.mask && (there.category & CollisionGroups{}.category) == 0;
    return apart && there.group == 0 && candidate == there && onSpringsOnly(world, id);
}

/// Names the object that one shape would overlap.
std::optional<std::string> overlapped(World const& world, PlacedShape const& candidate,
                                      CollisionGroups const& groups, std::span<ObjectId const> ignored) {
    auto const* const shapes = world.store().findColumn<Shape>();
    auto const* const positions = world.store().findColumn<Position>();
    if (shapes == nullptr || positions == nullptr) {
        return {};
    }
    auto const [lowest, highest] = extentOf(candidate);
    Vec2 const lower = lowest; // clang 14 lets no lambda use the names above
    Vec2 const upper = highest;
    std::optional<std::string> why;
    forEach(
        [&](ObjectId id, Shape const& other, Position const& position) {
            if (why || std::find(ignored.begin(), ignored.end(), id) != ignored.end()) {
                return;
            }
            CollisionGroups const otherGroups = groupsOf(world.find<CollisionGroups>(id));
            if (!canHit(groups, otherGroups) || world.find<Liquid>(id) != nullptr) {
                return; // nothing can collide with a board in the background, or with water
            }
            Rotation const* const rotation = world.find<Rotation>(id);
            PlacedShape const there{other, position.value, rotation == nullptr ? 0 : rotation->angle};
            auto const [low, high] = extentOf(there);
            bool const near = low.x < upper.x && lower.x < high.x && low.y < upper.y && lower.y < high.y;
            if (near && overlap(candidate, there, allowedOverlap) &&
                !giveWay(world, id, otherGroups, groups)) {
                std::string const name = world.store().nameOf(id);
                bool const numbered = !name.empty() && name.back() >= '0' && name.back() <= '9';
                why = numbered ? fmt::format("it would overlap {}", name) // "spanner 1"
                               : fmt::format("it would overlap the {}", name);
            }
        },
        *shapes, *positions);
    return why;
}

} // namespace

std::optional<std::string> whyItDoesNotFit(World const& world, PartLibrary const& parts,
                                           Placement const& placement, std::span<ObjectId const> ignored) {
    for (PlacedPiece const& piece : placedPieces(parts, placement)) {
        Shape const* const shape = piece.properties.find<Shape>();
        Position const* const position = piece.properties.find<Position>();
        Rotation const* const rotation = piece.properties.find<Rotation>();
        if (shape == nullptr || position == nullptr) {
            continue;
        }
        PlacedShape const candidate{*shape, position->value, rotation == nullptr ? 0 : rotation->angle};
        CollisionGroups const groups = groupsOf(piece.properties.find<CollisionGroups>());
        if (auto why = overlapped(world, candidate, groups, ignored)) {
            return why;
        }
    }
    return {};
}

} // namespace trembler
