// The Dynamics resolver of 6.13, for any rigid-body engine.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/core/simulation.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "runtime/component/resolver.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace trembler {

namespace detail {
template <class Self>
using DynamicsBase = Resolver<Self, DynamicsRole,
                              Reads<Shape, Mass, Fixed, Bullet, Friction, Restitution, CollisionGroups,
                                    Damping, Liquid, Joint, JointAnchors, DynamicsSettings>,
                              Writes<Position, Velocity, AngularVelocity, Rotation>,
                              Provides<Contacts, ContactPatches, Impacts, JointForces, OverloadedJoints,
                                       MotionCauses, ForceRates, ForceLag, SolverChoice, EngineState>>;
} // namespace detail

/// Makes the engine that takes over where another cannot go on.
[[nodiscard]] std::unique_ptr<Engine> makeBox2dEngine(double scale);

/// `Self` adds `text` and `static constexpr EngineMaker engineMaker`.
///
/// Position is the origin of an object's frame, Velocity that of its centre of mass, which is elsewhere where
/// a shape is not centred on its origin (see centreOfMass()). A frame's forces stand for all its substeps.
template <class Self>
class DynamicsResolver : public detail::DynamicsBase<Self> {
    using Base = detail::DynamicsBase<Self>;

public:
    using Activation = NeedsAll<Shape>;
    static constexpr Coverage memory =
        leftOut("the engine's world: bodies and joints follow from their columns, but what it starts each "
                "solution with, how long bodies have been still and in which order it found contacts no "
                "engine lets anybody read; beside it the loads under which bodies fell asleep and those "
                "for which substeps were last found; equal recordings give equal ones");
    using Access = typename Base::Access;

    // What is news in one frame must be taken back in the next, even if all is at rest by then.
    [[nodiscard]] bool restless() const {
        return simulation_.anyAwake() || contactNews_ || overloadNews_ || impactNews_;
    }

    void advance(Access& access) {
        DynamicsColumns const columns{
            access.template read<Shape>(),        access.template read<Mass>(),
            access.template read<Fixed>(),        access.template read<Liquid>(),
            access.template read<Bullet>(),       access.template read<Friction>(),
            access.template read<Restitution>(),  access.template read<CollisionGroups>(),
            access.template read<Damping>(),      access.template read<Joint>(),
            access.template read<JointAnchors>(), access.template read<DynamicsSettings>(),
            access.template read<Position>(),     access.template read<Rotation>(),
            access.template read<Velocity>(),     access.template read<AngularVelocity>()};
        if (!std::exchange(begun_, true)) {
            simulation_.takeOver(access.template provided<EngineState>());
        }
        bool const moved = compute(access, columns);
        updateImpacts(access, moved);
        if (moved) {
            provideIfOther(access, simulation_.choice());
            provideIfOther(access, simulation_.lag());
            writeMotion(access);
            simulation_.noteWritten(columns);
        }
        if (access.tracing()) {
            simulation_.causes().spread(simulation_.bodies(), simulation_.joints(),
                                        access.template provided<Contacts>().current);
        }
        bool const contactsChanged = updateContacts(access);
        if (contactsChanged) {
            simulation_.noteContacts();
        }
        if (!moved && overloadNews_) {
            access.template provide<OverloadedJoints>() = {};
            overloadNews_ = false;
        }
        if (moved || contactsChanged) {
            // What comes to rest is told even if nobody reads it yet: who comes later finds it as it lies.
            bool const atRest = !simulation_.anyAwake();
            if (moved) {
                updateJoints(access, atRest || access.template wanted<JointForces>());
            }
            if (atRest || access.template wanted<ContactPatches>()) {
                updatePatches(access);
            }
        }
        if (access.tracing() && access.template wanted<MotionCauses>()) {
            updateCauses(access);
        }
    }

private:
    /// Moves bodies on, with another engine if need be: until it is done the columns stay as they are.
    /// Returns whether any has moved.
    bool compute(Access& access, DynamicsColumns const& columns) {
        for (;;) {
            try {
                for (Refusal const& refusal : simulation_.follow(columns)) {
                    if (access.tracing() && told_.insert({refusal.object, refusal.why}).second) {
                        access.event("refused: " + refusal.why, {refusal.object}, {});
                    }
                }
                if (access.callsChanged() || simulation_.loadsStale() || pointForces_) {
                    drainLoads(access, columns);
                }
                drainImpulses(access);
                simulation_.engine().noteImpacts(access.template wanted<Impacts>());
                return simulation_.step(access.duration(), columns,
                                        access.template provided<Contacts>().current);
            } catch (EngineFailure const& failure) {
                giveUp(access, failure);
            }
        }
    }

