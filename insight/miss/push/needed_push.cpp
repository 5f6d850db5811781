#include "insight/miss/push/needed_push.hpp"

#include "insight/miss/idle_devices.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/joint_anchors.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "physics/dynamics/properties/shapes/placed_shape.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace trembler::insight {
namespace needed_push {
namespace {

using load::Body;
using load::Group;

constexpr double closed = 5e-4;     // m: a gap as narrow as this is closed
constexpr double farthestSlide = 1; // m
constexpr double farthestTurn = pi; // rad
constexpr double leastForce = 0.01; // N: less is not lacking
constexpr int looks = 16;           // at the forces, over the way

/// One of the two ends of a joint: a body of the group, or something fixed.
struct End {
    ObjectId object; ///< invalid: the world
    Vec2 local;      ///< m, in its frame
};

struct Spring {
    Vec2 own;   ///< m, in the world, on the group before it moves
    Vec2 other; ///< m, in the world, fixed
    double length = 0;
    double stiffness = 0;
};

/// What moves as one along a way of one dimension, and the forces on it.
struct Guided {
    Group group;
    bool turns = false;
    Vec2 axis;  ///< of a slider: unit
    Vec2 pivot; ///< of a hinge: m, in the world
    std::vector<Spring> springs;

    /// Where a point of the group is after it has moved by q, m or rad.
    [[nodiscard]] Vec2 moved(Vec2 point, double q) const {
        return turns ? pivot + rotated(point - pivot, q) : point + q * axis;
    }
    /// The change of that place with q.
    [[nodiscard]] Vec2 way(Vec2 point) const { return turns ? perpendicular(point - pivot) : axis; }
};

/// Of the rectangle around a body, in the world.
std::array<Vec2, 4> cornersOf(Body const& body) {
    auto const [low, high] = extentOf({*body.shape, body.pose.at, body.angle});
    return {low, high, Vec2{low.x, high.y}, Vec2{high.x, low.y}};
}

bool isFixed(World const& world, ObjectId id) {
    return !id.valid() || world.find<Fixed>(id) != nullptr;
}

Vec2 inWorld(World const& world, End const& end) {
    Position const* const position = end.object.valid() ? world.find<Position>(end.object) : nullptr;
    Rotation const* const rotation = end.object.valid() ? world.find<Rotation>(end.object) : nullptr;
    return position == nullptr
               ? end.local
               : position->value + rotated(end.local, rotation == nullptr ? 0 : rotation->angle);
}

/// Nothing if the object is not held as neededPush() requires.
std::optional<Guided> guidedOf(World const& world, load::Neighbours const& neighbours, ObjectId object) {
    Guided made;
    made.group = load::groupOf(world, neighbours, object);
    std::set<ObjectId> own;
    for (Body const& body : made.group.bodies) {
        own.insert(body.id);
    }
    auto const* const joints = world.store().findColumn<Joint>();
    auto const* const anchors = world.store().findColumn<JointAnchors>();
    if (own.empty() || joints == nullptr || anchors == nullptr) {
        return std::nullopt;
    }
    int guides = 0;
    for (ObjectId const id : joints->owners()) {
        Joint const& joint = *joints->find(id);
        JointAnchors const* const at = anchors->find(id);
        bool const aOwn = own.contains(joint.a);
        bool const bOwn = own.contains(joint.b);
        if (!aOwn && !bOwn) {
            continue;
        }
        if (aOwn && bOwn) {
            if (joint.form != JointForm::weld) {
                return std::nullopt;
            }
            continue;
        }
        if (at == nullptr || !isFixed(world, aOwn ? joint.b : joint.a)) {
            return std::nullopt;
        }
        End const ends[2] = {{joint.a, at->onA}, {joint.b, at->onB}};
        Vec2 const mine = inWorld(world, ends[aOwn ? 0 : 1]);
        Vec2 const other = inWorld(world, ends[aOwn ? 1 : 0]);
        if (joint.form == JointForm::spring) {
            made.springs.push_back({mine, other, at->length, joint.stiffness});
            continue;
        }
        if ((joint.form != JointForm::slider && joint.form != JointForm::hinge) || joint.motor) {
            return std::nullopt;
        }
        ++guides;
        made.turns = joint.form == JointForm::hinge;
        made.pivot = other;
        Rotation const* const frame = joint.b.valid() ? world.find<Rotation>(joint.b) : nullptr;
        made.axis = rotated(at->axis, frame == nullptr ? 0 : frame->angle);
    }
    return guides == 1 ? std::optional(std::move(made)) : std::nullopt;
}

/// How far it has to move, m or rad with a sign, until the two touch; nothing if they do not.
std::optional<double> wayTo(World const& world, Guided const& guided, Body const& mover, ObjectId other) {
    auto const target = placedShapeOf(world.store(), other);
    if (!target) {
        return std::nullopt;
    }
    double reach = 0.01; // m, of the mover from the pivot
    for (Vec2 const corner : cornersOf(mover)) {
        reach = std::max(reach, length(corner - guided.pivot));
    }
    std::optional<double> best;
    for (double const sign : {1.0, -1.0}) {
        double const farthest = guided.turns ? farthestTurn : farthestSlide;
        for (double q = 0; q < best.value_or(farthest);) {
            PlacedShape const there{*mover.shape, guided.moved(mover.pose.at, sign * q),
                                    mover.angle + (guided.turns ? sign * q : 0)};
            double const width = gapBetween(there, *target).width;
            if (width < closed) {
                best = q;
                break;
            }
            q += guided.turns ? width / reach : width; // it cannot come nearer than by that
        }
        if (best) {
            return sign * *best; // the other way round would be longer, or a way through something
        }
    }
    return std::nullopt;
}

/// N along the way, or N m about the pivot, of all that acts on it when it has moved by q, in the direction
/// of rising q.
double acting(Guided const& guided, std::vector<Body> const& carried, double q) {
    double sum = 0;
    for (std::vector<Body> const* const bodies : {&guided.group.bodies, &carried}) {
        for (Body const& body : *bodies) {
            sum += dot(body.weight, guided.way(guided.moved(body.centre, q)));
        }
    }
    for (Spring const& spring : guided.springs) {
        Vec2 const at = guided.moved(spring.own, q);
        Vec2 const along = at - spring.other;
        double const now = length(along);
        if (now > 0) {
            sum += dot(-spring.stiffness * (now - spring.length) / now * along, guided.way(at));
        }
    }
    return sum;
}

/// The body that is farthest against the push, or farthest from the pivot: there it is pushed.
Body const& outermost(Guided const& guided, double sign) {
    auto const out = [&](Body const& body) {
        if (guided.turns) {
            return length(body.centre - guided.pivot);
        }
        double most = -std::numeric_limits<double>::infinity();
        for (Vec2 const corner : cornersOf(body)) {
            most = std::max(most, dot(corner, -sign * guided.axis));
        }
        return most;
    };
    return *std::max_element(guided.group.bodies.begin(), guided.group.bodies.end(),
                             [&](Body const& a, Body const& b) { return out(a) < out(b); });
}

bool isTouched(World const& world, load::Neighbours const& neighbours, Group const& group) {
    return std::any_of(group.bodies.begin(), group.bodies.end(), [&](Body const& body) {
        auto const touching = neighbours.touching(body.id);
        return std::any_of(touching.begin(), touching.end(), [&](load::Neighbour const& one) {
            bool const own = std::any_of(group.bodies.begin(), group.bodies.end(),
                                         [&](Body const& other) { return other.id == one.other; });
            return !own && !isFixed(world, one.other);
        });
    });
}

std::optional<NeededPush> pushOn(World const& world, load::Neighbours const& neighbours, ObjectId mover,
                                 ObjectId other) {
    std::optional<Guided> const guided = guidedOf(world, neighbours, mover);
    if (!guided) {
        return std::nullopt;
    }
    std::vector<Body> const& bodies = guided->group.bodies;
    auto const own =
        std::find_if(bodies.begin(), bodies.end(), [&](Body const& body) { return body.id == mover; });
    bool const bothMove =
        std::any_of(bodies.begin(), bodies.end(), [&](Body const& body) { return body.id == other; });
    std::optional<double> const way =
        own == bodies.end() || bothMove ? std::nullopt : wayTo(world, *guided, *own, other);
    if (!way) {
        return std::nullopt;
    }
    double const sign = *way < 0 ? -1 : 1;
    std::vector<ObjectId> ids;
    for (Body const& body : bodies) {
        ids.push_back(body.id);
    }
    if (!idleDevicesOf(world, ids).empty()) {
        return std::nullopt; // a relay's armature: its coil should move it
    }
    Body const& pushed = outermost(*guided, sign);
    double const lever = guided->turns ? length(pushed.centre - guided->pivot) : 1;
    Vec2 const up = -bodies.front().weight / length(bodies.front().weight);
    std::vector<Body> const carried = load::carriedBy(world, neighbours, bodies, up);
    double least = 0;
    for (int i = 0; i <= looks; ++i) {
        least = std::min(least, sign * acting(*guided, carried, *way * i / looks));
    }
    NeededPush push;
    push.body = pushed.id;
    push.direction = sign * guided->way(guided->moved(pushed.centre, 0.5 * *way));
    push.direction = push.direction / length(push.direction);
    push.force = -least / lever;
    push.turn = guided->turns ? std::abs(*way) : 0;
    push.touched = isTouched(world, neighbours, guided->group);
    return lever > 0 && push.force > leastForce ? std::optional(push) : std::nullopt;
}

} // namespace
} // namespace needed_push

std::optional<NeededPush> neededPush(World const& world, load::Neighbours const& neighbours,
                                     CircuitGap const& gap) {
    if (gap.reason != GapReason::apart) {
        return std::nullopt;
    }
    std::optional<NeededPush> const push = needed_push::pushOn(world, neighbours, gap.a, gap.b);
    return push ? push : needed_push::pushOn(world, neighbours, gap.b, gap.a);
}

} // namespace trembler::insight
