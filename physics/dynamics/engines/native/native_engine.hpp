// Rigid bodies by an engine of this project, for contacts that come out as computed by hand.
//
// A step finds the pairs of pieces that may meet in it, groups the bodies that may touch into islands, and
// solves each island by itself with as many substeps as it needs: so the cost of a heavy stack is paid for
// that stack alone. Within a substep contacts are soft constraints whose bias is taken back at the end (M.
// Macklin et al., "Small steps in physics simulation", 2019; E. Catto, "Solver2D", 2024). Impacts with
// restitution are computed one after the other, at the time at which they occur (impact.cpp). All of it is in
// double precision, relative to the bodies.
#pragma once

#include "physics/dynamics/engines/impact_budget.hpp"
#include "physics/dynamics/engines/native/contact.hpp"
#include "physics/dynamics/engines/native/exact_rows.hpp"
#include "physics/dynamics/engines/native/island.hpp"
#include "physics/dynamics/engines/native/near_pairs.hpp"
#include "physics/dynamics/engines/native/solving_order.hpp"
#include "physics/dynamics/engines/substepped/joint_rows.hpp"

#include <memory>
#include <vector>

namespace trembler::native {

/// Pieces this close, in m, touch; those that touch do so until they are twice as far apart.
inline constexpr double touchGap = 2e-5;
/// Bodies that press on each other touch although they are as far apart (m), as what rolls or slides over a
/// corner is: within a step, contacts keep the direction that they had at its beginning.
inline constexpr double pressedGap = 2e-4;

class NativeEngine final : public Engine {
public:
    void addBody(SlotIndex slot, BodySpec const& spec) override;
    void removeBody(SlotIndex slot) override;
    void addJoint(SlotIndex slot, JointSpec const& spec) override;
    void removeJoint(SlotIndex slot) override;
    void place(SlotIndex slot, Motion const& motion) override;
    [[nodiscard]] bool isAt(SlotIndex slot, Motion const& motion) const override;
    void setLoads(std::span<Load const> loads) override;
    void setDrags(std::span<Drag const> drags) override;
    void wake(SlotIndex slot) override;
    void applyImpulse(SlotIndex slot, Vec2 impulse, Vec2 point) override;
    [[nodiscard]] std::span<std::uint8_t const> awake() const override { return awake_; }
    [[nodiscard]] bool anyAwake() const override { return anyAwake_; }
    bool chooseSubsteps(bool wanted) override {
        choosesSubsteps_ = wanted;
        return true;
    }
    bool solveJointsAtOnce(bool) override { return true; }
    [[nodiscard]] bool exactForConstantForces() const override { return true; }
    void step(double duration, DynamicsSettings const& settings) override;
    [[nodiscard]] std::span<MovedBody const> moved() const override { return moved_; }
    [[nodiscard]] std::vector<TouchChange>& touchChanges() override { return touches_; }
    void addContactPatches(std::vector<ContactPatch>& patches) const override;
    void noteImpacts(bool wanted) override { impactsWanted_ = wanted; }
    [[nodiscard]] std::span<Impact const> impacts() const override { return impacts_; }
    [[nodiscard]] Vec2 jointForce(SlotIndex slot) const override { return joints_[slot].force; }
    [[nodiscard]] std::vector<SlotIndex> lost() const override;

private:
    [[nodiscard]] bool moves(SlotIndex slot) const {
        return slot != noSlot && bodies_[slot].object.valid() && !bodies_[slot].fixed;
    }
    [[nodiscard]] bool mayTouch(SlotIndex a, SlotIndex b) const;
    [[nodiscard]] Motion motionOf(SlotIndex slot) const;
    void setPose(SlotIndex slot);
    void forgetPairs(SlotIndex slot);
    void wakeTouching(SlotIndex slot);
    void removeContacts(std::vector<std::uint64_t> const& gone);
    void tie(SlotIndex a, SlotIndex b, int change);

    // step.cpp
    /// How far (m) a body's points may move in a time.
    [[nodiscard]] double reach(SlotIndex slot, double time) const;
    void followPairs(double duration);
    void findReaches(double time);
    void meetAll();
    void meetOne(Contact& contact, double margin) const;
    void findWelds();
    /// Whether a contact has points, and no welds hold its bodies to each other.
    [[nodiscard]] bool acts(Contact const& contact) const {
        return contact.meeting.count > 0 &&
               (welded_[contact.a] == noSlot || welded_[contact.a] != welded_[contact.b]);
    }
    void wakeByContacts(double duration);
    void makeIslands();
    void reportTouches();
    void change(Contact const& contact, int delta);

    // sleep.cpp
    void findRest(double duration);
    [[nodiscard]] bool idles(SlotIndex slot) const;

    friend class IslandSolver;
    friend class SmoothMotion;

    std::vector<BodyEntry> bodies_;
    std::vector<MovingState> states_;
    std::vector<Pose> poses_;
    std::vector<std::uint8_t> awake_;
    std::vector<DraggedBody> dragged_; // by slot; empty if no body has drag
    std::vector<JointEntry> joints_;
    std::vector<SlotIndex> welded_; // by slot: names the group of bodies that welds hold, or noSlot
    bool weldsKnown_ = true;
    std::vector<std::pair<SlotIndex, SlotIndex>> apart_; // bodies that a joint keeps from colliding, sorted
    NearPairs pairs_;
    std::vector<Contact> contacts_; // ascending by key, as pairs_
    std::vector<Contact> mergedContacts_;
    std::vector<double> reaches_; // m, by slot
    std::vector<Contact*> seamSearch_;
    std::vector<ContactRow> rows_; // of the island that is solved
    std::vector<RowDetail> rowDetails_;
    SolvingOrder solvingOrder_;
    ExactRows exact_;
    std::vector<double> follows_;        // by slot: how much of an impulse's velocity a body's drift has
    std::vector<Load> springLoads_;      // by slot
    std::vector<Load> springLoadsNow_;   // by slot
    std::vector<double> right_;          // of the system of exact rows
    std::vector<std::uint32_t> indices_; // by slot: of a body in the island that is moved smoothly
    std::vector<std::uint64_t> gone_;
    std::vector<std::uint64_t> come_;
    Islands islands_;
    std::uint32_t naps_ = 0;
    bool anyAwake_ = false;
    bool impactsWanted_ = false;
    bool choosesSubsteps_ = false;
    double duration_ = 0;  // s, of the present step
    double patchStep_ = 0; // s, for whose length impulses are reported
    std::vector<TouchChange> touches_;
    ImpactBudget budget_;
    std::vector<Impact> impacts_;
    std::vector<MovedBody> moved_;
    std::vector<std::uint8_t> movedMarks_;
};

} // namespace trembler::native
