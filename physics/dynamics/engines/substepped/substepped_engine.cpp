#include "physics/dynamics/engines/substepped/substepped_engine.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

bool near(double x, double y) {
    // Tolerance for rounding errors from rotation about a centre.
    return std::abs(x - y) <= 1e-11 * (1 + std::abs(y));
}

bool near(Vec2 x, Vec2 y) {
    return near(x.x, y.x) && near(x.y, y.y);
}

} // namespace

void SubsteppedEngine::addBody(SlotIndex slot, BodySpec const& spec) {
    FailureGuard const guard;
    if (bodies_.size() <= slot) {
        bodies_.resize(slot + std::size_t{1});
        awake_.resize(slot + std::size_t{1}, 0);
        movedMarks_.resize(slot + std::size_t{1}, 0);
    }
    BodyEntry& entry = bodies_[slot];
    entry = {};
    entry.object = spec.object;
    entry.fixed = spec.fixed;
    entry.bullet = spec.bullet;
    entry.mass = spec.fixed ? 0 : spec.mass;
    entry.inertia = spec.fixed ? 0 : spec.mass * spec.spread.inertiaPerMass;
    entry.friction = spec.friction;
    entry.restitution = spec.restitution;
    entry.groups = spec.groups;
    entry.damping = spec.damping;
    entry.core = coreOf(spec);
    entry.extent = extentOf(spec);
    makeBody(slot, spec);
    if (!spec.fixed) {
        awake_[slot] = 1;
        anyAwake_ = true;
    }
}

void SubsteppedEngine::removeBody(SlotIndex slot) {
    FailureGuard const guard;
    std::vector<SlotIndex> neighbours;
    for (PieceContact const& contact : touches_.contacts()) {
        if (contact.slotA == slot || contact.slotB == slot) {
            neighbours.push_back(contact.slotA == slot ? contact.slotB : contact.slotA);
        }
    }
    for (SlotIndex const neighbour : neighbours) {
        wake(neighbour);
    }
    wake(slot);
    touches_.remove(slot);
    dropBody(slot);
    bodies_[slot] = {};
    awake_[slot] = 0;
    if (slot < dragged_.size()) {
        dragged_[slot] = {};
    }
}

void SubsteppedEngine::addJoint(SlotIndex slot, JointSpec const& spec) {
    FailureGuard const guard;
    if (joints_.size() <= slot) {
        joints_.resize(slot + std::size_t{1});
    }
    Joint const& joint = *spec.joint;
    bool const drives =
        joint.form == JointForm::hinge || joint.form == JointForm::slider || joint.form == JointForm::wheel;
    joints_[slot] = {.used = true,
                     .restless = drives && joint.motor && joint.motorSpeed != 0 && joint.motorStrength > 0,
                     .a = spec.a,
                     .b = spec.b,
                     .force = {}};
    makeJoint(slot, spec);
    for (SlotIndex const body : {spec.a, spec.b}) {
        if (body != noSlot) {
            ++bodies_[body].joints;
            bodies_[body].restlessJoints += joints_[slot].restless ? 1 : 0;
            wake(body);
        }
    }
}

void SubsteppedEngine::removeJoint(SlotIndex slot) {
    FailureGuard const guard;
    JointEntry const entry = joints_[slot];
    for (SlotIndex const body : {entry.a, entry.b}) {
        if (body != noSlot) {
            wake(body);
            --bodies_[body].joints;
            bodies_[body].restlessJoints -= entry.restless ? 1 : 0;
        }
    }
    dropJoint(slot);
    joints_[slot] = {};
}

void SubsteppedEngine::place(SlotIndex slot, Motion const& motion) {
    FailureGuard const guard;
    for (PieceContact const& contact : touches_.contacts()) {
        if (contact.slotA == slot || contact.slotB == slot) {
            wake(contact.slotA == slot ? contact.slotB : contact.slotA);
        }
    }
    wake(slot);
    setMotion(slot, motion);
}

bool SubsteppedEngine::isAt(SlotIndex slot, Motion const& motion) const {
    Motion const now = motionOf(slot);
    return near(now.centre, motion.centre) && near(now.angle, motion.angle) &&
           (bodies_[slot].fixed || (near(now.velocity, motion.velocity) && near(now.spin, motion.spin)));
}