    void giveUp(Access& access, EngineFailure const& failure) {
        simulation_.giveUp(failure);
        EngineState const& state = simulation_.state();
        std::vector<ObjectId> const before = access.template provided<EngineState>().stopped;
        access.template provide<EngineState>() = state;
        for (ObjectId const object : state.stopped) {
            if (!std::binary_search(before.begin(), before.end(), object)) {
                access.template write<Velocity>()[object] = {};
                access.template write<AngularVelocity>()[object] = {};
            }
        }
        if (access.tracing()) {
            access.event(std::string("engine gave up: ") + failure.what(), state.stopped, {});
        }
    }

    void drainLoads(Access& access, DynamicsColumns const& columns) {
        bool const tracing = access.tracing();
        LoadTable& loads = simulation_.loads();
        BodyTable const& bodies = simulation_.bodies();
        simulation_.startLoads();
        if (tracing) {
            simulation_.causes().startActing(bodies.bodies().size());
        }
        // Calls about what is gone, fixed or no body come to nothing; so do forces that are no number.
        auto const take = [&](ObjectId object, bool finite, CallOrigin const& origin, auto&& add) {
            SlotIndex const slot = bodies.slotOf(object);
            if (slot == noSlot || bodies[slot].fixed) {
                return;
            }
            if (!finite) [[unlikely]] {
                refuse(access, object, "the force is not a finite number", origin.cause);
                return;
            }
            add(slot);
            if (tracing) {
                simulation_.causes().act(slot, origin.cause);
            }
        };
        access.template forCalls<AddForce>([&](AddForce const& call, CallOrigin const& origin) {
            take(call.object, isFinite(call.force), origin,
                 [&](SlotIndex slot) { loads.add(slot, call.force, 0); });
        });
        pointForces_ = false;
        access.template forCalls<AddForceToPoint>([&](AddForceToPoint const& call, CallOrigin const& origin) {
            take(call.object, isFinite(call.force) && isFinite(call.point), origin, [&](SlotIndex slot) {
                Vec2 const arm = call.point - centreNow(columns, bodies[slot]);
                loads.add(slot, call.force, cross(arm, call.force));
                pointForces_ = true; // its arm changes as the body moves
            });
        });
        access.template forCalls<AddTorque>([&](AddTorque const& call, CallOrigin const& origin) {
            take(call.object, std::isfinite(call.torque), origin,
                 [&](SlotIndex slot) { loads.add(slot, {}, call.torque); });
        });
        access.template forCalls<AddDrag>([&](AddDrag const& call, CallOrigin const& origin) {
            if (!isFinite(call.point) || !isResistance(call.xx, call.xy, call.yy, call.angular))
                [[unlikely]] {
                refuse(access, call.object, "the drag is negative, too great or not finite", origin.cause);
                return;
            }
            take(call.object, true, origin, [&](SlotIndex slot) {
                Vec2 const arm = call.point - centreNow(columns, bodies[slot]);
                loads.addDrag(slot, arm, call.xx, call.xy, call.yy, call.angular);
                pointForces_ = true;
            });
        });
        simulation_.endLoads();
        access.template forCalls<TellRate>(
            [&](TellRate const& call, CallOrigin const&) { simulation_.noteRate(call); });
        provideIfOther(access, simulation_.rates());
    }

    template <class P>
    static void provideIfOther(Access& access, P const& now) {
        if (!(access.template provided<P>() == now)) {
            access.template provide<P>() = now;
        }
    }

    static Vec2 centreNow(DynamicsColumns const& columns, Body const& body) {
        return worldCentre(body, columns.position.values()[body.rows.position].value,
                           columns.rotation.values()[body.rows.rotation].angle);
    }

