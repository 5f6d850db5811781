// A substep of an island with joints.
//
// Rigid joints, and limits and ropes that hold, are solved exactly and at once, by the method RATTLE (H. C.
// Andersen 1983): their impulses bring the places at the substep's end onto the constraints, half of them
// acts before and half, along the new directions, after. It is symplectic, so that what swings keeps its
// energy. Contacts, motors and damped springs are solved one after the other, in turn with the exact ones.
#include "physics/dynamics/engines/native/island_solver.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::native {
namespace {

// Springs of which a substep is more than this many rad of their oscillation yield implicitly, which damps
// them.
constexpr double widestSwing = 0.5;
// Constraints hold if they are off by no more than this, m or rad.
constexpr double closed = 1e-11;
// An error is removed no faster than this, m/s or rad/s.
constexpr double fastestClosing = 10;
constexpr int mostRounds = 12;
// With contacts; in islands of more bodies than a few, once.
constexpr int roundsWithContacts = 4;
constexpr std::size_t few = 128;

} // namespace

// --- joints
// ---------------------------------------------------------------------------------------------------------

void IslandSolver::springLoads(std::vector<Load>& loads) const {
    for (SlotIndex const slot : island_.bodies) {
        loads[slot] = {};
    }
    for (SlotIndex const joint : island_.joints) {
        JointRows& rows = *engine_.joints_[joint].rows;
        std::span<SlotIndex const> const slots = rows.slots();
        for (JointRow const& row : rows.rows()) {
            for (int i = 0; i < row.count; ++i) {
                RowTerm const& term = row.terms[static_cast<std::size_t>(i)];
                SlotIndex const slot = slots[static_cast<std::size_t>(term.body)];
                if (slot != noSlot && engine_.moves(slot)) {
                    loads[slot].force += row.pull * term.linear;
                    loads[slot].torque += row.pull * term.angular;
                }
            }
        }
    }
}

void IslandSolver::prepareJoints(double h, bool trial) {
    for (SlotIndex const slot : island_.joints) {
        JointEntry& joint = engine_.joints_[slot];
        std::span<SlotIndex const> const slots = joint.rows->slots();
        std::array<JointPose, 4> poses;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            if (slots[i] != noSlot) {
                BodyEntry const& body = engine_.bodies_[slots[i]];
                MovingState const& state = stateOf(slots[i]);
                poses[i] = {body.centre, body.angle, state.inverseMass, state.inverseInertia};
                if (trial && engine_.moves(slots[i])) {
                    Drift const drift = driftOf(slots[i]);
                    poses[i].centre += h * drift.velocity;
                    poses[i].angle += h * drift.spin;
                }
            }
        }
        joint.rows->prepare({poses.data(), slots.size()}, h, widestSwing);
    }
}

void IslandSolver::takeExactRows(bool anew) {
    std::vector<ExactRow>& exact = engine_.exact_.rows();
    if (anew) {
        exact.clear();
    }
    std::size_t next = 0;
    for (SlotIndex const slot : island_.joints) {
        JointRows& joint = *engine_.joints_[slot].rows;
        std::span<SlotIndex const> const slots = joint.slots();
        for (JointRow const& row : joint.rows()) {
            if (!row.exact() || row.stiff == 0) {
                continue;
            }
            ExactRow& made = anew ? exact.emplace_back() : exact[next++];
            made.error = row.error;
            made.oneSided = row.limit();
            made.count = row.count;
            for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
                SlotIndex const body = slots[static_cast<std::size_t>(row.terms[i].body)];
                made.terms[i] = {body != noSlot && engine_.moves(body) ? body : noSlot, row.terms[i].linear,
                                 row.terms[i].angular};
            }
        }
    }
}

double IslandSolver::rateOf(ExactRow const& row) const {
    double rate = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        ExactTerm const& term = row.terms[i];
        if (term.slot != noSlot) {
            rate += dot(term.linear, stateOf(term.slot).velocity) + term.angular * stateOf(term.slot).spin;
        }
    }
    return rate;
}

