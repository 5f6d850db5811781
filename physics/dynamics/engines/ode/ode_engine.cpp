#ifdef TREMBLER_HAS_ODE
#include "physics/dynamics/engines/ode/ode_engine.hpp"

#include "physics/dynamics/engines/ode/ode_dynamics.hpp"
#include "runtime/component/component.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trembler {
namespace {

constexpr double jointCorrection = 0.4; // share of a position error that is corrected in one substep
// For overlapping bodies, m/s: small, because ODE keeps the correction as velocity.
constexpr double fastestOdeCorrection = 0.25;
constexpr std::size_t mostRowsSolvedExactly = 150;
constexpr int sweepsPerIteration = 12; // many, because ODE's relaxation has no warm start
// Limits of rows times sweeps in a substep, about 5 ms, and in all substeps of a frame, about 50 ms. Above
// them there are fewer sweeps, but at least fewestSweeps.
constexpr double mostWork = 300000;
constexpr double mostWorkInFrame = 3000000;
constexpr double fewestSweeps = 16;

} // namespace

OdeEngine::OdeEngine(double scale) : contacts_(dJointGroupCreate(0)), finder_(scale) {
    dWorldID const world = world_.get();
    dWorldSetGravity(world, 0, 0, 0); // gravity is a force like others
    dWorldSetERP(world, jointCorrection);
    dWorldSetContactMaxCorrectingVel(world, fastestOdeCorrection);
    dWorldSetContactSurfaceLayer(world, skinDepth);
    dWorldSetAutoDisableFlag(world, 0);
}

