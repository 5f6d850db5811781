// The Open Dynamics Engine behind the engine interface.
//
// ODE knows three dimensions; no force here acts out of the plane, and bodies that rounding moves out of it
// are put back in every substep. It computes in double precision, so it works in metres. Its solvers and
// joints are used; contacts are found by Box2D's collision routines, as ODE's are made for boxes and balls in
// space.
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
        OdeJoint main;        // holds
        OdeJoint drive;       // a hinge's motor and limits
        bool flipped = false; // ODE's first body is our b, as our a does not move
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
    void tell(SlotIndex slot);
    void readBack(SlotIndex slot, double h);
    /// The share of its way that a body can go before its core hits something.
    [[nodiscard]] double freeShare(SlotIndex slot, Motion const& from, Vec2 way) const;

    // Joints.
    void attach(Joined& joined);
    void attachHinge(Joined& joined);
    void prepareJoints(double h);
    void pullTaut(Joined& joined);
    /// Joints that ODE lacks: as rows, solved ahead of ODE, for where bodies would go without contacts.
    void solveRows(double h, int iterations);
    void noteJointImpulses(double h);

    // Contacts.
    void findTouches();
    [[nodiscard]] bool mayTouch(SlotIndex a, SlotIndex b) const;
    void choosePressing();
    void addContacts(double h);
    [[nodiscard]] PieceContact contactOf(FoundTouch const& touch) const;
    void reportContacts(double h, std::vector<PieceContact>& found) const;
    /// Rows of the largest island, from which the cost of an exact solution follows.
    [[nodiscard]] std::size_t largestIsland();
    /// Sweeps of the approximate solution, after largestIsland().
    /// Of ODE's relaxation, in a substep of `h` seconds.
    [[nodiscard]] int sweepsFor(int iterations, double h) const;

    OdeWorld world_;
    OdeJointGroup contacts_; // of one substep
    TouchFinder finder_;
    std::vector<OdeBody> ids_;    // by slot; nothing where fixed
    std::vector<Motion> motions_; // by slot
    std::vector<std::unique_ptr<Joined>> joined_;
    std::map<Pair, int> apart_; // joined bodies that must not hit each other
    std::vector<FoundTouch> touches_;
    std::vector<std::array<dJointFeedback, 2>> feedback_; // of touches_
    std::vector<std::uint8_t> pressing_;                  // of touches_: ODE has received it
    std::vector<SlotIndex> awakeSlots_;
    std::vector<std::size_t> parents_;
    std::vector<std::size_t> rowsOf_;
};

} // namespace trembler
