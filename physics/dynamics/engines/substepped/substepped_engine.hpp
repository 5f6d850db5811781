// An engine with the features that rigid-body libraries other than Box2D lack or define differently: constant
// loads, drag, sleeping islands, beginning and ending contacts, impacts, a speed limit.
#pragma once

#include "physics/dynamics/engines/body_core.hpp"
#include "physics/dynamics/engines/substepped/touch_record.hpp"

namespace trembler {

/// An engine that uses a library to move bodies by one substep.
class SubsteppedEngine : public Engine {
public:
    void addBody(SlotIndex slot, BodySpec const& spec) final;
    void removeBody(SlotIndex slot) final;
    void addJoint(SlotIndex slot, JointSpec const& spec) final;
    void removeJoint(SlotIndex slot) final;
    void place(SlotIndex slot, Motion const& motion) final;
    [[nodiscard]] bool isAt(SlotIndex slot, Motion const& motion) const final;
    void setLoads(std::span<Load const> loads) final;
    void setDrags(std::span<Drag const> drags) final;
    void wake(SlotIndex slot) final;
    void applyImpulse(SlotIndex slot, Vec2 impulse, Vec2 point) final;
    [[nodiscard]] std::span<std::uint8_t const> awake() const final { return awake_; }
    [[nodiscard]] bool anyAwake() const final { return anyAwake_; }
    void step(double duration, DynamicsSettings const& settings) final;
    [[nodiscard]] std::span<MovedBody const> moved() const final { return moved_; }
    [[nodiscard]] std::vector<TouchChange>& touchChanges() final { return touches_.changes(); }
    void addContactPatches(std::vector<ContactPatch>& patches) const final;
    void noteImpacts(bool wanted) final { touches_.noteImpacts(wanted); }
    [[nodiscard]] std::span<Impact const> impacts() const final { return touches_.impacts(); }
    [[nodiscard]] Vec2 jointForce(SlotIndex slot) const final { return joints_[slot].force; }

protected:
    struct BodyEntry {
        ObjectId object; ///< invalid: the slot is free
        bool fixed = false;
        bool bullet = false;
        double mass = 0;    ///< kg; of a movable body
        double inertia = 0; ///< kg m²
        double friction = 0;
        double restitution = 0;
        CollisionGroups groups;
        Damping damping;
        Load load;
        BodyCore core;
        double extent = 0;      ///< m, distance of its farthest point from the centre of mass
        int restlessJoints = 0; ///< number of motors that must not fall asleep
        int joints = 0;
        double idle = 0; ///< s, for which the body has been slow
    };
    struct JointEntry {
        bool used = false;
        bool restless = false;
        SlotIndex a = noSlot;
        SlotIndex b = noSlot;
        Vec2 force; ///< N, mean over the last step()
    };

    // To be implemented by the engine of each library.
    virtual void makeBody(SlotIndex slot, BodySpec const& spec) = 0;
    virtual void dropBody(SlotIndex slot) = 0;
    virtual void makeJoint(SlotIndex slot, JointSpec const& spec) = 0;
    virtual void dropJoint(SlotIndex slot) = 0;
    [[nodiscard]] virtual Motion motionOf(SlotIndex slot) const = 0;
    virtual void setMotion(SlotIndex slot, Motion const& motion) = 0;
    /// Makes the library move the body again from now on.
    virtual void rouse(SlotIndex slot) = 0;
    /// Makes the library leave these bodies, which rest on each other, in place from now on.
    virtual void layToRest(std::span<SlotIndex const> island) = 0;
    /// Moves all awake bodies by a substep of `h` (s) and reports contacts in which at least one body is
    /// awake.
    virtual void move(double h, DynamicsSettings const& settings, std::vector<PieceContact>& found) = 0;
    /// Reports the contacts of the bodies in `fast` at the current positions, with impulses of 0. Returns
    /// false if the library only finds contacts at the substep's beginning.
    virtual bool lookAgain(std::span<SlotIndex const> /*fast*/, std::vector<PieceContact>& /*found*/) {
        return false;
    }
    /// The impulse (N s) on the joint's body a in the last substep.
    [[nodiscard]] virtual Vec2 jointImpulse(SlotIndex slot) const = 0;

    // For the engines of the libraries.
    [[nodiscard]] std::span<BodyEntry const> bodies() const { return bodies_; }
    [[nodiscard]] std::span<JointEntry const> joints() const { return joints_; }
    [[nodiscard]] bool moves(SlotIndex slot) const {
        return slot != noSlot && bodies_[slot].object.valid() && !bodies_[slot].fixed;
    }
    [[nodiscard]] bool isAwake(SlotIndex slot) const { return awake_[slot] != 0; }
    /// Wakes a body because of a contact; if it is awake, its sleep timer is not reset.
    void rouseSleeper(SlotIndex slot) {
        if (!isAwake(slot)) {
            wake(slot);
        }
    }
    /// Call when the library has woken a body by itself.
    void noteAwake(SlotIndex slot);
    /// Applies load, drag and damping to a body's velocity for `h` (s); for every body once per substep.
    void accelerate(SlotIndex slot, Motion& motion, double h);
    /// The approach speed (m/s) up to which two bodies do not bounce: a body that is pressed or turned
    /// against another by a strong load gains speed in every substep; bouncing that back would never end.
    [[nodiscard]] double bounceThreshold(SlotIndex a, SlotIndex b, double h) const;
    /// Coulomb's friction coefficient and Newton's coefficient of restitution of a pair.
    [[nodiscard]] double frictionOf(SlotIndex a, SlotIndex b) const;
    [[nodiscard]] double restitutionOf(SlotIndex a, SlotIndex b) const;

private:
    void checkMotion() const;
    void substep(double h, DynamicsSettings const& settings);
    /// Stores the motions at the beginning of a substep, for its impacts.
    void noteVelocities();
    void findImpacts(double since);
    void lookAtFast(double h);
    void findRest(double duration);
    [[nodiscard]] bool idles(SlotIndex slot, Motion const& motion) const;
    /// By slot: the lowest slot of the body's island.
    [[nodiscard]] std::vector<SlotIndex> const& islands();
    void noteMoved();
    [[nodiscard]] Twist momentumOf(SlotIndex slot) const;

    std::vector<BodyEntry> bodies_;
    std::vector<JointEntry> joints_;
    std::vector<DraggedBody> dragged_; // by slot; empty if no body has drag
    std::vector<std::uint8_t> awake_;
    std::vector<std::uint8_t> touching_; // by slot, updated by findRest()
    bool anyAwake_ = false;
    TouchRecord touches_;
    std::vector<Motion> atStart_; // by slot, of movable bodies at the beginning of the substep
    std::vector<PieceContact> found_;
    std::vector<MovedBody> moved_;
    std::vector<std::uint8_t> movedMarks_;
    std::vector<SlotIndex> roots_;
};

/// The width, in m, by which a polygon is larger than drawn, on all sides, as in Box2D: bodies rest on this
/// skin, so that gaps in levels are equally tight with every engine.
inline constexpr double skin = 0.0025; // m
/// How deep skins overlap at rest, in m.
inline constexpr double skinDepth = 0.00125; // m

} // namespace trembler