void IslandSolver::give(ExactRow const& row, double impulse, double share) {
    if (impulse == 0) {
        return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        ExactTerm const& term = row.terms[i];
        if (term.slot != noSlot) {
            MovingState& state = stateOf(term.slot);
            state.velocity += share * impulse * state.inverseMass * term.linear;
            state.spin += share * impulse * state.inverseInertia * term.angular;
        }
    }
}

// Motors and damped springs.
void IslandSolver::solveBounded() {
    for (SlotIndex const slot : island_.joints) {
        JointRows& joint = *engine_.joints_[slot].rows;
        std::span<SlotIndex const> const slots = joint.slots();
        for (JointRow& row : joint.rows()) {
            if (row.exact() || row.mass == 0) {
                continue;
            }
            ExactRow along;
            along.count = row.count;
            for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
                SlotIndex const body = slots[static_cast<std::size_t>(row.terms[i].body)];
                along.terms[i] = {body != noSlot && engine_.moves(body) ? body : noSlot, row.terms[i].linear,
                                  row.terms[i].angular};
            }
            give(along, row.solve(rateOf(along)), 1);
        }
    }
}

// --- the two halves
// ---------------------------------------------------------------------------------------------

// By how much of an impulse's velocity bodies move. Returns whether it has changed.
bool IslandSolver::findWeights() {
    for (SlotIndex const slot : island_.bodies) {
        stateOf(slot).borne = Borne::not_at_all;
    }
    findBearing();
    bool changed = false;
    for (SlotIndex const slot : island_.bodies) {
        double const follows =
            engine_.bodies_[slot].joints > 0 && stateOf(slot).borne == Borne::not_at_all ? 0.5 : 1;
        changed = changed || engine_.follows_[slot] != follows;
        engine_.follows_[slot] = follows;
    }
    return changed;
}

// Impulses that bring the places at the substep's end onto the constraints.
void IslandSolver::closeGaps(double h, int rounds) {
    std::vector<ExactRow>& rows = engine_.exact_.rows();
    std::vector<double>& right = engine_.right_;
    right.resize(rows.size());
    bool const alone = rows_.empty();
    bool stale = true;
    bool possible = !rows.empty();
    for (int round = 0; round < mostRounds; ++round) {
        bool const others = round < rounds;
        if (others) {
            solveBounded();
            solveContacts(h, true);
        }
        if ((round == 0 || !alone) && findWeights()) {
            stale = true;
        }
        if (!possible) {
            if (!others) {
                break;
            }
            continue;
        }
        prepareJoints(h, true);
        std::size_t next = 0;
        double worst = 0;
        for (SlotIndex const slot : island_.joints) {
            for (JointRow const& row : engine_.joints_[slot].rows->rows()) {
                if (row.exact() && row.stiff != 0) {
                    rows[next++].error = row.error;
                }
            }
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            ExactRow& row = rows[i];
            if (row.oneSided) {
                bool const active = row.error < 0 || row.impulse > 0;
                stale = stale || active != row.active;
                row.active = active;
            }
            if (row.active) {
                worst = std::max(worst, std::abs(row.error));
                right[i] = std::clamp(-row.error / h, -fastestClosing, fastestClosing);
            }
        }
        if (worst <= closed && !others) {
            break;
        }
        if (stale && !engine_.exact_.factorise(engine_.states_, engine_.follows_)) {
            possible = false;
            continue;
        }
        stale = false;
        std::span<double const> const found = engine_.exact_.solve(right);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            ExactRow& row = rows[i];
            double more = found[i];
            if (row.oneSided && row.impulse + more < 0) {
                more = -row.impulse;
                row.active = false;
                stale = true;
            }
            row.impulse += more;
            give(row, more, 1);
        }
    }
}

