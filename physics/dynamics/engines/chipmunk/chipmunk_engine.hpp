// The engine interface implemented with Chipmunk 7.
//
// Chipmunk computes in double precision, so metres can be used as its unit. Its contacts, solver, broad phase
// and sleeping are used. Its joints are not, because it has no joints that couple other joints (gears,
// pulleys) and no softness: joints are our own rows, which its solver iterates like any other constraint.
#pragma once

#include "physics/dynamics/engines/substepped/joint_rows.hpp"
#include "physics/dynamics/engines/substepped/substepped_engine.hpp"

#include <chipmunk/chipmunk.h>

namespace trembler {

struct ChipmunkJoint;

class ChipmunkEngine final : public SubsteppedEngine {
public:
    ChipmunkEngine();
    ~ChipmunkEngine() override;

private:
    struct Place { // for a body's callbacks
        ChipmunkEngine* engine = nullptr;
        SlotIndex slot = noSlot;
    };
    struct SpaceFree {
        void operator()(cpSpace* space) const { cpSpaceFree(space); }
    };
    struct JointFree {
        void operator()(ChipmunkJoint* joint) const;
    };

    void makeBody(SlotIndex slot, BodySpec const& spec) override;
    void dropBody(SlotIndex slot) override;
    void makeJoint(SlotIndex slot, JointSpec const& spec) override;
    void dropJoint(SlotIndex slot) override;
    [[nodiscard]] Motion motionOf(SlotIndex slot) const override;
    void setMotion(SlotIndex slot, Motion const& motion) override;
    void rouse(SlotIndex slot) override;
    void layToRest(std::span<SlotIndex const> island) override;
    void move(double h, DynamicsSettings const& settings, std::vector<PieceContact>& found) override;
    [[nodiscard]] Vec2 jointImpulse(SlotIndex slot) const override;

    static void limitSpeed(cpBody& body);

    // Callbacks that Chipmunk calls during its step.
    static void updateVelocity(cpBody* body, cpVect gravity, cpFloat damping, cpFloat h);
    static void updatePosition(cpBody* body, cpFloat h);
    static cpBool beginTouch(cpArbiter* arbiter, cpSpace* space, cpDataPointer self);
    static cpBool beforeSolving(cpArbiter* arbiter, cpSpace* space, cpDataPointer self);
    static void afterSolving(cpArbiter* arbiter, cpSpace* space, cpDataPointer self);
    /// The share of its path in `h` (s) that a body can move before its core hits something.
    [[nodiscard]] double freeShare(cpBody const* body, SlotIndex slot, double h) const;
    void noteContact(cpArbiter const& arbiter);

    std::unique_ptr<cpSpace, SpaceFree> space_;
    std::vector<cpBody*> bodies_;                // by slot
    std::vector<std::unique_ptr<Place>> places_; // by slot
    std::vector<std::unique_ptr<ChipmunkJoint, JointFree>> joints_;
    std::vector<PieceContact>* found_ = nullptr; // output of the current step; nullptr outside it
    double h_ = 0;
};

/// Adds the pieces of a shape to a body whose origin is the shape's centre of mass, and stores their
/// pieceName().
void addShapes(cpSpace& space, cpBody& body, SlotIndex slot, BodySpec const& spec);
/// The name that addShapes() stored.
[[nodiscard]] std::uint32_t pieceOf(cpShape const* shape);

/// Makes a space without the message that the library prints on standard output the first time.
[[nodiscard]] cpSpace* newSpaceQuietly();

} // namespace trembler
