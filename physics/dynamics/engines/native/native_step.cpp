// A step of the native engine: which pieces may meet, which bodies form islands, and what to report.
#include "physics/dynamics/engines/native/island_solver.hpp"
#include "physics/dynamics/engines/native/native_engine.hpp"
#include "physics/dynamics/engines/native/seams.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::native {
namespace {

// Contacts are looked for at least so far, in m, beyond what the bodies move in a step.
constexpr double leastMargin = 1e-3;
// Contacts are looked for at the end of a step so much farther than the next one needs if nothing changes, so
// that it needs not look again.
constexpr double ahead = 1.25;
// A point of a contact is that of the last time if it has moved by less than this share of the smaller body's
// extent.
constexpr double keptWithin = 0.2;

} // namespace

double NativeEngine::reach(SlotIndex slot, double time) const {
    if (awake_[slot] == 0) {
        return 0;
    }
    BodyEntry const& entry = bodies_[slot];
    MovingState const& state = states_[slot];
    double const speed = length(state.velocity) + std::abs(state.spin) * entry.extent;
    double const gain = length(entry.load.force) * state.inverseMass +
                        std::abs(entry.load.torque) * state.inverseInertia * entry.extent;
    return time * (speed + time * gain);
}

void NativeEngine::followPairs(double duration) {
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (awake_[slot] == 0) {
            continue;
        }
        Vec2 const way = duration * states_[slot].velocity;
        double const turning =
            std::min(2.0, duration * std::abs(states_[slot].spin)) * bodies_[slot].extent +
            duration * duration * length(bodies_[slot].load.force) * states_[slot].inverseMass + leastMargin;
        for (Convex const& piece : bodies_[slot].pieces) {
            Bounds box = boundsOf(piece, poses_[slot]);
            box.low = Vec2{std::min(box.low.x, box.low.x + way.x), std::min(box.low.y, box.low.y + way.y)} -
                      Vec2{turning, turning};
            box.high =
                Vec2{std::max(box.high.x, box.high.x + way.x), std::max(box.high.y, box.high.y + way.y)} +
                Vec2{turning, turning};
            pairs_.move(nameOf(slot, piece.piece), box);
        }
    }
    pairs_.update([this](SlotIndex a, SlotIndex b) { return mayTouch(a, b); }, gone_, come_);
    removeContacts(gone_);
    if (come_.empty()) {
        return;
    }
    mergedContacts_.clear();
    mergedContacts_.reserve(contacts_.size() + come_.size());
    auto old = contacts_.begin();
    for (std::uint64_t const key : come_) {
        for (; old != contacts_.end() && old->key < key; ++old) {
            mergedContacts_.push_back(*old);
        }
        Contact& made = mergedContacts_.emplace_back();
        made.key = key;
        made.a = slotOf(firstOf(key));
        made.b = slotOf(secondOf(key));
    }
    mergedContacts_.insert(mergedContacts_.end(), old, contacts_.end());
    contacts_.swap(mergedContacts_);
}

void NativeEngine::meetOne(Contact& contact, double margin) const {
    // Relative to a: so places far from the world's origin lose nothing.
    Pose atA = poses_[contact.a];
    Pose atB = poses_[contact.b];
    atB.at -= atA.at;
    atA.at = {};
    Meeting const before = contact.meeting;
    std::array<double, 2> const force = contact.force;
    std::array<double, 2> const drag = contact.drag;
    std::array<double, 2> const steady = contact.steady;
    contact.meeting = meet(bodies_[contact.a].pieces[pieceOf(firstOf(contact.key))], atA,
                           bodies_[contact.b].pieces[pieceOf(secondOf(contact.key))], atB, margin);
    contact.force = contact.drag = contact.steady = {};
    // A point keeps its force if it is near one of the last time, whichever features meet in it.
    double const near = keptWithin * std::min(bodies_[contact.a].extent, bodies_[contact.b].extent);
    std::array<bool, 2> taken{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.meeting.count); ++i) {
        std::size_t best = 2;
        double least = near * near;
        for (std::size_t j = 0; j < static_cast<std::size_t>(before.count); ++j) {
            double const off =
                std::min(lengthSquared(contact.meeting.points[i].armA - before.points[j].armA),
                         lengthSquared(contact.meeting.points[i].armB - before.points[j].armB));
            if (!taken[j] && off <= least) {
                least = off;
                best = j;
            }
        }
        if (best < 2) {
            taken[best] = true;
            contact.force[i] = force[best];
            contact.drag[i] = drag[best];
            contact.steady[i] = steady[best];
        }
    }
    contact.used = acts(contact);
    contact.within = margin;
}

void NativeEngine::findReaches(double time) {
    reaches_.resize(bodies_.size());
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        reaches_[slot] = reach(slot, time);
    }
}

void NativeEngine::meetAll() {
    for (Contact& contact : contacts_) {
        if (awake_[contact.a] != 0 || awake_[contact.b] != 0) {
            contact.pressed = false;
            double const margin = leastMargin + reaches_[contact.a] + reaches_[contact.b];
            if (contact.within < margin || bodies_[contact.a].placed || bodies_[contact.b].placed) {
                meetOne(contact, margin);
            } else {
                contact.used = acts(contact);
            }
        }
    }
    for (BodyEntry& entry : bodies_) {
        entry.placed = false;
    }
}

