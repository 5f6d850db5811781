#include "physics/dynamics/core/dynamics_resolver.hpp"

#include "physics/dynamics/engines/box2d/box2d_dynamics.hpp"

#include <algorithm>
#include <utility>

namespace trembler {
namespace {

template <class P>
void provideIfOther(DynamicsResolver::Access& access, P const& now) {
    if (!(access.provided<P>() == now)) {
        access.provide<P>() = now;
    }
}

Vec2 centreNow(DynamicsColumns const& columns, Body const& body) {
    return worldCentre(body, columns.position.values()[body.rows.position].value,
                       columns.rotation.values()[body.rows.rotation].angle);
}

} // namespace

// Box2D takes over if another engine fails.
DynamicsResolver::DynamicsResolver(ComponentInfo const& info, DynamicsEngine const& engine)
    : Resolver(info), simulation_(engine.make, engine.text.level, makeBox2dEngine) {}

void DynamicsResolver::advance(Access& access) {
    DynamicsColumns const columns{access.read<Shape>(),        access.read<Mass>(),
                                  access.read<Fixed>(),        access.read<Liquid>(),
                                  access.read<Bullet>(),       access.read<Friction>(),
                                  access.read<Restitution>(),  access.read<CollisionGroups>(),
                                  access.read<Damping>(),      access.read<Joint>(),
                                  access.read<JointAnchors>(), access.read<DynamicsSettings>(),
                                  access.read<Position>(),     access.read<Rotation>(),
                                  access.read<Velocity>(),     access.read<AngularVelocity>()};
    if (!std::exchange(begun_, true)) {
        simulation_.takeOver(access.provided<EngineState>());
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
                                    access.provided<Contacts>().current);
    }
    bool const contactsChanged = updateContacts(access);
    if (contactsChanged) {
        simulation_.noteContacts();
    }
    if (!moved && overloadNews_) {
        access.provide<OverloadedJoints>() = {};
        overloadNews_ = false;
    }
    if (moved || contactsChanged) {
        // Bodies that come to rest are reported even if no component reads that yet: a component that is
        // constructed later then has their final state.
        bool const atRest = !simulation_.anyAwake();
        if (moved) {
            updateJoints(access, atRest || access.wanted<JointForces>());
        }
        if (atRest || access.wanted<ContactPatches>()) {
            updatePatches(access);
        }
    }
    if (access.tracing() && access.wanted<MotionCauses>()) {
        updateCauses(access);
    }
}

bool DynamicsResolver::compute(Access& access, DynamicsColumns const& columns) {
    for (;;) {
        try {
            for (Refusal const& refusal : simulation_.follow(columns)) {
                if (access.tracing() && recorded_.insert({refusal.object, refusal.why}).second) {
                    access.event("refused: " + refusal.why, {refusal.object}, {});
                }
            }
            if (access.callsChanged() || simulation_.loadsStale() || pointForces_) {
                drainLoads(access, columns);
            }
            drainImpulses(access);
            simulation_.engine().noteImpacts(access.wanted<Impacts>());
            simulation_.engine().findTouchesAtEnd(simulation_.readsTouches() ||
                                                  access.hasOwnReaders<Contacts>());
            return simulation_.step(access.duration(), columns, access.provided<Contacts>().current);
        } catch (EngineFailure const& failure) {
            giveUp(access, failure);
        }
    }
}

void DynamicsResolver::giveUp(Access& access, EngineFailure const& failure) {
    simulation_.giveUp(failure);
    EngineState const& state = simulation_.state();
    std::vector<ObjectId> const before = access.provided<EngineState>().stopped;
    access.provide<EngineState>() = state;
    for (ObjectId const object : state.stopped) {
        if (!std::binary_search(before.begin(), before.end(), object)) {
            access.write<Velocity>()[object] = {};
            access.write<AngularVelocity>()[object] = {};
        }
    }
    if (access.tracing()) {
        access.event(std::string("engine gave up: ") + failure.what(), state.stopped, {});
    }
}

void DynamicsResolver::drainLoads(Access& access, DynamicsColumns const& columns) {
    bool const tracing = access.tracing();
    LoadTable& loads = simulation_.loads();
    BodyTable const& bodies = simulation_.bodies();
    simulation_.startLoads();
    if (tracing) {
        simulation_.causes().startActing(bodies.bodies().size());
    }
    // Calls for objects that do not exist, are fixed or are no bodies have no effect, and neither do forces
    // that are not finite.
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
    access.forCalls<AddForce>([&](AddForce const& call, CallOrigin const& origin) {
        take(call.object, isFinite(call.force), origin,
             [&](SlotIndex slot) { loads.add(slot, call.force, 0); });
    });
    pointForces_ = false;
    access.forCalls<AddForceToPoint>([&](AddForceToPoint const& call, CallOrigin const& origin) {
        take(call.object, isFinite(call.force) && isFinite(call.point), origin, [&](SlotIndex slot) {
            Vec2 const arm = call.point - centreNow(columns, bodies[slot]);
            loads.add(slot, call.force, cross(arm, call.force));
            pointForces_ = true; // its arm changes as the body moves
        });
    });
    access.forCalls<AddTorque>([&](AddTorque const& call, CallOrigin const& origin) {
        take(call.object, std::isfinite(call.torque), origin,
             [&](SlotIndex slot) { loads.add(slot, {}, call.torque); });
    });
    access.forCalls<AddDrag>([&](AddDrag const& call, CallOrigin const& origin) {
        if (!isFinite(call.point) || !isResistance(call.xx, call.xy, call.yy, call.angular)) [[unlikely]] {
            refuse(access, call.object, "the drag is negative, too great or not finite", origin.cause);
            return;
        }
        take(call.object, true, origin, [&](SlotIndex slot) {
            Vec2 const arm = call.point - centreNow(columns, bodies[slot]);
            loads.addDrag(slot, arm, call.xx, call.xy, call.yy, call.angular);
            pointForces_ = true;
        });
    });
    access.forCalls<StateRate>([&](StateRate const& call, CallOrigin const&) { simulation_.noteRate(call); });
    simulation_.endLoads();
    provideIfOther(access, simulation_.rates());
}

void DynamicsResolver::drainImpulses(Access& access) {
    if (!access.callsChanged()) {
        return;
    }
    BodyTable const& bodies = simulation_.bodies();
    access.forCalls<AddImpulse>([&](AddImpulse const& call, CallOrigin const& origin) {
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

void DynamicsResolver::refuse(Access& access, ObjectId object, std::string const& why, EventId cause) {
    if (access.tracing() && recorded_.insert({object, why}).second) {
        access.event("refused: " + why, {object}, {cause});
    }
}

} // namespace trembler