void SubsteppedEngine::setLoads(std::span<Load const> loads) {
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        bodies_[slot].load = slot < loads.size() ? loads[slot] : Load{};
    }
}

void SubsteppedEngine::setDrags(std::span<Drag const> drags) {
    dragged_.resize(drags.empty() ? 0 : bodies_.size());
    for (SlotIndex slot = 0; slot < dragged_.size(); ++slot) {
        if (slot < drags.size() && drags[slot].any() && moves(slot)) {
            dragged_[slot].drag = drags[slot];
        } else {
            dragged_[slot] = {};
        }
    }
}

Twist SubsteppedEngine::momentumOf(SlotIndex slot) const {
    Motion const motion = motionOf(slot);
    return {bodies_[slot].mass * motion.velocity, bodies_[slot].inertia * motion.spin};
}

void SubsteppedEngine::accelerate(SlotIndex slot, Motion& motion, double h) {
    BodyEntry const& entry = bodies_[slot];
    Twist const load{h * entry.load.force, h * entry.load.torque};
    Twist push = load;
    if (slot < dragged_.size() && dragged_[slot].drag.any()) {
        Twist const now{entry.mass * motion.velocity, entry.inertia * motion.spin};
        Twist const drag = dragged_[slot].before(entry.mass, entry.inertia, now, load, h);
        push = {push.linear + drag.linear, push.angular + drag.angular};
    }
    motion.velocity += push.linear / entry.mass;
    motion.spin += push.angular / entry.inertia;
    motion.velocity *= 1 / (1 + h * entry.damping.linear); // implicit Euler, as in Box2D
    motion.spin *= 1 / (1 + h * entry.damping.angular);
    double const speed = length(motion.velocity);
    if (speed > maximumSpeed) {
        motion.velocity *= maximumSpeed / speed;
    }
    motion.spin = std::clamp(motion.spin, -maximumSpeed, maximumSpeed);
}

double SubsteppedEngine::bounceThreshold(SlotIndex a, SlotIndex b, double h) const {
    constexpr double slowest = 0.25; // m/s, as in Box2D at its usual scale
    double gain = 0;
    for (SlotIndex const slot : {a, b}) {
        if (moves(slot)) {
            BodyEntry const& entry = bodies_[slot];
            gain += h * (length(entry.load.force) / entry.mass +
                         std::abs(entry.load.torque) * entry.extent / entry.inertia);
        }
    }
    return std::max(slowest, 2 * gain);
}

double SubsteppedEngine::frictionOf(SlotIndex a, SlotIndex b) const {
    return std::sqrt(bodies_[a].friction * bodies_[b].friction);
}

double SubsteppedEngine::restitutionOf(SlotIndex a, SlotIndex b) const {
    return std::max(bodies_[a].restitution, bodies_[b].restitution);
}

void SubsteppedEngine::applyImpulse(SlotIndex slot, Vec2 impulse, Vec2 point) {
    FailureGuard const guard;
    wake(slot);
    BodyEntry const& entry = bodies_[slot];
    double const limit = maximumSpeed * entry.mass;
    double const size = std::hypot(impulse.x, impulse.y);
    if (size > limit) {
        impulse *= limit / size;
    }
    point = {std::clamp(point.x, -maximumDistance, maximumDistance),
             std::clamp(point.y, -maximumDistance, maximumDistance)};
    Motion motion = motionOf(slot);
    motion.velocity += impulse / entry.mass;
    motion.spin = std::clamp(motion.spin + cross(point - motion.centre, impulse) / entry.inertia,
                             -maximumSpeed, maximumSpeed);
    setMotion(slot, motion);
}

void SubsteppedEngine::noteMoved() {
    moved_.clear();
    anyAwake_ = false;
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        anyAwake_ = anyAwake_ || awake_[slot] != 0;
        if (movedMarks_[slot] != 0) {
            moved_.push_back({slot, motionOf(slot)});
        }
    }
}

void SubsteppedEngine::addContactPatches(std::vector<ContactPatch>& patches) const {
    for (PieceContact const& contact : touches_.contacts()) {
        patches.push_back(contact.patch);
    }
}

} // namespace trembler
