// A substep of an island with joints.
//
// Rigid joints, and limits and ropes that hold, are solved exactly and at once, by the method RATTLE (H. C.
// Andersen 1983): their impulses bring the places at the substep's end onto the constraints, half of them
// acts before and half, along the new directions, after. It is symplectic, so that what swings keeps its
// energy. Contacts, motors and damped springs are solved one after the other, in turn with the exact ones.
#include "physics/dynamics/engines/impact_budget.hpp"
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
// A substep after which they are off by more than this, m or rad, is too long.
constexpr double nearlyClosed = 1e-7;
constexpr double nearlyMet = 1e-4; // contacts, m
// A substep after which the bodies have this share of energy more than the work done on them is one whose
// equations contradict each other.
constexpr double mostGain = 0.05;
constexpr double leastGain = 5e-3; // J for each kg, as overlaps that are closed give
// An error is removed no faster than this, m/s or rad/s.
constexpr double fastestClosing = 10;
// Contacts are linear in the turn of a substep (rad). Where a contact's normal passes near an axle, closing a
// small gap along it would turn a wheel by any angle.
constexpr double widestLeap = 0.05;
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
    if (!exactContacts_) {
        return;
    }
    for (ContactRow const& row : rows_) {
        for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
            PointRow const& point = row.points[n];
            ExactRow& made = anew ? exact.emplace_back() : exact[next++];
            made.contact = made.oneSided = true;
            made.count = 2;
            made.terms[0] = {engine_.moves(row.a) ? row.a : noSlot, -row.normal, -point.normalA};
            made.terms[1] = {engine_.moves(row.b) ? row.b : noSlot, row.normal, point.normalB};
            made.error = point.now;
        }
    }
}

