#include "insight/miss/lift/load.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

namespace trembler::insight::load {
namespace {

constexpr double steepest = 0.5; // the cosine of the slope on which something still lies

std::optional<Body> bodyOf(World const& world, ObjectId id) {
    Shape const* const shape = world.find<Shape>(id);
    Position const* const position = world.find<Position>(id);
    auto const* const gravity = world.find<GravityForce>();
    if (shape == nullptr || position == nullptr || gravity == nullptr || shape->pieces.empty() ||
        faultIn(*shape) || world.find<Fixed>(id) != nullptr || world.find<Liquid>(id) != nullptr) {
        return std::nullopt;
    }
    auto const weight = std::lower_bound( // they are ascending
        gravity->forces.begin(), gravity->forces.end(), id,
        [](GravityForce::Entry const& entry, ObjectId wanted) { return entry.object < wanted; });
    if (weight == gravity->forces.end() || weight->object != id) {
        return std::nullopt;
    }
    Rotation const* const rotation = world.find<Rotation>(id);
    double const angle = rotation == nullptr ? 0 : rotation->angle;
    Pose const pose(position->value, angle);
    return Body{id, shape, pose, angle, pose.toWorld(centreOfMass(*shape)), weight->force};
}

/// The neighbours of one object, in the order in which they were added.
std::span<Neighbour const> neighboursOf(std::vector<Neighbour> const& all, ObjectId id) {
    auto const before = [](Neighbour const& a, Neighbour const& b) { return a.of < b.of; };
    auto const [first, last] = std::equal_range(all.begin(), all.end(), Neighbour{id, {}, false}, before);
    return {first, last};
}

void add(std::vector<Neighbour>& to, ObjectId a, ObjectId b, bool welded) {
    to.push_back({a, b, welded});
    to.push_back({b, a, welded});
}

/// Whether one body lies on another that it touches.
bool liesOn(Body const& above, Body const& below, Vec2 up) {
    Shape const point{{circlePiece(1e-3)}};
    ShapeGap const gap = gapBetween({*below.shape, below.pose.at, below.angle}, {point, above.centre, 0});
    Vec2 const way = above.centre - gap.a;
    double const distance = length(way);
    return distance > 0 && dot(way, up) > steepest * distance;
}

} // namespace

Neighbours::Neighbours(World const& world) {
    if (auto const* const joints = world.store().findColumn<Joint>()) {
        for (ObjectId const joint : joints->owners()) {
            Joint const& one = *joints->find(joint);
            add(tied_, one.a, one.b, one.form == JointForm::weld && one.a.valid() && one.b.valid());
        }
    }
    if (auto const* const contacts = world.find<Contacts>()) {
        for (TouchingPair const& pair : contacts->current) {
            add(touching_, pair.a, pair.b, false);
        }
    }
    for (std::vector<Neighbour>* const all : {&tied_, &touching_}) {
        std::stable_sort(all->begin(), all->end(),
                         [](Neighbour const& a, Neighbour const& b) { return a.of < b.of; });
    }
}
std::span<Neighbour const> Neighbours::tiedTo(ObjectId id) const {
    return neighboursOf(tied_, id);
}

std::span<Neighbour const> Neighbours::touching(ObjectId id) const {
    return neighboursOf(touching_, id);
}

Group groupOf(World const& world, Neighbours const& neighbours, ObjectId id) {
    Group group;
    std::vector<ObjectId> open{id};
    std::set<ObjectId> known{id};
    while (!open.empty()) {
        ObjectId const at = open.back();
        open.pop_back();
        std::optional<Body> const body = bodyOf(world, at);
        if (!body) {
            continue; // a fixed object ties nothing together
        }
        group.bodies.push_back(*body);
        for (Neighbour const& one : neighbours.tiedTo(at)) {
            group.welded = group.welded && one.welded;
            if (one.other.valid() && known.insert(one.other).second) {
                open.push_back(one.other);
            }
        }
    }
    return group;
}

std::vector<Body> carriedBy(World const& world, Neighbours const& neighbours, std::vector<Body> const& bodies,
                            Vec2 up) {
    std::vector<Body> carried;
    std::set<ObjectId> known;
    for (Body const& body : bodies) {
        known.insert(body.id);
    }
    std::vector<Body> open = bodies;
    while (!open.empty()) {
        Body const below = open.back();
        open.pop_back();
        for (Neighbour const& one : neighbours.touching(below.id)) {
            ObjectId const other = one.other;
            if (known.contains(other)) {
                continue;
            }
            std::optional<Body> const above = bodyOf(world, other);
            if (above && liesOn(*above, below, up)) {
                known.insert(other);
                carried.push_back(*above);
                open.push_back(*above);
            }
        }
    }
    std::sort(carried.begin(), carried.end(), [](Body const& a, Body const& b) { return a.id < b.id; });
    return carried;
}

double widthOf(std::vector<Body> const& bodies, Vec2 up) {
    Vec2 const across{up.y, -up.x};
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (Body const& body : bodies) {
        auto const [lower, upper] = extentOf({*body.shape, body.pose.at, body.angle});
        for (Vec2 const corner : {lower, upper, Vec2{lower.x, upper.y}, Vec2{upper.x, lower.y}}) {
            least = std::min(least, dot(corner, across));
            most = std::max(most, dot(corner, across));
        }
    }
    return most - least;
}

} // namespace trembler::insight::load
