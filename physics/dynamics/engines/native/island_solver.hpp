// One island through one step.
#pragma once

#include "physics/dynamics/engines/native/native_engine.hpp"

#include <optional>
#include <span>
#include <vector>

namespace trembler::native {

/// A contact as a damped spring, for its points' effective masses.
struct Softness {
    double bias = 0;  ///< 1/s, the share of an overlap that is closed
    double yield = 0; ///< how much of its mass a spring yields
};

/// With what a body moves in a substep.
struct Drift {
    Vec2 velocity;   ///< m/s
    double spin = 0; ///< rad/s
};

[[nodiscard]] Softness softness(double h);
/// Overlapping bodies part no faster than this, m/s.
inline constexpr double fastestParting = 0.5;

class IslandSolver {
public:
    IslandSolver(NativeEngine& engine, Island const& island, DynamicsSettings const& settings);
    void run(double duration);

private:
    /// A step knows the loads of its beginning only. When those of its end are known, in the next step,
    /// velocities get the mean of both, where loads vary smoothly: the method of Verlet (L. Verlet 1967),
    /// which is of second order and symplectic.
    void catchUpLoads();
    /// Substeps of the step that the island needs.
    [[nodiscard]] int demand(double duration) const;
    /// The time (s), at most `remaining`, for which the contacts that are known now suffice.
    [[nodiscard]] double interval(double remaining) const;
    [[nodiscard]] double safeTime(Contact const& contact, double remaining) const;
    void findContacts(double time);
    void makeRows();
    void substep(double h, int halvings = 0);
    /// Whether what a substep that cannot be split any more has left open is no fault of its equations; takes
    /// away what it gained.
    [[nodiscard]] bool bearable(double h, int halvings);
    [[nodiscard]] double fastest() const; ///< m/s, of its bodies

    void startRows(double h);
    void accelerate(SlotIndex slot, double h);
    void solveContacts(double h, bool bias);
    /// How often contacts are solved in a substep.
    [[nodiscard]] int contactRounds(double h) const;
    /// The island's kinetic energy over what it may have: that before contacts acted, and that of bodies
    /// which part with the speed `fastest` (m/s).
    [[nodiscard]] double excess(double fastest) const;
    /// Back to before contacts acted, without a first guess of their forces.
    void startAnew();
    void forgetForces();
    /// Slows all bodies until the island has no more energy than it may have; `gain`: of excess() or
    /// gainOf().
    void takeGainAway(double gain);
    void findBearing();
    void move(double h);
    void noteForces(double h);

    // joined_substep.cpp
    /// A substep of an island with joints.
    /// Returns whether the joints are closed after it.
    bool joinedSubstep(double h);
    /// Whether a body is about to turn further than its contacts can be foreseen.
    [[nodiscard]] bool leaps(double h) const;
    void remember();
    void restore();
    void springLoads(std::vector<Load>& loads) const;
    void prepareJoints(double h, bool trial);
    /// Springs, and the impulses of the last substep as a first guess.
    void beginJoints(double h);
    void keepImpulses();
    void takeExactRows(bool anew);
    void solveBounded();
    void findContactErrors(double h, std::size_t first);
    void noteNormals();
    /// The island's kinetic energy after a substep over what it may have.
    [[nodiscard]] double gainOf(double h) const;
    [[nodiscard]] bool wantsExactContacts() const;
    void give(ExactRow const& row, double impulse, double share);
    [[nodiscard]] bool findWeights();
    [[nodiscard]] Drift driftOf(SlotIndex slot) const;
    bool closeGaps(double h, int rounds);
    void stopRates(double h, int rounds);
    [[nodiscard]] double rateOf(ExactRow const& row) const;

    // relaxed_substep.cpp
    void relaxedSubstep(double h);
    void relaxJoints(double h, bool closes);
    /// Whether this step begins relaxed, since the last ones could not hold the joints exactly.
    [[nodiscard]] bool beginsRelaxed();
    void noteTroubles();

