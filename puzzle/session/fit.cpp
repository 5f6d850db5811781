#include "puzzle/session/fit.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace trembler {
namespace {

CollisionGroups groupsOf(CollisionGroups const* stated) {
    return stated == nullptr ? CollisionGroups{} : *stated;
}

/// Whether the joints that it was shown hold an object, all of them as springs.
class SpringsOnly {
public:
    void see(Joint const& joint) {
        held_ = true;
        springs_ = springs_ && joint.form == JointForm::spring;
    }
    [[nodiscard]] bool yes() const { return held_ && springs_; }

private:
    bool held_ = false;
    bool springs_ = true;
};

bool onSpringsOnly(World const& world, ObjectId id) {
    SpringsOnly hold;
    if (auto const* const joints = world.store().findColumn<Joint>()) {
        forEach(
            [&](ObjectId, Joint const& joint) {
                if (joint.a == id || joint.b == id) {
                    hold.see(joint);
                }
            },
            *joints);
    }
    return hold.yes();
}

/// The same of a piece of a part that is to be placed, by the part's joints.
bool onSpringsOnly(std::span<PropertySet const> joints, std::size_t piece) {
    SpringsOnly hold;
    for (PropertySet const& properties : joints) {
        Joint const* const joint = properties.find<Joint>();
        if (joint != nullptr && (joint->a.index == piece || joint->b.index == piece)) {
            hold.see(*joint);
        }
    }
    return hold.yes();
}

/// Whether it hits nothing but its own kind, as the contact rings of cogs.
bool hitsItsKindOnly(CollisionGroups const& groups) {
    return groups.group == 0 && groups.category == groups.mask &&
           (groups.category & CollisionGroups{}.category) == 0;
}

/// A piece of the part that is to be placed.
struct FittingPiece {
    PlacedShape shape;
    CollisionGroups groups;
    bool sprung; ///< whether it may press on its own kind, as both give way
};

/// Whether two shapes are of one kind that hits nothing but its own kind, and both hang on springs, as the
/// contact rings of two cogs: those are there to be pressed together, and give way.
bool giveWay(World const& world, ObjectId id, CollisionGroups const& there, FittingPiece const& candidate) {
    return candidate.sprung && candidate.groups == there && onSpringsOnly(world, id);
}

/// Names the object that one shape would overlap.
std::optional<std::string> overlapped(World const& world, FittingPiece const& candidate,
                                      std::span<ObjectId const> ignored) {
    auto const* const shapes = world.store().findColumn<Shape>();
    auto const* const positions = world.store().findColumn<Position>();
    if (shapes == nullptr || positions == nullptr) {
        return {};
    }
    auto const [lowest, highest] = extentOf(candidate.shape);
    Vec2 const lower = lowest; // clang 14 lets no lambda use the names above
    Vec2 const upper = highest;
    std::optional<std::string> why;
    forEach(
        [&](ObjectId id, Shape const& other, Position const& position) {
            if (why || std::find(ignored.begin(), ignored.end(), id) != ignored.end()) {
                return;
            }
            CollisionGroups const otherGroups = groupsOf(world.find<CollisionGroups>(id));
            if (!canHit(candidate.groups, otherGroups) || world.find<Liquid>(id) != nullptr) {
                return; // nothing can collide with a board in the background, or with water
            }
            Rotation const* const rotation = world.find<Rotation>(id);
            PlacedShape const there{other, position.value, rotation == nullptr ? 0 : rotation->angle};
            auto const [low, high] = extentOf(there);
            bool const near = low.x < upper.x && lower.x < high.x && low.y < upper.y && lower.y < high.y;
            if (near && overlap(candidate.shape, there, allowedOverlap) &&
                !giveWay(world, id, otherGroups, candidate)) {
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
    std::vector<PlacedPiece> const pieces = placedPieces(parts, placement);
    std::optional<std::vector<PropertySet>> joints; // of the part, once a piece of it may hang on springs
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        PlacedPiece const& piece = pieces[i];
        Shape const* const shape = piece.properties.find<Shape>();
        Position const* const position = piece.properties.find<Position>();
        Rotation const* const rotation = piece.properties.find<Rotation>();
        if (shape == nullptr || position == nullptr) {
            continue;
        }
        FittingPiece candidate{{*shape, position->value, rotation == nullptr ? 0 : rotation->angle},
                               groupsOf(piece.properties.find<CollisionGroups>()),
                               false};
        if (hitsItsKindOnly(candidate.groups)) {
            if (!joints) {
                joints = placedJoints(parts, placement);
            }
            candidate.sprung = onSpringsOnly(*joints, i);
        }
        if (auto why = overlapped(world, candidate, ignored)) {
            return why;
        }
    }
    return {};
}

} // namespace trembler
