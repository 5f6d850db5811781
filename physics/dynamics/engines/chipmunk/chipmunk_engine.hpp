// Chipmunk 7 behind the engine interface.
//
// Chipmunk counts in double precision, so it works in metres. Its contacts, solver, broad phase and sleeping
// bodies are used; its joints are not, as they know neither each other (gears, pulleys) nor softness: joints
// are rows of our own that its solver iterates like any other constraint.
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

    // Chipmunk calls these from within its step.
    static void updateVelocity(cpBody* body, cpVect gravity, cpFloat damping, cpFloat h);
    static void updatePosition(cpBody* body, cpFloat h);
    static cpBool beginTouch(cpArbiter* arbiter, cpSpace* space, cpDataPointer self);
    static cpBool beforeSolving(cpArbiter* arbiter, cpSpace* space, cpDataPointer self);
    static void afterSolving(cpArbiter* arbiter, cpSpace* space, cpDataPointer self);
    /// The share of its way that a body can go before its core hits something.
    [[nodiscard]] double freeShare(cpBody const* body, SlotIndex slot, double h) const;
    void noteContact(cpArbiter const& arbiter);

    std::unique_ptr<cpSpace, SpaceFree> space_;
    std::vector<cpBody*> bodies_;                // by slot
    std::vector<std::unique_ptr<Place>> places_; // by slot
    std::vector<std::unique_ptr<ChipmunkJoint, JointFree>> joints_;
    std::vector<PieceContact>* found_ = nullptr; // while it steps
    double h_ = 0;
};

/// Adds the pieces of a shape to a body whose origin is the shape's centre of mass; names them.
void addShapes(cpSpace& space, cpBody& body, SlotIndex slot, BodySpec const& spec);
/// The name that addShapes() gave.
[[nodiscard]] std::uint32_t pieceOf(cpShape const* shape);

/// Makes a space. The library greets on the standard output the first time; that goes nowhere.
[[nodiscard]] cpSpace* newSpaceQuietly();

} // namespace trembler