    // smooth_motion.cpp
    /// Moves an island of joints, on which nothing else acts, for as long (s) as this lasts, and returns how
    /// long.
    double moveSmoothly(double duration);

    // impact.cpp
    struct Hit {
        double after = 0; ///< s
        bool any = false;
    };
    /// The first impact with restitution within `time` (s); marks all rows that await one within it.
    [[nodiscard]] Hit firstHit(double time);
    /// Whether bodies that meet `after` (s) move so far past each other by then that their normal turns.
    [[nodiscard]] bool hitsAside(double after) const;
    /// Lets all bodies that are about to meet bounce; `ahead` (s): how much earlier than they would.
    void bounce(double ahead);
    [[nodiscard]] double approachLimit(ContactRow const& row, double h) const;
    bool strike(ContactRow& row, double slowest);
    /// The impacts of those of these contacts that meet at the speed `fastest` (m/s), if they are several.
    bool strikeTogether(std::span<ContactRow* const> near, double fastest);
    [[nodiscard]] double kineticEnergyNow() const; ///< J

    // jointed_impact.cpp
    /// Velocities that joints do not allow are corrected. To be called before the impacts of one moment, and
    /// after velocities were changed from outside.
    void beginJointedImpacts();
    /// Impulses of joints after which the velocities keep the constraints again.
    void followImpact();
    /// The speeds at a contact's points after an impulse at one of them, which joints follow; changes
    /// nothing.
    [[nodiscard]] std::array<double, 2> speedsAfter(ContactRow const& row, std::size_t point, double impulse);
    /// Adds the impulses of joints to the forces that break them.
    void endJointedImpacts();

    [[nodiscard]] MovingState& stateOf(SlotIndex slot) { return engine_.states_[slot]; }
    [[nodiscard]] MovingState const& stateOf(SlotIndex slot) const { return engine_.states_[slot]; }
    [[nodiscard]] double gapOf(ContactRow const& row, std::size_t point) const;
    [[nodiscard]] double normalSpeed(ContactRow const& row, PointRow const& point) const;
    /// m/s, of b along the surface.
    [[nodiscard]] double slipOf(ContactRow const& row, PointRow const& point) const;
    void push(ContactRow const& row, PointRow const& point, double normal, double across);
    /// Nothing if it is too weak, or if nobody asks for impacts.
    [[nodiscard]] std::optional<Impact> impactOf(ContactRow const& row, double impulse) const;
    /// A body under its loads, before its contacts and joints act in this substep.
    [[nodiscard]] ImpactBudget::Body beforeImpact(SlotIndex slot) const;
    /// Reports the impacts of this substep.
    void settleImpacts();

    friend class SmoothMotion;

    NativeEngine& engine_;
    Island const& island_;
    DynamicsSettings const& settings_;
    std::vector<ContactRow>& rows_;
    std::vector<Contact*>& seams_;
    struct Memory {
        Vec2 centre;
        double angle = 0;
        MovingState state;
        DraggedBody dragged;
    };
    struct JointMemory {
        double last = 0;
        std::array<double, 5> impulses{};
    };
    std::vector<Memory> memory_; ///< of the bodies before a substep
    std::vector<JointMemory> jointMemory_;
    std::vector<double> jointImpulses_; ///< N s, during an impact
    bool jointsStrike_ = false;         ///< joints take part in the impacts of this moment
    int splits_ = 0;                    ///< of substeps in this step
    bool relaxes_ = false;              ///< joints cannot hold exactly in this step
    double misfit_ = 0;                 ///< m or rad, of joints after the last substep
    bool exactContacts_ = false;        ///< normal impulses are exact rows, too
    double h_ = 0;                      ///< s, of the usual substep
    double since_ = 0;                  ///< s, since the step's beginning
};

} // namespace trembler::native