void OdeEngine::makeBody(SlotIndex slot, BodySpec const& spec) {
    if (motions_.size() <= slot) {
        motions_.resize(slot + std::size_t{1});
        ids_.resize(slot + std::size_t{1});
    }
    motions_[slot] = spec.motion;
    if (!spec.fixed) {
        dBodyID const body = dBodyCreate(world_.get());
        ids_[slot].reset(body);
        dMass mass;
        double const inertia = spec.mass * spec.spread.inertiaPerMass;
        dMassSetParameters(&mass, spec.mass, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
        dBodySetMass(body, &mass);
        dBodySetGyroscopicMode(body, 0);
        sync(slot);
    }
    finder_.add(slot, spec);
}

void OdeEngine::dropBody(SlotIndex slot) {
    finder_.remove(slot);
    ids_[slot].reset();
}

void OdeEngine::sync(SlotIndex slot) {
    dBodyID const body = ids_[slot].get();
    Motion const& motion = motions_[slot];
    dBodySetPosition(body, motion.centre.x, motion.centre.y, 0);
    dQuaternion const turned{std::cos(motion.angle / 2), 0, 0, std::sin(motion.angle / 2)};
    dBodySetQuaternion(body, turned);
    dBodySetLinearVel(body, motion.velocity.x, motion.velocity.y, 0);
    dBodySetAngularVel(body, 0, 0, motion.spin);
}

void OdeEngine::setMotion(SlotIndex slot, Motion const& motion) {
    motions_[slot] = motion;
    finder_.place(slot, motion.centre, motion.angle);
    if (ids_[slot]) {
        sync(slot);
        return;
    }
    for (auto const& joined : joined_) { // fixed bodies are part of ODE's world
        if (joined && (joined->a == slot || joined->b == slot)) {
            attach(*joined);
        }
    }
}

void OdeEngine::rouse(SlotIndex slot) {
    dBodyEnable(ids_[slot].get());
}

void OdeEngine::layToRest(std::span<SlotIndex const> island) {
    for (SlotIndex const slot : island) {
        dBodyDisable(ids_[slot].get());
    }
}

void OdeEngine::move(double h, DynamicsSettings const& settings, std::vector<PieceContact>& found) {
    findTouches();
    for (SlotIndex const slot : awakeSlots_) {
        accelerate(slot, motions_[slot], h);
    }
    solveRows(h, settings.velocityIterations);
    for (SlotIndex const slot : awakeSlots_) {
        sync(slot);
    }
    addContacts(h);
    prepareJoints(h);
    if (largestIsland() <= mostRowsSolvedExactly) {
        world_.stepExactly(h);
    } else {
        world_.stepQuickly(h, sweepsFor(settings.velocityIterations, h));
    }
    reportContacts(h, found);
    noteJointImpulses(h);
    dJointGroupEmpty(contacts_.get());
    for (SlotIndex const slot : awakeSlots_) {
        readBack(slot, h);
    }
}

void OdeEngine::readBack(SlotIndex slot, double h) {
    Motion& motion = motions_[slot];
    Motion const before = motion;
    dReal const* const velocity = dBodyGetLinearVel(ids_[slot].get());
    dReal const* const spin = dBodyGetAngularVel(ids_[slot].get());
    motion.velocity = {velocity[0], velocity[1]};
    motion.spin = spin[2];
    if (!isFinite(motion.velocity) || !std::isfinite(motion.spin)) { // a singular system has no solution
        motion = before;
        motion.velocity = {};
        motion.spin = 0;
    }
    double const speed = length(motion.velocity);
    if (speed > maximumSpeed) {
        motion.velocity *= maximumSpeed / speed;
    }
    motion.spin = std::clamp(motion.spin, -maximumSpeed, maximumSpeed);
    Vec2 const way = h * motion.velocity;
    motion.centre += freeShare(slot, before, way) * way;
    motion.angle += h * motion.spin;
    finder_.place(slot, motion.centre, motion.angle);
    sync(slot);
}

double OdeEngine::freeShare(SlotIndex slot, Motion const& from, Vec2 way) const {
    BodyEntry const& entry = bodies()[slot];
    if (length(way) <= entry.core.reach()) {
        return 1;
    }
    return finder_.freeShare(from.centre + rotated(entry.core.at, from.angle), entry.core.radius, way,
                             [&](SlotIndex other) {
                                 return other != slot && (bodies()[other].fixed || entry.bullet) &&
                                        mayTouch(std::min(slot, other), std::max(slot, other));
                             });
}

int OdeEngine::sweepsFor(int iterations, double h) const {
    auto const rows = static_cast<double>(std::accumulate(rowsOf_.begin(), rowsOf_.end(), std::size_t{1}));
    double const work = std::min(mostWork, mostWorkInFrame * h / frameDuration);
    double const wanted = sweepsPerIteration * iterations;
    return static_cast<int>(std::min(wanted, std::max(std::floor(work / rows), fewestSweeps)));
}

std::size_t OdeEngine::largestIsland() {
    parents_.resize(motions_.size());
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    rowsOf_.assign(motions_.size(), 0);
    auto const rootOf = [&](std::size_t slot) {
        while (parents_[slot] != slot) {
            slot = parents_[slot] = parents_[parents_[slot]];
        }
        return slot;
    };
    auto const link = [&](SlotIndex a, SlotIndex b) {
        if (moves(a) && moves(b)) {
            parents_[rootOf(a)] = rootOf(b);
        }
    };
    for (std::size_t i = 0; i < touches_.size(); ++i) {
        if (pressing_[i] != 0) {
            link(touches_[i].a, touches_[i].b);
        }
    }
    for (auto const& joined : joined_) {
        if (joined && (joined->main || joined->drive)) {
            link(joined->a, joined->b);
        }
    }
    auto const count = [&](SlotIndex a, SlotIndex b, int rows) {
        SlotIndex const slot = moves(a) ? a : b;
        rowsOf_[rootOf(slot)] += static_cast<std::size_t>(rows);
    };
    for (std::size_t i = 0; i < touches_.size(); ++i) {
        if (pressing_[i] != 0) {
            count(touches_[i].a, touches_[i].b, 2 * touches_[i].count);
        }
    }
    for (auto const& joined : joined_) {
        if (joined && joined->main) {
            bool const line =
                joined->joint.form == JointForm::distance || joined->joint.form == JointForm::spring;
            count(joined->a, joined->b, line ? 1 : 6);
        }
    }
    return rowsOf_.empty() ? 0 : *std::max_element(rowsOf_.begin(), rowsOf_.end());
}

std::unique_ptr<Engine> makeOdeEngine(double scale) {
    return std::make_unique<OdeEngine>(scale);
}

} // namespace trembler
#endif
