// The results that the Dynamics resolver writes and provides after a step: motion, contacts, joint forces,
// impacts, causes.
#include "physics/dynamics/core/dynamics_resolver.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace trembler {

void DynamicsResolver::writeMotion(Access& access) {
    auto const positions = access.write<Position>().values();
    auto const rotations = access.write<Rotation>().values();
    auto const velocities = access.write<Velocity>().values();
    auto const spins = access.write<AngularVelocity>().values();
    BodyTable const& bodies = simulation_.bodies();
    for (MovedBody const& moved : simulation_.engine().moved()) {
        Body const& body = bodies[moved.slot];
        Motion const& motion = moved.motion;
        positions[body.rows.position].value =
            body.offCentre ? motion.centre - rotated(body.centre, motion.angle) : motion.centre;
        rotations[body.rows.rotation].angle = motion.angle;
        velocities[body.rows.velocity].value = motion.velocity;
        spins[body.rows.spin].value = motion.spin;
    }
}

bool DynamicsResolver::updateContacts(Access& access) {
    TouchBook& book = simulation_.touching();
    book.take(simulation_.engine().touchChanges());
    if (!book.changed()) {
        if (contactNews_) {
            Contacts& contacts = access.provide<Contacts>();
            contacts.begun.clear();
            contacts.ended.clear();
            contacts.brief.clear();
            contactNews_ = false;
        }
        return false;
    }
    book.compare(access.provided<Contacts>(), next_);
    book.markSeen();
    if (access.tracing()) {
        traceContacts(access);
    }
    std::swap(access.provide<Contacts>(), next_);
    Contacts const& contacts = access.provided<Contacts>();
    contactNews_ = !contacts.begun.empty() || !contacts.ended.empty() || !contacts.brief.empty();
    return true;
}

void DynamicsResolver::traceContacts(Access& access) {
    BodyTable const& bodies = simulation_.bodies();
    CauseBook& causes = simulation_.causes();
    auto const record = [&](std::string_view what, TouchingPair& pair) {
        std::vector<EventId> const why = causes.of(bodies.slotOf(pair.a), bodies.slotOf(pair.b));
        pair.event = access.event(what, std::array{pair.a, pair.b}, why);
    };
    for (TouchingPair& pair : next_.begun) {
        record("contact begun", pair);
    }
    for (TouchingPair& pair : next_.ended) {
        record("contact ended", pair);
    }
    for (TouchingPair& pair : next_.brief) {
        record("contact brief", pair);
    }
    auto begun = next_.begun.cbegin();
    for (TouchingPair& pair : next_.current) {
        if (begun != next_.begun.cend() && pair == *begun) {
            pair.event = begun++->event;
        }
    }
    for (auto const* list : {&next_.begun, &next_.brief}) {
        for (TouchingPair const& pair : *list) {
            for (ObjectId const object : {pair.a, pair.b}) {
                SlotIndex const slot = bodies.slotOf(object);
                if (slot != noSlot && !bodies[slot].fixed) {
                    causes.note(slot, pair.event);
                }
            }
        }
    }
    causes.spread(bodies, simulation_.joints(), next_.current);
}

void DynamicsResolver::updateJoints(Access& access, bool all) {
    std::vector<JointForces::Entry> forces;
    std::vector<OverloadedJoints::Entry> overloaded;
    std::span<TiedJoint const> const joints = simulation_.joints().joints();
    for (SlotIndex slot = 0; slot < joints.size(); ++slot) {
        TiedJoint const& tied = joints[slot];
        if (!tied.object.valid() || (!all && tied.joint.breakForce <= 0)) {
            continue;
        }
        Vec2 const force = simulation_.engine().jointForce(slot);
        if (all) {
            forces.push_back({tied.object, force});
        }
        if (tied.joint.breakForce > 0 && length(force) > tied.joint.breakForce) {
            std::vector<EventId> const why = simulation_.causes().of(tied.a, tied.b);
            std::array<ObjectId, 3> const objects{tied.object, tied.joint.a, tied.joint.b};
            EventId const event =
                access.event("joint overloaded", std::span(objects).first(tied.joint.b.valid() ? 3 : 2), why);
            overloaded.push_back({tied.object, event});
        }
    }
    auto const byJoint = [](auto const& x, auto const& y) { return x.joint < y.joint; };
    if (all && !(forces.empty() && access.provided<JointForces>().entries.empty())) {
        std::sort(forces.begin(), forces.end(), byJoint);
        access.provide<JointForces>().entries = std::move(forces);
    }
    std::sort(overloaded.begin(), overloaded.end(), byJoint);
    overloadNews_ = !overloaded.empty();
    if (overloadNews_ || !access.provided<OverloadedJoints>().entries.empty()) {
        access.provide<OverloadedJoints>().entries = std::move(overloaded);
    }
}

void DynamicsResolver::updatePatches(Access& access) {
    auto& patches = access.provide<ContactPatches>().patches;
    patches.clear();
    simulation_.engine().addContactPatches(patches);
    access.provide<ContactPatches>().step = simulation_.substep();
    std::stable_sort(patches.begin(), patches.end(), [](ContactPatch const& x, ContactPatch const& y) {
        return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
}

void DynamicsResolver::updateImpacts(Access& access, bool moved) {
    std::span<Impact const> const found = moved ? simulation_.engine().impacts() : std::span<Impact const>{};
    impactNews_ = !found.empty();
    if (!impactNews_ && access.provided<Impacts>().impacts.empty()) {
        return;
    }
    auto& impacts = access.provide<Impacts>().impacts;
    impacts.assign(found.begin(), found.end());
    std::stable_sort(impacts.begin(), impacts.end(), [](Impact const& x, Impact const& y) {
        return std::tie(x.a, x.b, x.since) < std::tie(y.a, y.b, y.since);
    });
}

void DynamicsResolver::updateCauses(Access& access) {
    if (!simulation_.causes().takeChanged()) {
        return; // as in most frames
    }
    auto& entries = access.provide<MotionCauses>().entries;
    entries.clear();
    BodyTable const& bodies = simulation_.bodies();
    for (SlotIndex slot = 0; slot < bodies.bodies().size(); ++slot) {
        std::vector<EventId> causes = simulation_.causes().of(slot);
        if (bodies[slot].object.valid() && !causes.empty()) {
            entries.push_back({bodies[slot].object, std::move(causes)});
        }
    }
    std::sort(entries.begin(), entries.end(),
              [](auto const& x, auto const& y) { return x.object < y.object; });
}

} // namespace trembler
