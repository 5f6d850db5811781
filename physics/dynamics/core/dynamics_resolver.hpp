// The Dynamics resolver of 6.13, for any rigid-body engine.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/core/dynamics_engine.hpp"
#include "physics/dynamics/core/simulation.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/motion_causes.hpp"
#include "runtime/component/resolver.hpp"

#include <set>
#include <string>
#include <utility>

namespace trembler {

/// Registered once for each engine, Registry::component<DynamicsResolver>(engine).
///
/// Position is the origin of an object's frame, Velocity that of its centre of mass, which is elsewhere where
/// a shape is not centred on its origin (see centreOfMass()). A frame's forces stand for all its substeps.
class DynamicsResolver final
    : public Resolver<DynamicsResolver, DynamicsRole,
                      Reads<Shape, Mass, Fixed, Bullet, Friction, Restitution, CollisionGroups, Damping,
                            Liquid, Joint, JointAnchors, DynamicsSettings>,
                      Writes<Position, Velocity, AngularVelocity, Rotation>,
                      Provides<Contacts, ContactPatches, Impacts, JointForces, OverloadedJoints, MotionCauses,
                               ForceRates, ForceLag, SolverChoice, EngineState>> {
public:
    using Activation = NeedsAll<Shape>;
    static constexpr Coverage memory =
        leftOut("the engine's world: bodies and joints follow from their columns, but what it starts each "
                "solution with, how long bodies have been still and in which order it found contacts no "
                "engine lets anybody read; beside it the loads under which bodies fell asleep and those "
                "for which substeps were last found; equal recordings give equal ones");

    DynamicsResolver(ComponentInfo const& info, DynamicsEngine const& engine);

    // News of one frame must be taken back in the next, even if all bodies are at rest by then.
    [[nodiscard]] bool restless() const {
        return simulation_.anyAwake() || contactNews_ || overloadNews_ || impactNews_;
    }

    void advance(Access& access);

private:
    /// Moves bodies on, with another engine if need be: until it is done the columns stay as they are.
    /// Returns whether any has moved.
    bool compute(Access& access, DynamicsColumns const& columns);
    void giveUp(Access& access, EngineFailure const& failure);
    void drainLoads(Access& access, DynamicsColumns const& columns);
    void drainImpulses(Access& access);
    void refuse(Access& access, ObjectId object, std::string const& why, EventId cause);

    void writeMotion(Access& access);
    /// Returns whether the pairs that touch have changed.
    bool updateContacts(Access& access);
    void traceContacts(Access& access);
    /// Of all joints, or only of those that can break.
    void updateJoints(Access& access, bool all);
    void updatePatches(Access& access);
    void updateImpacts(Access& access, bool moved);
    void updateCauses(Access& access);

    Simulation simulation_;
    bool begun_ = false;
    Contacts next_;                                       // kept for its memory
    std::set<std::pair<ObjectId, std::string>> recorded_; // refusals that the trace knows
    bool pointForces_ = false;
    bool contactNews_ = false;
    bool impactNews_ = false;
    bool overloadNews_ = false;
};

} // namespace trembler
