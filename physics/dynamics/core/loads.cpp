#include "physics/dynamics/core/loads.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double relativeChange = 0.002;
constexpr double muchChange = 0.125;
// Box2D and Chipmunk regard a body slower than 0.01 m/s as at rest.
constexpr double leastAcceleration = 1e-5; // m/s²

// Sums of huge forces may not be finite.
double tame(double value) {
    return std::isfinite(value) ? std::clamp(value, -1e100, 1e100) : 0;
}

Load bounded(Load load, Body const& body) {
    load = {{tame(load.force.x), tame(load.force.y)}, tame(load.torque), load.varies};
    double const force = length(load.force);
    if (force > body.mass * maximumAcceleration) {
        load.force *= body.mass * maximumAcceleration / force;
    }
    double const most = body.inertia * maximumAngularAcceleration;
    load.torque = std::min(std::max(load.torque, -most), most);
    return load;
}

} // namespace

bool LoadTable::differs(LoadSum const& now, Load const& then, Body const& body) {
    double const slack = relativeChange * now.gross + leastAcceleration * body.mass;
    double const gyration = std::sqrt(body.inertia / body.mass);
    double const turningSlack = relativeChange * std::abs(then.torque) + slack * gyration;
    return length(now.load.force - then.force) > slack ||
           std::abs(now.load.torque - then.torque) > turningSlack;
}

void LoadTable::clear(std::size_t slots) {
    sums_.assign(slots, {});
    drags_.clear();
}

void LoadTable::apply(std::span<Body const> bodies, Engine& engine) {
    loads_.assign(sums_.size(), {});
    for (SlotIndex slot = 0; slot < sums_.size(); ++slot) {
        if (!bodies[slot].fixed && bodies[slot].object.valid()) {
            loads_[slot] = sums_[slot].load = bounded(sums_[slot].load, bodies[slot]);
        }
    }
    engine.setLoads(loads_);
    engine.setDrags(drags_);
    for (SlotIndex slot = 0; slot < sums_.size() && slot < asleep_.size(); ++slot) {
        if (asleep_[slot] != 0 && bodies[slot].object.valid() &&
            differs(sums_[slot], atRest_[slot], bodies[slot])) {
            engine.wake(slot);
        }
    }
}

bool LoadTable::changedMuch() {
    bool much = known_.size() > sums_.size();
    known_.resize(sums_.size());
    for (std::size_t slot = 0; slot < sums_.size() && !much; ++slot) {
        double const gross = std::max(sums_[slot].gross, known_[slot].gross);
        much = length(sums_[slot].load.force - known_[slot].load.force) > muchChange * gross;
    }
    if (much) {
        known_ = sums_;
    }
    return much;
}

void LoadTable::noteSleepers(Engine const& engine, bool sleeping) {
    std::span<std::uint8_t const> const awake = engine.awake();
    asleep_.resize(awake.size(), 0);
    atRest_.resize(awake.size());
    loads_.resize(awake.size());
    if (!sleeping && !anyAsleep_) {
        return;
    }
    anyAsleep_ = true;
    for (MovedBody const& moved : engine.moved()) {
        asleep_[moved.slot] = awake[moved.slot] == 0 ? 1 : 0;
        if (asleep_[moved.slot] != 0) {
            atRest_[moved.slot] = loads_[moved.slot];
        }
    }
}

} // namespace trembler
