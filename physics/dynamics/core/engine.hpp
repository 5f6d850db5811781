// The interface of rigid-body engines to Dynamics: our own, Box2D, Chipmunk and ODE implement it.
#pragma once

#include "physics/dynamics/core/drag.hpp"
#include "physics/dynamics/core/engine_failure.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/impacts.hpp"
#include "physics/dynamics/properties/joint_anchors.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace trembler {

/// The index of a body, or of a joint, in the tables that Dynamics and its engine share. Free indices are
/// reused, so they stay small.
using SlotIndex = std::uint32_t;
inline constexpr SlotIndex noSlot = std::numeric_limits<SlotIndex>::max();

/// The motion of a body's centre of mass.
struct Motion {
    Vec2 centre;      ///< m
    double angle = 0; ///< rad
    Vec2 velocity;    ///< m/s
    double spin = 0;  ///< rad/s
};

/// The forces that act on a body from outside throughout a frame.
struct Load {
    Vec2 force;        ///< N, at the centre of mass
    double torque = 0; ///< N m
    /// Whether it varies smoothly with the body's place, as a StateRate says, and does not look ahead. What
    /// does not vary may begin or end from one step to the next.
    bool varies = false;
};

/// Beyond these limits an engine in single precision fails; loads and impulses are limited to them.
inline constexpr double maximumAcceleration = 1e6;        ///< m/s²
inline constexpr double maximumAngularAcceleration = 1e6; ///< rad/s²
inline constexpr double maximumSpeed = 1e4;               ///< m/s
inline constexpr double maximumDistance = 1e6;            ///< m from the origin

/// A body for an engine; all data have been checked.
struct BodySpec {
    ObjectId object;
    Shape const* shape = nullptr;
    MassProperties spread; ///< distribution of its mass
    double mass = 0;       ///< kg, of a movable body
    bool fixed = false;
    bool bullet = false;
    double friction = 0;
    double restitution = 0;
    CollisionGroups groups;
    Damping damping;
    Motion motion;
};

/// A joint for an engine; all data have been checked. Its anchors are relative to centres of mass.
struct JointSpec {
    Joint const* joint = nullptr;
    JointAnchors anchors;
    SlotIndex a = noSlot;
    SlotIndex b = noSlot;     ///< noSlot: the world
    SlotIndex gearA = noSlot; ///< of a gear: the joints that it couples
    SlotIndex gearB = noSlot;
};

struct MovedBody {
    SlotIndex slot = noSlot;
    Motion motion;
};

/// One pair of pieces of two bodies that began (+1) or ceased (-1) to touch.
struct TouchChange {
    ObjectId a;
    ObjectId b;
    int delta = 0;
};

/// A rigid-body engine. Used by one thread at a time. Its results depend only on the sequence of calls.
/// Functions that are not const may throw EngineFailure; after that only lost() may be called.
class Engine : public Abandonable {
public:
    virtual void addBody(SlotIndex slot, BodySpec const& spec) = 0;
    /// The body's joints must have been removed before. Wakes the bodies that it touched.
    virtual void removeBody(SlotIndex slot) = 0;
    virtual void addJoint(SlotIndex slot, JointSpec const& spec) = 0;
    /// Gears that couple the joint must have been removed before. Wakes the bodies that it connected.
    virtual void removeJoint(SlotIndex slot) = 0;

    /// Sets the motion of a body and wakes it.
    virtual void place(SlotIndex slot, Motion const& motion) = 0;
    /// Whether a body has exactly this motion, in the engine's precision.
    [[nodiscard]] virtual bool isAt(SlotIndex slot, Motion const& motion) const = 0;

    /// Sets the loads of all bodies from now on, by slot. Wakes no body.
    virtual void setLoads(std::span<Load const> loads) = 0;
    /// Sets the resistance to the motion of all bodies from now on, by slot; bodies beyond the end of the
    /// list have none. Engines apply it by a DraggedBody in every substep, so that no coefficient is too
    /// large. Wakes no body.
    virtual void setDrags(std::span<Drag const> drags) = 0;
    virtual void wake(SlotIndex slot) = 0;
    /// Applies an impulse at a point of the world; wakes the body.
    virtual void applyImpulse(SlotIndex slot, Vec2 impulse, Vec2 point) = 0;
    /// By slot: not 0 if the body is awake. Fixed bodies are never awake.
    [[nodiscard]] virtual std::span<std::uint8_t const> awake() const = 0;
    [[nodiscard]] virtual bool anyAwake() const = 0;

    /// Sets whether hinges, welds and rigid distances are solved exactly and simultaneously in all later
    /// substeps. Off at first. Returns whether they will be: not every engine supports it.
    virtual bool solveJointsAtOnce(bool) { return false; }
    /// Sets whether step() must report the touches at its end. On at first. Otherwise it may report the
    /// touches at the beginning of the last substep, which may be cheaper; no touch is missed, but it may be
    /// reported a substep late. The motion is the same.
    virtual void findTouchesAtEnd(bool) {}
    /// Sets whether the number of substeps is the engine's choice in all later steps, for each group of
    /// touching bodies apart. Off at first. The settings' number is then that which the joints need. Returns
    /// whether it will choose: not every engine does.
    virtual bool chooseSubsteps(bool) { return false; }
    /// Whether a constant force leads to the exact parabola in any number of substeps.
    [[nodiscard]] virtual bool exactForConstantForces() const { return false; }
    /// Computes the motion for `duration` (s), split into the settings' substeps.
    virtual void step(double duration, DynamicsSettings const& settings) = 0;
    /// The bodies that were awake in the last step, ascending by slot.
    [[nodiscard]] virtual std::span<MovedBody const> moved() const = 0;
    /// Touches that began and ceased since the last call, in the order of time. The caller empties the list.
    [[nodiscard]] virtual std::vector<TouchChange>& touchChanges() = 0;
    /// Appends all present contacts, in any fixed order, with a < b.
    virtual void addContactPatches(std::vector<ContactPatch>& patches) const = 0;
    /// Sets whether later steps record impacts. Off at first. An engine that cannot detect impacts has none.
    virtual void noteImpacts(bool) {}
    /// The impacts of the last step(), in any fixed order.
    [[nodiscard]] virtual std::span<Impact const> impacts() const { return {}; }
    /// The mean force that a joint exerted during the last step(), in N.
    [[nodiscard]] virtual Vec2 jointForce(SlotIndex slot) const = 0;
    /// The bodies whose places or velocities are not finite, ascending by slot.
    [[nodiscard]] virtual std::vector<SlotIndex> lost() const { return {}; }
};

/// Makes an engine whose unit of length is 1/`scale` m.
using EngineMaker = std::unique_ptr<Engine> (*)(double scale);

} // namespace trembler
