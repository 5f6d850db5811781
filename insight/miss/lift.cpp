#include "insight/miss/lift.hpp"

#include "physics/buoyancy/hulls/exact_hull.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/mass_properties.hpp"
#include "physics/dynamics/properties/overlap.hpp"
#include "physics/dynamics/properties/shape_order.hpp"
#include "physics/dynamics/properties/shape_rules.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>

namespace trembler::insight {
namespace {

constexpr double leastRise = 1e-3;  // m: what should be higher by less is where it should be
constexpr double leastShare = 0.01; // of the weight, that is worth a word
constexpr double leastSlope = 0.01; // of the way: less is level
constexpr double leastLever = 0.1;  // of the width: a force that acts nearer to the middle turns little
constexpr double steepest = 0.5;    // the cosine of the slope on which something still lies

/// A force in a world with its place.
struct ActingForce {
    Vec2 force;        ///< N
    Vec2 at;           ///< m
    ObjectId liquid{}; ///< whose force it is; invalid: gravity's
};

struct Body {
    ObjectId id;
    Shape const* shape = nullptr;
    Pose pose;
    double angle = 0;
    Vec2 centre; ///< m, of mass, in the world
    Vec2 weight; ///< N
};

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

/// One object of a pair with the other one.
struct Neighbour {
    ObjectId of;
    ObjectId other; ///< invalid: the world
    bool welded = false;
};

/// The neighbours of one object, in the order in which they were added.
std::span<Neighbour const> neighboursOf(std::vector<Neighbour> const& all, ObjectId id) {
    auto const before = [](Neighbour const& a, Neighbour const& b) { return a.of < b.of; };
    auto const [first, last] = std::equal_range(all.begin(), all.end(), Neighbour{id, {}, false}, before);
    return {first, last};
}

/// What is tied to what and touches what, by object: a scene may have many thousand joints and contacts.
class Neighbours {
public:
    explicit Neighbours(World const& world) {
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
    [[nodiscard]] std::span<Neighbour const> tiedTo(ObjectId id) const { return neighboursOf(tied_, id); }
    [[nodiscard]] std::span<Neighbour const> touching(ObjectId id) const {
        return neighboursOf(touching_, id);
    }

private:
    static void add(std::vector<Neighbour>& to, ObjectId a, ObjectId b, bool welded) {
        to.push_back({a, b, welded});
        to.push_back({b, a, welded});
    }
    std::vector<Neighbour> tied_;
    std::vector<Neighbour> touching_;
};

/// A body and all that joints tie it to, through others as well.
struct Group {
    std::vector<Body> bodies;
    bool welded = true; ///< it moves as one
};

Group groupOf(World const& world, Neighbours const& neighbours, ObjectId id) {
    Group group;
    std::vector<ObjectId> open{id};
    std::set<ObjectId> known{id};
    while (!open.empty()) {
        ObjectId const at = open.back();
        open.pop_back();
        std::optional<Body> const body = bodyOf(world, at);
        if (!body) {
            continue; // what is fixed ties nothing together
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

/// Whether one body lies on another that it touches.
bool liesOn(Body const& above, Body const& below, Vec2 up) {
    Shape const point{{circlePiece(1e-3)}};
    ShapeGap const gap = gapBetween({*below.shape, below.pose.at, below.angle}, {point, above.centre, 0});
    Vec2 const way = above.centre - gap.a;
    double const distance = length(way);
    return distance > 0 && dot(way, up) > steepest * distance;
}

/// What lies on the bodies, and on that in turn.
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

/// The liquids of a world.
class Liquids {
public:
    /// `gravity`: m/s².
    Liquids(World const& world, Vec2 gravity) : gravity_(gravity) {
        auto const* const column = world.store().findColumn<Liquid>();
        if (column == nullptr) {
            return;
        }
        for (ObjectId const id : column->owners()) {
            Shape const* const shape = world.find<Shape>(id);
            Position const* const position = world.find<Position>(id);
            if (shape == nullptr || position == nullptr || faultIn(*shape)) {
                continue;
            }
            Rotation const* const rotation = world.find<Rotation>(id);
            Density const* const density = world.find<Density>(id);
            Pose const pose(position->value, rotation == nullptr ? 0 : rotation->angle);
            liquids_.push_back({id, (density == nullptr ? Density{} : *density).value, pose.turned({0, 1}),
                                liquidPieces(inOrder(*shape), pose)});
        }
    }
    /// The forces on a body that is moved by `by`.
    [[nodiscard]] std::vector<ActingForce> on(Body const& body, Vec2 by) const {
        std::vector<ActingForce> forces;
        ExactHull const hull(*body.shape);
        Pose pose = body.pose;
        pose.at += by;
        for (One const& liquid : liquids_) {
            Displacement sum;
            for (LiquidPiece const& piece : liquid.pieces) {
                sum += displacedOf(hull, piece, pose, liquid.up);
            }
            double const strength =
                liquid.density * sum.wet.area * worldDepth * std::max(0.0, -dot(gravity_, liquid.up));
            if (strength <= 0) {
                continue;
            }
            forces.push_back({strength * liquid.up, pose.toWorld(sum.wet.centroid()), liquid.id});
        }
        return forces;
    }

private:
    struct One {
        ObjectId id;
        double density = 0; ///< kg/m³
        Vec2 up;
        std::vector<LiquidPiece> pieces;
    };
    Vec2 gravity_; // m/s²
    std::vector<One> liquids_;
};

/// The sums of forces along `up`, and of their torques.
struct Sum {
    double force = 0;  ///< N
    double torque = 0; ///< N m
    void add(ActingForce const& one, Vec2 up, Vec2 about) {
        force += dot(one.force, up);
        torque += cross(one.at - about, one.force);
    }
};

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

/// Adds what liquids lack to the misses of a world.
class LiftTeller {
public:
    /// `gravity`: m/s², not 0.
    LiftTeller(World const& world, Vec2 gravity, Rise rise)
        : world_(world), gravity_(gravity), up_(-gravity / length(gravity)), rise_(rise) {}

    void add(Miss& miss);

private:
    bool addOf(Miss& miss, ObjectId mover, Vec2 way);
    /// Whether something is to be moved up.
    [[nodiscard]] bool rises(Vec2 way) const {
        double const rise = dot(way, up_);
        double const level = leastSlope * length(way);
        return rise > 0 && rise >= (rise_ == Rise::any ? std::min(leastRise, level) : leastRise);
    }

    World const& world_;
    Vec2 gravity_;
    Vec2 up_;
    Rise rise_;
    // Made for the first one that should be higher: mostly there is none.
    std::optional<Liquids> liquids_;
    std::optional<Neighbours> neighbours_;
};

/// For the way that one object lacks; returns whether anything was added.
bool LiftTeller::addOf(Miss& miss, ObjectId mover, Vec2 way) {
    if (!rises(way)) {
        return false;
    }
    if (!liquids_) {
        liquids_.emplace(world_, gravity_);
        neighbours_.emplace(world_);
    }
    Liquids const& liquids = *liquids_;
    Vec2 const up = up_;
    double const rise = dot(way, up);
    Group const group = groupOf(world_, *neighbours_, mover);
    if (group.bodies.empty()) {
        return false;
    }
    std::vector<Body> const carried = carriedBy(world_, *neighbours_, group.bodies, up);
    Vec2 about;
    double weights = 0;
    for (Body const& body : group.bodies) {
        double const weight = length(body.weight);
        about += weight * body.centre;
        weights += weight;
    }
    if (weights <= 0) {
        return false;
    }
    about = about / weights;
    ObjectId most;
    double greatest = 0;
    Sum lift;    // where it should be
    Sum righted; // where it is
    Sum load;
    for (Body const& body : group.bodies) {
        for (ActingForce const& force : liquids.on(body, rise * up)) {
            lift.add(force, up, about);
            if (length(force.force) > greatest) {
                greatest = length(force.force);
                most = force.liquid;
            }
        }
        for (ActingForce const& force : liquids.on(body, {})) {
            righted.add(force, up, about);
        }
    }
    if (lift.force <= 0) {
        return false; // it should be outside of any liquid
    }
    Miss other;
    other.objects = {most, mover};
    for (Body const& body : group.bodies) {
        if (body.id != mover) {
            other.objects.push_back(body.id);
        }
    }
    for (Body const& body : carried) {
        other.objects.push_back(body.id);
        load.add({body.weight, body.centre}, up, about);
        for (ActingForce const& force : liquids.on(body, {})) {
            load.add(force, up, about);
        }
    }
    double const down = weights - load.force;
    other.from = about;
    other.to = about;
    if (double const missing = down - lift.force; missing > leastShare * down) {
        other.lack = Lack::lift;
        other.by = missing;
        miss.besides.push_back(other);
    }
    double const turning = load.torque + righted.torque;
    bool const over = turning * load.torque > 0 && group.welded && !carried.empty();
    if (over && std::abs(turning) > leastLever * widthOf(group.bodies, up) * down) {
        other.lack = Lack::torque;
        other.by = std::abs(turning);
        miss.besides.push_back(other);
    }
    return true;
}

void LiftTeller::add(Miss& miss) {
    for (Miss& other : miss.besides) {
        add(other);
    }
    if (miss.lack != Lack::distance || miss.objects.empty()) {
        return;
    }
    Vec2 const way = miss.to - miss.from;
    if (!addOf(miss, miss.objects.front(), way) && miss.objects.size() > 1) {
        addOf(miss, miss.objects[1], -1.0 * way);
    }
}

} // namespace

void addLift(Miss& miss, World const& world, Rise rise) {
    auto const* const column = world.store().findColumn<Liquid>();
    auto const* const gravity = world.find<LinearGravityVector>();
    if (column != nullptr && column->size() > 0 && gravity != nullptr && length(gravity->gravity) > 0) {
        LiftTeller(world, gravity->gravity, rise).add(miss);
    }
}

} // namespace trembler::insight