// What is left, after `h` (s), of the gaps of contacts that must not close.
void IslandSolver::findContactErrors(double h, std::size_t first) {
    std::vector<ExactRow>& exact = engine_.exact_.rows();
    double const bias = softness(h).bias;
    for (ContactRow const& row : rows_) {
        for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
            ExactRow& made = exact[first++];
            double rate = 0;
            for (std::size_t i = 0; i < 2; ++i) {
                if (ExactTerm const& term = made.terms[i]; term.slot != noSlot) {
                    Drift const drift = driftOf(term.slot);
                    rate += dot(term.linear, drift.velocity) + term.angular * drift.spin;
                }
            }
            double const now = row.points[n].now;
            double const allowed = now < 0 ? now + h * std::min(-bias * now, fastestParting) : 0;
            made.error = row.awaits ? 1 : now + h * rate - allowed;
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

// Friction is limited by the present normal impulses.
void IslandSolver::noteNormals() {
    if (!exactContacts_) {
        return;
    }
    std::vector<ExactRow> const& exact = engine_.exact_.rows();
    std::size_t at = exact.size();
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
        for (int n = row->count; n-- > 0;) {
            row->points[static_cast<std::size_t>(n)].normal = exact[--at].impulse;
        }
    }
}

// Impulses that bring the places at the substep's end onto the constraints.
bool IslandSolver::closeGaps(double h, int rounds) {
    std::vector<ExactRow>& rows = engine_.exact_.rows();
    std::vector<double>& right = engine_.right_;
    right.resize(rows.size());
    bool const alone = rows_.empty();
    bool stale = true;
    bool const possible = !rows.empty();
    double misfit = 0;  // of joints
    double deepest = 0; // of contacts
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
        misfit = 0;
        for (SlotIndex const slot : island_.joints) {
            for (JointRow const& row : engine_.joints_[slot].rows->rows()) {
                if (row.exact() && row.stiff != 0) {
                    rows[next].error = row.error;
                    misfit = std::max(misfit, row.limit() ? -row.error : std::abs(row.error));
                    ++next;
                }
            }
        }
        deepest = 0;
        if (exactContacts_) {
            findContactErrors(h, next);
            for (; next < rows.size(); ++next) {
                deepest = std::max(deepest, -rows[next].error);
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
            relaxes_ = true;
            return false;
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
        noteNormals();
    }
    misfit_ = misfit;
    return misfit <= nearlyClosed && (!exactContacts_ || deepest <= nearlyMet);
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
        noteNormals();
    }
}

void IslandSolver::remember() {
    memory_.resize(island_.bodies.size());
    for (std::size_t i = 0; i < memory_.size(); ++i) {
        SlotIndex const slot = island_.bodies[i];
        BodyEntry const& entry = engine_.bodies_[slot];
        memory_[i] = {entry.centre, entry.angle, stateOf(slot),
                      slot < engine_.dragged_.size() ? engine_.dragged_[slot] : DraggedBody{}};
    }
    jointMemory_.resize(island_.joints.size());
    for (std::size_t i = 0; i < jointMemory_.size(); ++i) {
        JointEntry const& joint = engine_.joints_[island_.joints[i]];
        jointMemory_[i] = {joint.last, joint.rows->impulses()};
    }
}

void IslandSolver::restore() {
    for (std::size_t i = 0; i < memory_.size(); ++i) {
        SlotIndex const slot = island_.bodies[i];
        BodyEntry& entry = engine_.bodies_[slot];
        entry.centre = memory_[i].centre;
        entry.angle = memory_[i].angle;
        stateOf(slot) = memory_[i].state;
        if (slot < engine_.dragged_.size()) {
            engine_.dragged_[slot] = memory_[i].dragged;
        }
    }
    for (std::size_t i = 0; i < jointMemory_.size(); ++i) {
        JointEntry& joint = engine_.joints_[island_.joints[i]];
        joint.last = jointMemory_[i].last;
        joint.rows->setImpulses(jointMemory_[i].impulses);
    }
}

void IslandSolver::beginJoints(double h) {
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
    startRows(h);
    takeExactRows(true);
    engine_.springLoadsNow_ = engine_.springLoads_;
    // What acted in the last substep is the first guess, unless rows say the same: how they share the load
    // would drift from substep to substep, and act as a force once the bodies have turned.
    bool const fresh = engine_.exact_.wereRedundant();
    double stretch = 1;
    std::size_t next = 0;
    std::vector<ExactRow>& rows = engine_.exact_.rows();
    if (exactContacts_) {
        std::size_t at = rows.size();
        for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
            for (int n = row->count; n-- > 0;) {
                ExactRow& exact = rows[--at];
                exact.impulse = row->points[static_cast<std::size_t>(n)].normal;
                exact.active = exact.impulse > 0;
            }
        }
    }
    for (SlotIndex const slot : island_.joints) {
        JointEntry& joint = engine_.joints_[slot];
        stretch = joint.last > 0 ? h / joint.last : 1;
        joint.last = h;
        for (JointRow& row : joint.rows->rows()) {
            row.impulse = std::clamp(stretch * row.impulse, row.low, row.high);
            if (row.exact() && row.stiff != 0) {
                ExactRow& exact = rows[next++];
                exact.impulse = fresh ? 0 : row.impulse;
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
}

// Impulses that the next substep begins with.
void IslandSolver::keepImpulses() {
    std::vector<ExactRow> const& rows = engine_.exact_.rows();
    std::size_t next = 0;
    for (SlotIndex const slot : island_.joints) {
        for (JointRow& row : engine_.joints_[slot].rows->rows()) {
            if (row.exact() && row.stiff != 0) {
                row.impulse = rows[next++].impulse;
            }
        }
    }
}

bool IslandSolver::leaps(double h) const {
    return std::any_of(island_.bodies.begin(), island_.bodies.end(), [&](SlotIndex slot) {
        MovingState const& state = stateOf(slot);
        return h * (std::abs(state.spin) - std::abs(state.spinBefore)) > widestLeap;
    });
}

bool IslandSolver::joinedSubstep(double h) {
    beginJoints(h);
    std::vector<ExactRow>& rows = engine_.exact_.rows();
    int const rounds = island_.bodies.size() > few ? 1 : roundsWithContacts;
    bool const good = closeGaps(h, rounds);
    if (relaxes_ || (exactContacts_ && leaps(h))) {
        return false;
    }
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
    keepImpulses();
    return good && gainOf(h) <= 1;
}

double IslandSolver::gainOf(double h) const {
    double before = 0;
    double after = 0;
    double work = 0;
    double mass = 0;
    for (SlotIndex const slot : island_.bodies) {
        BodyEntry const& entry = engine_.bodies_[slot];
        MovingState const& state = stateOf(slot);
        before += kineticEnergy(entry.mass, entry.inertia, state.velocityBefore, state.spinBefore);
        after += kineticEnergy(entry.mass, entry.inertia, state.velocity, state.spin);
        // The mean of the velocities is about that with which it has moved.
        Load const& sprung = engine_.springLoads_[slot];
        Load const& now = engine_.springLoadsNow_[slot];
        Vec2 const force = entry.load.force + 0.5 * (sprung.force + now.force);
        double const torque = entry.load.torque + 0.5 * (sprung.torque + now.torque);
        work +=
            h / 2 *
            (dot(force, state.velocityBefore + state.velocity) + torque * (state.spinBefore + state.spin));
        mass += entry.mass;
    }
    for (SlotIndex const slot : island_.joints) {
        JointRows& joint = *engine_.joints_[slot].rows;
        for (JointRow const& row : joint.rows()) {
            if (!row.exact() && row.mass != 0) {
                work += std::abs(row.impulse) * std::abs(row.speed);
            }
        }
    }
    double const allowed = before + std::max(work, 0.0) + mostGain * before + leastGain * mass;
    return after / allowed;
}

} // namespace trembler::native
