// A substep of joints that cannot hold exactly: they contradict each other, or so many act between the same
// bodies that their equations are dense. Each is solved by itself, as contacts are, in many rounds: what is
// left of their errors stays, and none of it becomes motion.
#include "physics/dynamics/engines/native/island_solver.hpp"
#include "physics/dynamics/engines/sleep_limits.hpp"

#include <algorithm>

namespace trembler::native {
namespace {

constexpr int roundsOfJoints = 30;
constexpr int roundsAfter = 4;
// The share of an error that a substep takes away, and how fast at most, m/s or rad/s.
constexpr double closingShare = 0.2;
constexpr double fastestRelaxing = 1;
// A group whose joints could not hold in so many steps one after the other is relaxed for so many more,
// before they are tried exactly again.
constexpr int mostTroubles = 3;
constexpr int relaxedSteps = 60;

} // namespace

bool IslandSolver::beginsRelaxed() {
    int& troubles = engine_.bodies_[island_.bodies[0]].troubles;
    if (troubles > mostTroubles) {
        --troubles;
        return troubles > mostTroubles;
    }
    return false;
}

void IslandSolver::noteTroubles() {
    int& troubles = engine_.bodies_[island_.bodies[0]].troubles;
    if (troubles > mostTroubles) {
        return;
    }
    troubles = relaxes_ ? troubles + 1 : 0;
    if (troubles == mostTroubles) {
        troubles += relaxedSteps;
    }
}

void IslandSolver::relaxJoints(double h, bool closes) {
    for (ExactRow& row : engine_.exact_.rows()) {
        double yields = 0; // 1/kg
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
            ExactTerm const& term = row.terms[i];
            if (term.slot != noSlot) {
                MovingState const& state = stateOf(term.slot);
                yields += state.inverseMass * lengthSquared(term.linear) +
                          state.inverseInertia * term.angular * term.angular;
            }
        }
        if (yields <= 0) {
            continue;
        }
        double rate = 0; // at which it should change
        if (row.oneSided && row.error > 0) {
            rate = -row.error / h; // it may just reach its end
        } else if (closes) {
            rate = std::clamp(-closingShare * row.error / h, -fastestRelaxing, fastestRelaxing);
        }
        double more = (rate - rateOf(row)) / yields;
        if (row.oneSided) {
            more = std::max(more, -row.impulse);
        }
        row.impulse += more;
        give(row, more, 1);
    }
}

void IslandSolver::relaxedSubstep(double h) {
    beginJoints(h);
    for (int round = 0; round < roundsOfJoints; ++round) {
        solveBounded();
        solveContacts(h, true);
        relaxJoints(h, true);
    }
    for (SlotIndex const slot : island_.bodies) {
        stateOf(slot).borne = Borne::held; // it moves with the velocity that the joints allow
        if (length(stateOf(slot).velocity) > slowSpeed) {
            engine_.bodies_[slot].idle = 0; // although it is stopped afterwards
        }
    }
    // Where nothing touches, joints that close slowly can throw nothing.
    if (!rows_.empty() || fastest() > 2 * fastestRelaxing) {
        takeGainAway(gainOf(h));
    }
    move(h);
    prepareJoints(h, false);
    takeExactRows(false);
    for (int round = 0; round < roundsAfter; ++round) {
        solveBounded();
        solveContacts(h, false);
        relaxJoints(h, false);
    }
    keepImpulses();
    takeGainAway(gainOf(h));
}

} // namespace trembler::native
