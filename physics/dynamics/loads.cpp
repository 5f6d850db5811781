#include "physics/dynamics/loads.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double relativeChange = 0.002;
constexpr double weightFraction = 1e-6;
constexpr double standardGravity = 9.80665; // m/s²

bool differs(Load const& now, Load const& then, Body const& body) {
    double const slack = relativeChange * length(then.force) + weightFraction * body.mass * standardGravity;
    double const gyration = std::sqrt(body.inertia / body.mass);
    double const turningSlack = relativeChange * std::abs(then.torque) + slack * gyration;
    return length(now.force - then.force) > slack || std::abs(now.torque - then.torque) > turningSlack;
}

Load bounded(Load load, Body const& body) {
    double const force = length(load.force);
    if (force > body.mass * maximumAcceleration) {
        load.force *= body.mass * maximumAcceleration / force;
    }
    double const most = body.inertia * maximumAngularAcceleration;
    load.torque = std::min(std::max(load.torque, -most), most);
    return load;
}

} // namespace

void LoadTable::clear(std::size_t slots) {
    loads_.assign(slots, {});
}

void LoadTable::apply(std::span<Body const> bodies, Engine& engine) {
    for (SlotIndex slot = 0; slot < loads_.size(); ++slot) {
        if (!bodies[slot].fixed && bodies[slot].object.valid()) {
            loads_[slot] = bounded(loads_[slot], bodies[slot]);
        }
    }
    engine.setLoads(loads_);
    for (SlotIndex slot = 0; slot < loads_.size() && slot < asleep_.size(); ++slot) {
        if (asleep_[slot] != 0 && bodies[slot].object.valid() &&
            differs(loads_[slot], atRest_[slot], bodies[slot])) {
            engine.wake(slot);
        }
    }
}

void LoadTable::noteSleepers(Engine const& engine) {
    std::span<std::uint8_t const> const awake = engine.awake();
    asleep_.resize(awake.size(), 0);
    atRest_.resize(awake.size());
    loads_.resize(awake.size());
    for (MovedBody const& moved : engine.moved()) {
        asleep_[moved.slot] = awake[moved.slot] == 0 ? 1 : 0;
        if (asleep_[moved.slot] != 0) {
            atRest_[moved.slot] = loads_[moved.slot];
        }
    }
}

} // namespace trembler
