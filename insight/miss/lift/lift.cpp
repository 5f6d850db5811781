#include "insight/miss/lift/lift.hpp"

#include "insight/miss/lift/liquids.hpp"
#include "insight/miss/lift/load.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/results.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trembler::insight {
namespace {

using load::ActingForce;
using load::Body;
using load::Group;
using load::Liquids;
using load::Neighbours;

constexpr double leastRise = 1e-3;  // m: an object that should be higher by less is where it should be
constexpr double leastShare = 0.01; // of the weight: less is not reported
constexpr double leastSlope = 0.01; // of the way: less is level
constexpr double leastLever = 0.1;  // of the width: a force that acts nearer to the middle turns little

/// The sums of forces along `up`, and of their torques.
struct LiftSum {
    double force = 0;  ///< N
    double torque = 0; ///< N m
    void add(ActingForce const& one, Vec2 up, Vec2 about) {
        force += dot(one.force, up);
        torque += cross(one.at - about, one.force);
    }
};

/// Adds what liquids lack to the misses of a world.
class LiftShortage {
public:
    /// `gravity`: m/s², not 0.
    LiftShortage(World const& world, Vec2 gravity, Rise rise)
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
    // Made for the first object that should be higher: mostly there is none.
    std::optional<Liquids> liquids_;
    std::optional<Neighbours> neighbours_;
};

/// For the way that one object lacks; returns whether anything was added.
bool LiftShortage::addOf(Miss& miss, ObjectId mover, Vec2 way) {
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
    Group const group = load::groupOf(world_, *neighbours_, mover);
    if (group.bodies.empty()) {
        return false;
    }
    std::vector<Body> const carried = load::carriedBy(world_, *neighbours_, group.bodies, up);
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
    LiftSum lift;    // where it should be
    LiftSum righted; // where it is
    LiftSum loaded;
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
        loaded.add({body.weight, body.centre}, up, about);
        for (ActingForce const& force : liquids.on(body, {})) {
            loaded.add(force, up, about);
        }
    }
    double const down = weights - loaded.force;
    other.from = about;
    other.to = about;
    if (double const missing = down - lift.force; missing > leastShare * down) {
        other.lack = Lack::lift;
        other.by = missing;
        miss.besides.push_back(other);
    }
    double const turning = loaded.torque + righted.torque;
    bool const over = turning * loaded.torque > 0 && group.welded && !carried.empty();
    if (over && std::abs(turning) > leastLever * load::widthOf(group.bodies, up) * down) {
        other.lack = Lack::torque;
        other.by = std::abs(turning);
        miss.besides.push_back(other);
    }
    return true;
}

void LiftShortage::add(Miss& miss) {
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
        LiftShortage(world, gravity->gravity, rise).add(miss);
    }
}

} // namespace trembler::insight