void NativeEngine::wakeByContacts(double duration) {
    bool any = true;
    while (any) {
        any = false;
        for (Contact& contact : contacts_) {
            bool const one = awake_[contact.a] != 0;
            bool const other = awake_[contact.b] != 0;
            if (one == other || !contact.used || !moves(contact.a) || !moves(contact.b)) {
                continue;
            }
            double least = contact.meeting.points[0].separation;
            if (contact.meeting.count > 1) {
                least = std::min(least, contact.meeting.points[1].separation);
            }
            SlotIndex const mover = one ? contact.a : contact.b;
            Vec2 const towards = one ? contact.meeting.normal : -contact.meeting.normal;
            double const approach = duration * (dot(states_[mover].velocity, towards) +
                                                std::abs(states_[mover].spin) * bodies_[mover].extent);
            if (least <= std::max(touchGap, approach)) {
                wake(one ? contact.b : contact.a);
                any = true;
            }
        }
    }
}

void NativeEngine::makeIslands() {
    islands_.clear(bodies_.size());
    std::vector<SlotIndex> slotOfContact(contacts_.size(), noSlot);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact const& contact = contacts_[i];
        if (contact.meeting.count == 0) {
            continue;
        }
        bool const one = awake_[contact.a] != 0;
        bool const other = awake_[contact.b] != 0;
        if (one && other) {
            islands_.unite(contact.a, contact.b);
        }
        slotOfContact[i] = one ? contact.a : other ? contact.b : noSlot;
    }
    std::vector<SlotIndex> slotOfJoint(joints_.size(), noSlot);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (!joints_[i].used) {
            continue;
        }
        for (SlotIndex const slot : joints_[i].rows->slots()) {
            if (slot != noSlot && awake_[slot] != 0) {
                if (slotOfJoint[i] != noSlot) {
                    islands_.unite(slot, slotOfJoint[i]);
                }
                slotOfJoint[i] = slot;
            }
        }
    }
    islands_.sort(awake_, slotOfContact, slotOfJoint);
}

void NativeEngine::reportTouches() {
    for (Contact& contact : contacts_) {
        if (awake_[contact.a] == 0 && awake_[contact.b] == 0) {
            continue;
        }
        double least = 1;
        bool presses = false; // in the last substep
        for (std::size_t i = 0; i < static_cast<std::size_t>(contact.meeting.count); ++i) {
            least = std::min(least, contact.meeting.points[i].separation);
            presses = presses || contact.force[i] > 0;
        }
        double const gap = presses ? pressedGap : (contact.touches ? 2 : 1) * touchGap;
        bool const touches = contact.meeting.count > 0 && least <= gap;
        if (touches != contact.touches) {
            contact.touches = touches;
            change(contact, touches ? 1 : -1);
        } else if (!touches && contact.pressed) { // an impact from which they have parted again
            change(contact, 1);
            change(contact, -1);
        }
    }
}

void NativeEngine::step(double duration, DynamicsSettings const& settings) {
    if (!settings.sleeping) {
        for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
            wake(slot);
        }
    }
    impacts_.clear();
    duration_ = duration;
    for (JointEntry& joint : joints_) {
        joint.force = {};
    }
    // A body that is joined to an awake one is awake, too.
    for (bool any = true; any;) {
        any = false;
        for (JointEntry const& joint : joints_) {
            if (!joint.used) {
                continue;
            }
            bool awake = false;
            for (SlotIndex const slot : joint.rows->slots()) {
                awake = awake || (slot != noSlot && awake_[slot] != 0);
            }
            for (SlotIndex const slot : joint.rows->slots()) {
                if (awake && moves(slot) && awake_[slot] == 0) {
                    wake(slot);
                    any = true;
                }
            }
        }
    }
    findWelds();
    followPairs(duration);
    findReaches(duration);
    meetAll();
    wakeByContacts(duration);
    seamSearch_.clear();
    for (Contact& contact : contacts_) {
        if (contact.used && (awake_[contact.a] != 0 || awake_[contact.b] != 0)) {
            seamSearch_.push_back(&contact);
        }
    }
    leaveOutSeams(seamSearch_, bodies_, poses_);
    makeIslands();
    patchStep_ = duration / std::max(1, settings.substeps);
    for (std::uint8_t& mark : movedMarks_) {
        mark = 0;
    }
    for (Island& island : islands_.groups()) {
        IslandSolver(*this, island, settings).run(duration);
        for (SlotIndex const slot : island.bodies) {
            movedMarks_[slot] = 1;
        }
    }
    exact_.tidy();
    // What the world reads are touches at the step's end, and the next step begins with these contacts.
    findReaches(duration);
    for (Contact& contact : contacts_) {
        if (awake_[contact.a] != 0 || awake_[contact.b] != 0) {
            meetOne(contact, ahead * (leastMargin + reaches_[contact.a] + reaches_[contact.b]));
        }
    }
    reportTouches();
    if (settings.sleeping) {
        findRest(duration);
    }
    moved_.clear();
    anyAwake_ = false;
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        bool const awake = awake_[slot] != 0;
        anyAwake_ = anyAwake_ || awake;
        BodyEntry& entry = bodies_[slot];
        entry.loadBefore = entry.load;
        entry.steps = std::min(2, entry.steps + 1);
        entry.lastStep = awake ? duration : 0;
        if (movedMarks_[slot] != 0) {
            moved_.push_back({slot, motionOf(slot)});
        }
    }
}

} // namespace trembler::native
