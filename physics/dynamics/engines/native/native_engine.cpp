#include "physics/dynamics/engines/native/native_engine.hpp"

#include "physics/dynamics/engines/body_core.hpp"
#include "physics/dynamics/engines/native/native_dynamics.hpp"
#include "runtime/math/exact_math.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace native {
namespace {

bool near(double x, double y) {
    // Tolerance for rounding errors from rotation about a centre.
    return std::abs(x - y) <= 1e-11 * (1 + std::abs(y));
}
bool near(Vec2 x, Vec2 y) {
    return near(x.x, y.x) && near(x.y, y.y);
}

} // namespace

void NativeEngine::setPose(SlotIndex slot) {
    auto const [cosine, sine] = exactTurn(bodies_[slot].angle);
    poses_[slot] = {bodies_[slot].centre, cosine, sine};
}

Motion NativeEngine::motionOf(SlotIndex slot) const {
    return {bodies_[slot].centre, bodies_[slot].angle, states_[slot].velocity, states_[slot].spin};
}

void NativeEngine::addBody(SlotIndex slot, BodySpec const& spec) {
    if (bodies_.size() <= slot) {
        std::size_t const size = slot + std::size_t{1};
        bodies_.resize(size);
        states_.resize(size);
        poses_.resize(size);
        awake_.resize(size, 0);
        movedMarks_.resize(size, 0);
    }
    BodyEntry& entry = bodies_[slot];
    entry = {};
    entry.object = spec.object;
    entry.fixed = spec.fixed;
    entry.mass = spec.fixed ? 0 : spec.mass;
    entry.inertia = spec.fixed ? 0 : spec.mass * spec.spread.inertiaPerMass;
    entry.friction = spec.friction;
    entry.restitution = spec.restitution;
    entry.groups = spec.groups;
    entry.damping = spec.damping;
    entry.centre = spec.motion.centre;
    entry.angle = spec.motion.angle;
    entry.thin = coreOf(spec).radius;
    entry.extent = extentOf(spec);
    entry.pieces = convexPieces(spec);
    MovingState& state = states_[slot];
    state = {};
    if (!spec.fixed) {
        state.velocity = spec.motion.velocity;
        state.spin = spec.motion.spin;
        state.inverseMass = 1 / entry.mass;
        state.inverseInertia = 1 / entry.inertia;
        awake_[slot] = 1;
        anyAwake_ = true;
    }
    setPose(slot);
    for (Convex const& piece : entry.pieces) {
        pairs_.add(nameOf(slot, piece.piece), boundsOf(piece, poses_[slot]));
    }
}

void NativeEngine::wakeTouching(SlotIndex slot) {
    for (Contact const& contact : contacts_) {
        if (contact.touches && (contact.a == slot || contact.b == slot)) {
            wake(contact.a == slot ? contact.b : contact.a);
        }
    }
}

void NativeEngine::forgetPairs(SlotIndex slot) {
    pairs_.forget(slot, gone_);
    removeContacts(gone_);
}

void NativeEngine::removeContacts(std::vector<std::uint64_t> const& gone) {
    if (gone.empty()) {
        return;
    }
    auto next = gone.begin();
    std::erase_if(contacts_, [&](Contact const& contact) {
        if (next == gone.end() || contact.key != *next) {
            return false;
        }
        ++next;
        if (contact.touches) {
            change(contact, -1);
        }
        return true;
    });
}

void NativeEngine::change(Contact const& contact, int delta) {
    ObjectId const a = bodies_[contact.a].object;
    ObjectId const b = bodies_[contact.b].object;
    touches_.push_back({std::min(a, b), std::max(a, b), delta});
}

void NativeEngine::removeBody(SlotIndex slot) {
    wakeTouching(slot);
    wake(slot);
    forgetPairs(slot);
    for (Convex const& piece : bodies_[slot].pieces) {
        pairs_.remove(nameOf(slot, piece.piece));
    }
    bodies_[slot] = {};
    states_[slot] = {};
    awake_[slot] = 0;
    if (slot < dragged_.size()) {
        dragged_[slot] = {};
    }
}