// Impulses after which the velocities keep the constraints.
void IslandSolver::stopRates(double h, int rounds) {
    std::vector<ExactRow>& rows = engine_.exact_.rows();
    std::vector<double>& right = engine_.right_;
    right.resize(rows.size());
    std::fill(engine_.follows_.begin(), engine_.follows_.end(), 1.0);
    bool stale = true;
    bool possible = !rows.empty();
    for (int round = 0; round <= rounds; ++round) {
        if (round < rounds) {
            solveBounded();
            solveContacts(h, false);
        }
        if (!possible) {
            continue;
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            ExactRow& row = rows[i];
            double const rate = rateOf(row);
            if (row.oneSided) {
                bool const active = row.impulse > 0 || (row.error <= closed && rate < 0);
                stale = stale || active != row.active;
                row.active = active;
            }
            right[i] = -rate;
        }
        if (stale && !engine_.exact_.factorise(engine_.states_, engine_.follows_)) {
            possible = false;
            continue;
        }
        stale = false;
        std::span<double const> const found = engine_.exact_.solve(right);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            ExactRow& row = rows[i];
            double more = found[i];
            if (row.oneSided && row.impulse + more < 0) {
                more = -row.impulse;
                row.active = false;
                stale = true;
            }
            row.impulse += more;
            give(row, more, 1);
        }
    }
}

void IslandSolver::joinedSubstep(double h) {
    std::size_t const slots = engine_.bodies_.size();
    engine_.follows_.assign(slots, 1.0);
    engine_.springLoads_.resize(slots);
    engine_.springLoadsNow_.resize(slots);
    prepareJoints(h, false);
    springLoads(engine_.springLoads_);
    for (SlotIndex const slot : island_.bodies) {
        MovingState& state = stateOf(slot);
        Load const& load = engine_.springLoads_[slot];
        state.velocity += h * state.inverseMass * load.force;
        state.spin += h * state.inverseInertia * load.torque;
    }
    takeExactRows(true);
    // What acted in the last substep is the first guess.
    double stretch = 1;
    std::size_t next = 0;
    std::vector<ExactRow>& rows = engine_.exact_.rows();
    for (SlotIndex const slot : island_.joints) {
        JointEntry& joint = engine_.joints_[slot];
        stretch = joint.last > 0 ? h / joint.last : 1;
        joint.last = h;
        for (JointRow& row : joint.rows->rows()) {
            row.impulse = std::clamp(stretch * row.impulse, row.low, row.high);
            if (row.exact() && row.stiff != 0) {
                ExactRow& exact = rows[next++];
                exact.impulse = row.impulse;
                exact.active = !exact.oneSided || exact.impulse > 0;
                give(exact, exact.impulse, 1);
            } else if (row.mass != 0) {
                ExactRow along;
                along.count = row.count;
                std::span<SlotIndex const> const bodies = joint.rows->slots();
                for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
                    SlotIndex const body = bodies[static_cast<std::size_t>(row.terms[i].body)];
                    along.terms[i] = {body != noSlot && engine_.moves(body) ? body : noSlot,
                                      row.terms[i].linear, row.terms[i].angular};
                }
                give(along, row.impulse, 1);
            }
        }
    }
    startRows(h);
    int const rounds = island_.bodies.size() > few ? 1 : roundsWithContacts;
    closeGaps(h, rounds);
    move(h);
    // The half of the impulses that acts along the new directions is found anew.
    for (ExactRow& row : rows) {
        bool free = true;
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
            free = free && (row.terms[i].slot == noSlot || engine_.follows_[row.terms[i].slot] < 1);
        }
        if (free) {
            give(row, row.impulse, -0.5);
            row.impulse *= 0.5;
        }
    }
    prepareJoints(h, false);
    springLoads(engine_.springLoadsNow_);
    for (SlotIndex const slot : island_.bodies) {
        MovingState& state = stateOf(slot);
        Load const& before = engine_.springLoads_[slot];
        Load const& now = engine_.springLoadsNow_[slot];
        state.velocity += h / 2 * state.inverseMass * (now.force - before.force);
        state.spin += h / 2 * state.inverseInertia * (now.torque - before.torque);
    }
    takeExactRows(false);
    stopRates(h, rounds);
    next = 0;
    for (SlotIndex const slot : island_.joints) {
        for (JointRow& row : engine_.joints_[slot].rows->rows()) {
            if (row.exact() && row.stiff != 0) {
                row.impulse = rows[next++].impulse;
            }
        }
    }
}

} // namespace trembler::native
