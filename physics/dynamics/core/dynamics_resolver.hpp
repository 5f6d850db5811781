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
/// Position is the origin of an object's frame. Velocity is that of its centre of mass, which differs from
/// the origin if the shape is not centred on it (see centreOfMass()). Forces are held for all substeps of a
/// frame.
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
        leftOut("the engine's world: bodies and joints follow from their columns, but engines give no access "
                "to their initial solutions, sleep timers and order of contacts; also the loads under "
                "which bodies fell asleep and for which substeps were last chosen; equal recordings "
                "give equal ones");

    DynamicsResolver(ComponentInfo const& info, DynamicsEngine const& engine);

    // News of one frame must be cleared in the next, even if all bodies are then at rest.
    [[nodiscard]] bool restless() const {
        return simulation_.anyAwake() || contactNews_ || overloadNews_ || impactNews_;
    }

    void advance(Access& access);

private:
    /// Computes the motion of bodies, with another engine if the first fails; the columns do not change until
    /// it succeeds. Returns whether any body has moved.
    bool compute(Access& access, DynamicsColumns const& columns);
    void giveUp(Access& access, EngineFailure const& failure);
    void drainLoads(Access& access, DynamicsColumns const& columns);
    void drainImpulses(Access& access);
    void refuse(Access& access, ObjectId object, std::string const& why, EventId cause);

    void writeMotion(Access& access);
    /// Returns whether the pairs that touch have changed.
    bool updateContacts(Access& access);
    void traceContacts(Access& access);
    /// Updates the forces of all joints, or only of the joints that can break.
    void updateJoints(Access& access, bool all);
    void updatePatches(Access& access);
    void updateImpacts(Access& access, bool moved);
    void updateCauses(Access& access);

    Simulation simulation_;
    bool begun_ = false;
    Contacts next_;                                       // a member to reuse its memory
    std::set<std::pair<ObjectId, std::string>> recorded_; // refusals that are in the trace
    bool pointForces_ = false;
    bool contactNews_ = false;
    bool impactNews_ = false;
    bool overloadNews_ = false;
};

} // namespace trembler