void NativeEngine::tie(SlotIndex a, SlotIndex b, int change) {
    if (a == noSlot || b == noSlot) {
        return;
    }
    std::pair<SlotIndex, SlotIndex> const both{std::min(a, b), std::max(a, b)};
    auto const at = std::lower_bound(apart_.begin(), apart_.end(), both);
    if (change > 0) {
        apart_.insert(at, both);
        forgetPairs(a);
    } else {
        apart_.erase(at);
        pairs_.forget(a, gone_);
        removeContacts(gone_);
    }
}

void NativeEngine::addJoint(SlotIndex slot, JointSpec const& spec) {
    if (joints_.size() <= slot) {
        joints_.resize(slot + std::size_t{1});
    }
    Joint const& joint = *spec.joint;
    bool const gear = joint.form == JointForm::gear;
    JointEntry& entry = joints_[slot];
    entry = {};
    entry.used = true;
    entry.rows = std::make_unique<JointRows>(spec, gear ? joints_[spec.gearA].rows.get() : nullptr,
                                             gear ? joints_[spec.gearB].rows.get() : nullptr);
    entry.restless = entry.rows->restless();
    entry.collide = joint.collide;
    entry.weld = joint.form == JointForm::weld;
    weldsKnown_ = weldsKnown_ && !entry.weld;
    entry.a = spec.a;
    entry.b = spec.b;
    for (SlotIndex const body : {spec.a, spec.b}) {
        if (body != noSlot) {
            ++bodies_[body].joints;
            bodies_[body].restlessJoints += entry.restless ? 1 : 0;
            wake(body);
        }
    }
    if (!entry.collide) {
        tie(spec.a, spec.b, 1);
    }
}

void NativeEngine::removeJoint(SlotIndex slot) {
    JointEntry const entry = std::move(joints_[slot]);
    weldsKnown_ = weldsKnown_ && !entry.weld;
    for (SlotIndex const body : {entry.a, entry.b}) {
        if (body != noSlot) {
            wake(body);
            --bodies_[body].joints;
            bodies_[body].restlessJoints -= entry.restless ? 1 : 0;
        }
    }
    joints_[slot] = {};
    if (!entry.collide) {
        tie(entry.a, entry.b, -1);
    }
}

// Contacts between bodies that welds hold to each other, also by way of others, say what the welds say: that
// they cannot move. As equations they would contradict them.
void NativeEngine::findWelds() {
    welded_.resize(bodies_.size(), noSlot);
    if (weldsKnown_) {
        return;
    }
    weldsKnown_ = true;
    Islands groups;
    groups.clear(bodies_.size());
    std::fill(welded_.begin(), welded_.end(), noSlot);
    for (JointEntry const& joint : joints_) {
        if (joint.used && joint.weld && joint.a != noSlot && joint.b != noSlot) {
            groups.unite(joint.a, joint.b);
            welded_[joint.a] = joint.a;
            welded_[joint.b] = joint.b;
        }
    }
    for (SlotIndex& slot : welded_) {
        slot = slot == noSlot ? noSlot : groups.rootOf(slot);
    }
    for (Contact& contact : contacts_) {
        contact.within = -1; // to be found again
    }
}

bool NativeEngine::mayTouch(SlotIndex a, SlotIndex b) const {
    return (moves(a) || moves(b)) && canHit(bodies_[a].groups, bodies_[b].groups) &&
           !std::binary_search(apart_.begin(), apart_.end(), std::pair{a, b});
}

void NativeEngine::place(SlotIndex slot, Motion const& motion) {
    wakeTouching(slot);
    wake(slot);
    BodyEntry& entry = bodies_[slot];
    entry.centre = motion.centre;
    entry.angle = motion.angle;
    entry.placed = true;
    if (!entry.fixed) {
        states_[slot].velocity = motion.velocity;
        states_[slot].spin = motion.spin;
    }
    setPose(slot);
    for (Convex const& piece : entry.pieces) {
        pairs_.move(nameOf(slot, piece.piece), boundsOf(piece, poses_[slot]));
    }
}

