// The engine interface implemented with the Open Dynamics Engine.
//
// ODE is three-dimensional; no force here acts out of the plane, and bodies that rounding errors move out of
// it are put back in every substep. It computes in double precision, so metres can be used as its unit. Its
// solvers and joints are used; contacts are found by Box2D's collision routines, because ODE's are made for
// three-dimensional shapes.
#pragma once

#include "physics/dynamics/engines/ode/ode_handles.hpp"
#include "physics/dynamics/engines/substepped/joint_rows.hpp"
#include "physics/dynamics/engines/substepped/substepped_engine.hpp"
#include "physics/dynamics/engines/substepped/touch_finder.hpp"

#include <map>
#include <optional>

namespace trembler {

class OdeEngine final : public SubsteppedEngine {
public:
    explicit OdeEngine(double scale);
    ~OdeEngine() override = default;

private:
    struct Joined { // a joint
        Joint joint;
        JointAnchors anchors;
        SlotIndex a = noSlot;
        SlotIndex b = noSlot;
        OdeJoint main;        // the joint's constraint
        OdeJoint drive;       // a hinge's motor and limits
        bool flipped = false; // ODE's first body is our b, because our a is fixed
        std::unique_ptr<dJointFeedback> feedback;
        std::optional<JointRows> rows;
        Vec2 impulse; // N s on a in the last substep
    };
    using Pair = std::pair<SlotIndex, SlotIndex>;

    void makeBody(SlotIndex slot, BodySpec const& spec) override;
    void dropBody(SlotIndex slot) override;
    void makeJoint(SlotIndex slot, JointSpec const& spec) override;
    void dropJoint(SlotIndex slot) override;
    [[nodiscard]] Motion motionOf(SlotIndex slot) const override { return motions_[slot]; }
    void setMotion(SlotIndex slot, Motion const& motion) override;
    void rouse(SlotIndex slot) override;
    void layToRest(std::span<SlotIndex const> island) override;
    void move(double h, DynamicsSettings const& settings, std::vector<PieceContact>& found) override;
    bool lookAgain(std::span<SlotIndex const> fast, std::vector<PieceContact>& found) override;
    [[nodiscard]] Vec2 jointImpulse(SlotIndex slot) const override { return joined_[slot]->impulse; }

    // Bodies.
    [[nodiscard]] dBodyID idOf(SlotIndex slot) const { return slot == noSlot ? nullptr : ids_[slot].get(); }
    [[nodiscard]] Motion motionOrOrigin(SlotIndex slot) const {
        return slot == noSlot ? Motion{} : motions_[slot];
    }
    void sync(SlotIndex slot);
    void readBack(SlotIndex slot, double h);
    /// The share of the path `way` that a body can move before its core hits something.
    [[nodiscard]] double freeShare(SlotIndex slot, Motion const& from, Vec2 way) const;

    // Joints.
    void attach(Joined& joined);
    void attachHinge(Joined& joined);
    void prepareJoints(double h);
    void pullTaut(Joined& joined);
    /// Solves joints that ODE lacks as rows, before ODE's step, for the motion without contacts.
    void solveRows(double h, int iterations);
    void noteJointImpulses(double h);

    // Contacts.
    void findTouches();
    [[nodiscard]] bool mayTouch(SlotIndex a, SlotIndex b) const;
    void choosePressing();
    void addContacts(double h);
    [[nodiscard]] PieceContact contactOf(FoundTouch const& touch) const;
    void reportContacts(double h, std::vector<PieceContact>& found) const;
    /// Rows of the largest island, which determine the cost of an exact solution.
    [[nodiscard]] std::size_t largestIsland();
    /// Number of sweeps of ODE's relaxation, in a substep of `h` seconds; call after largestIsland().
    [[nodiscard]] int sweepsFor(int iterations, double h) const;

    OdeWorld world_;
    OdeJointGroup contacts_; // of one substep
    TouchFinder finder_;
    std::vector<OdeBody> ids_;    // by slot; empty where fixed
    std::vector<Motion> motions_; // by slot
    std::vector<std::unique_ptr<Joined>> joined_;
    std::map<Pair, int> apart_; // number of joints of each joined pair that must not collide
    std::vector<FoundTouch> touches_;
    std::vector<std::array<dJointFeedback, 2>> feedback_; // by index of touches_
    std::vector<std::uint8_t> pressing_; // by index of touches_: whether ODE receives the contact
    std::vector<SlotIndex> awakeSlots_;
    std::vector<std::size_t> parents_;
    std::vector<std::size_t> rowsOf_;
};

} // namespace trembler
