// The interface of rigid-body engines to Dynamics: Box2D, Chipmunk and ODE implement it.
#pragma once

#include "physics/dynamics/core/drag.hpp"
#include "physics/dynamics/core/engine_failure.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/impacts.hpp"
#include "physics/dynamics/properties/joint_anchors.hpp"
#include "physics/dynamics/properties/mass_properties.hpp"
#include "physics/dynamics/properties/settings.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace trembler {

/// The place of a body, or of a joint, in the tables that Dynamics and its engine share. Small and used
/// again.
using SlotIndex = std::uint32_t;
inline constexpr SlotIndex noSlot = std::numeric_limits<SlotIndex>::max();

/// How a body moves; of its centre of mass.
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
};

/// Beyond these an engine in single precision breaks down; loads and impulses are cut down to them.
inline constexpr double maximumAcceleration = 1e6;        ///< m/s²
inline constexpr double maximumAngularAcceleration = 1e6; ///< rad/s²
inline constexpr double maximumSpeed = 1e4;               ///< m/s
inline constexpr double maximumDistance = 1e6;            ///< m from the origin

/// A body for an engine; everything in it has been checked.
struct BodySpec {
    ObjectId object;
    Shape const* shape = nullptr;
    MassProperties spread; ///< how its mass is spread
    double mass = 0;       ///< kg, of one that moves
    bool fixed = false;
    bool bullet = false;
    double friction = 0;
    double restitution = 0;
    CollisionGroups groups;
    Damping damping;
    Motion motion;
};

/// A joint for an engine; everything in it has been checked. Its anchors are relative to centres of mass.
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

/// A rigid-body engine. Used by one thread at a time. Everything that it does follows from the order of
/// calls. All that is not const may throw EngineFailure; after that only lost() may be called.
class Engine : public Abandonable {
public:
    virtual void addBody(SlotIndex slot, BodySpec const& spec) = 0;
    /// Its joints must have been removed before. Wakes the bodies that it touched.
    virtual void removeBody(SlotIndex slot) = 0;
    virtual void addJoint(SlotIndex slot, JointSpec const& spec) = 0;
    /// Gears that couple it must have been removed before. Wakes the bodies that it tied.
    virtual void removeJoint(SlotIndex slot) = 0;

    /// Puts a body elsewhere and wakes it.
    virtual void place(SlotIndex slot, Motion const& motion) = 0;
    /// Whether a body is exactly there, in the engine's precision.
    [[nodiscard]] virtual bool isAt(SlotIndex slot, Motion const& motion) const = 0;

    /// The loads of every body from now on, by slot. Wakes no body.
    virtual void setLoads(std::span<Load const> loads) = 0;
    /// The resistance to the motion of every body from now on, by slot; none where the list ends before. An
    /// engine lets a DraggedBody act in every substep, so that no coefficient is too large. Wakes no body.
    virtual void setDrags(std::span<Drag const> drags) = 0;
    virtual void wake(SlotIndex slot) = 0;
    /// At a point of the world; wakes the body.
    virtual void applyImpulse(SlotIndex slot, Vec2 impulse, Vec2 point) = 0;
    /// By slot: not 0 where the body is awake. Bodies that are fixed never are.
    [[nodiscard]] virtual std::span<std::uint8_t const> awake() const = 0;
    [[nodiscard]] virtual bool anyAwake() const = 0;

    /// Whether hinges, welds and rigid distances are to be solved exactly, all at once, in every substep to
    /// come. Off at first. Returns whether they will be: an engine that cannot goes on as it did.
    virtual bool solveJointsAtOnce(bool) { return false; }
    /// Whether touches must be known as they are at the end of each step(). On at first. If not, it is enough
    /// to report a touch as it was at the beginning of the last substep, which may be cheaper; no touch is
    /// missed, but it may be reported a substep late. The motion is the same.
    virtual void findTouchesAtEnd(bool) {}
    /// Moves everything on by `duration` (s), split into the settings' substeps.
    virtual void step(double duration, DynamicsSettings const& settings) = 0;
    /// The bodies that were awake in the last step, ascending by slot.
    [[nodiscard]] virtual std::span<MovedBody const> moved() const = 0;
    /// Touches that began and ceased since they were last taken, in the order in which they did.
    [[nodiscard]] virtual std::vector<TouchChange>& touchChanges() = 0;
    /// Appends all contacts as they stand, in any fixed order, with a < b.
    virtual void addContactPatches(std::vector<ContactPatch>& patches) const = 0;
    /// Whether impacts are to be noted in the steps to come. Off at first. An engine that cannot detect
    /// impacts has none.
    virtual void noteImpacts(bool) {}
    /// The impacts of the last step(), in any fixed order.
    [[nodiscard]] virtual std::span<Impact const> impacts() const { return {}; }
    /// The mean force that a joint exerted during the last step(), in N.
    [[nodiscard]] virtual Vec2 jointForce(SlotIndex slot) const = 0;
    /// The bodies whose places or speeds are no finite numbers, ascending by slot.
    [[nodiscard]] virtual std::vector<SlotIndex> lost() const { return {}; }
};

/// Makes an engine whose unit of length is 1/`scale` m.
using EngineMaker = std::unique_ptr<Engine> (*)(double scale);

} // namespace trembler