    void drainImpulses(Access& access) {
        if (!access.callsChanged()) {
            return;
        }
        BodyTable const& bodies = simulation_.bodies();
        access.template forCalls<AddImpulse>([&](AddImpulse const& call, CallOrigin const& origin) {
            SlotIndex const slot = bodies.slotOf(call.object);
            if (slot == noSlot || bodies[slot].fixed) {
                return;
            }
            if (!isFinite(call.impulse) || !isFinite(call.point)) {
                refuse(access, call.object, "the impulse is not a finite number", origin.cause);
                return;
            }
            simulation_.engine().applyImpulse(slot, call.impulse, call.point);
            if (access.tracing()) {
                simulation_.causes().note(slot, origin.cause);
            }
        });
    }

    void refuse(Access& access, ObjectId object, std::string const& why, EventId cause) {
        if (access.tracing() && told_.insert({object, why}).second) {
            access.event("refused: " + why, {object}, {cause});
        }
    }

    void writeMotion(Access& access) {
        auto const positions = access.template write<Position>().values();
        auto const rotations = access.template write<Rotation>().values();
        auto const velocities = access.template write<Velocity>().values();
        auto const spins = access.template write<AngularVelocity>().values();
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

    /// Returns whether what touches has changed.
    bool updateContacts(Access& access) {
        TouchBook& book = simulation_.touching();
        book.take(simulation_.engine().touchChanges());
        if (!book.changed()) {
            if (contactNews_) {
                Contacts& contacts = access.template provide<Contacts>();
                contacts.begun.clear();
                contacts.ended.clear();
                contacts.brief.clear();
                contactNews_ = false;
            }
            return false;
        }
        book.compare(access.template provided<Contacts>(), next_);
        book.markSeen();
        if (access.tracing()) {
            traceContacts(access);
        }
        std::swap(access.template provide<Contacts>(), next_);
        Contacts const& contacts = access.template provided<Contacts>();
        contactNews_ = !contacts.begun.empty() || !contacts.ended.empty() || !contacts.brief.empty();
        return true;
    }

    void traceContacts(Access& access) {
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

    void updateJoints(Access& access, bool all) {
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
                EventId const event = access.event(
                    "joint overloaded", std::span(objects).first(tied.joint.b.valid() ? 3 : 2), why);
                overloaded.push_back({tied.object, event});
            }
        }
        auto const byJoint = [](auto const& x, auto const& y) { return x.joint < y.joint; };
        if (all && !(forces.empty() && access.template provided<JointForces>().entries.empty())) {
            std::sort(forces.begin(), forces.end(), byJoint);
            access.template provide<JointForces>().entries = std::move(forces);
        }
        std::sort(overloaded.begin(), overloaded.end(), byJoint);
        overloadNews_ = !overloaded.empty();
        if (overloadNews_ || !access.template provided<OverloadedJoints>().entries.empty()) {
            access.template provide<OverloadedJoints>().entries = std::move(overloaded);
        }
    }

    void updatePatches(Access& access) {
        auto& patches = access.template provide<ContactPatches>().patches;
        patches.clear();
        simulation_.engine().addContactPatches(patches);
        access.template provide<ContactPatches>().step = simulation_.lag().step;
        std::stable_sort(patches.begin(), patches.end(), [](ContactPatch const& x, ContactPatch const& y) {
            return x.a != y.a ? x.a < y.a : x.b < y.b;
        });
    }

    void updateImpacts(Access& access, bool moved) {
        std::span<Impact const> const found =
            moved ? simulation_.engine().impacts() : std::span<Impact const>{};
        impactNews_ = !found.empty();
        if (!impactNews_ && access.template provided<Impacts>().impacts.empty()) {
            return;
        }
        auto& impacts = access.template provide<Impacts>().impacts;
        impacts.assign(found.begin(), found.end());
        std::stable_sort(impacts.begin(), impacts.end(), [](Impact const& x, Impact const& y) {
            return std::tie(x.a, x.b, x.since) < std::tie(y.a, y.b, y.since);
        });
    }

    void updateCauses(Access& access) {
        auto& entries = access.template provide<MotionCauses>().entries;
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

    Simulation simulation_{Self::engineMaker, Self::text.level, makeBox2dEngine};
    bool begun_ = false;
    Contacts next_;                                   // kept for its memory
    std::set<std::pair<ObjectId, std::string>> told_; // refusals that the trace knows
    bool pointForces_ = false;
    bool contactNews_ = false;
    bool impactNews_ = false;
    bool overloadNews_ = false;
};

} // namespace trembler