bool NativeEngine::isAt(SlotIndex slot, Motion const& motion) const {
    Motion const now = motionOf(slot);
    return near(now.centre, motion.centre) && near(now.angle, motion.angle) &&
           (bodies_[slot].fixed || (near(now.velocity, motion.velocity) && near(now.spin, motion.spin)));
}

void NativeEngine::setLoads(std::span<Load const> loads) {
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        bodies_[slot].load = slot < loads.size() ? loads[slot] : Load{};
    }
}

void NativeEngine::setDrags(std::span<Drag const> drags) {
    dragged_.resize(drags.empty() ? 0 : bodies_.size());
    for (SlotIndex slot = 0; slot < dragged_.size(); ++slot) {
        if (slot < drags.size() && drags[slot].any() && moves(slot)) {
            dragged_[slot].drag = drags[slot];
        } else {
            dragged_[slot] = {};
        }
    }
}

void NativeEngine::wake(SlotIndex slot) {
    if (!moves(slot)) {
        return;
    }
    bodies_[slot].idle = 0;
    if (awake_[slot] != 0) {
        return;
    }
    std::uint32_t const nap = bodies_[slot].nap;
    for (SlotIndex other = 0; other < bodies_.size(); ++other) {
        if (awake_[other] == 0 && moves(other) && bodies_[other].nap == nap) {
            awake_[other] = 1;
            bodies_[other].idle = 0;
        }
    }
    anyAwake_ = true;
}

void NativeEngine::applyImpulse(SlotIndex slot, Vec2 impulse, Vec2 point) {
    wake(slot);
    MovingState& state = states_[slot];
    state.velocity += state.inverseMass * impulse;
    state.spin += state.inverseInertia * cross(point - bodies_[slot].centre, impulse);
}

void NativeEngine::addContactPatches(std::vector<ContactPatch>& patches) const {
    for (Contact const& contact : contacts_) {
        if (!contact.touches) {
            continue;
        }
        bool const swapped = bodies_[contact.b].object < bodies_[contact.a].object;
        ContactPatch patch;
        patch.a = bodies_[swapped ? contact.b : contact.a].object;
        patch.b = bodies_[swapped ? contact.a : contact.b].object;
        patch.normal = swapped ? -contact.meeting.normal : contact.meeting.normal;
        Convex const& pieceA = bodies_[contact.a].pieces[pieceOf(firstOf(contact.key))];
        for (std::size_t i = 0; i < static_cast<std::size_t>(contact.meeting.count); ++i) {
            MeetingPoint const& point = contact.meeting.points[i];
            if (point.separation > (contact.force[i] > 0 ? pressedGap : 2 * touchGap)) {
                continue;
            }
            auto const n = static_cast<std::size_t>(patch.count++);
            patch.points[n] = poses_[contact.a].at + point.armA +
                              (pieceA.radius + point.separation / 2) * contact.meeting.normal;
            patch.normalImpulse[n] = patchStep_ * contact.force[i];
            patch.tangentImpulse[n] = patchStep_ * contact.drag[i];
        }
        patches.push_back(patch);
    }
}

std::vector<SlotIndex> NativeEngine::lost() const {
    std::vector<SlotIndex> found;
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        Motion const motion = motionOf(slot);
        if (bodies_[slot].object.valid() && !(isFinite(motion.centre) && isFinite(motion.velocity) &&
                                              std::isfinite(motion.angle) && std::isfinite(motion.spin))) {
            found.push_back(slot);
        }
    }
    return found;
}

} // namespace native

std::unique_ptr<Engine> makeNativeEngine(double /*scale*/) {
    return std::make_unique<native::NativeEngine>();
}

} // namespace trembler
