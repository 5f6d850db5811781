// Impacts of bodies that joints hold: the impulses of rigid joints, and of limits and ropes that are taut,
// act at the same moment as those of the contacts.
#include "physics/dynamics/engines/native/island_solver.hpp"

#include <algorithm>

namespace trembler::native {
namespace {

// A limit or a rope that is as near to its end (m or rad) acts at an impact.
constexpr double taut = 1e-7;

} // namespace

void IslandSolver::beginJointedImpacts() {
    jointsStrike_ = false;
    if (island_.joints.empty()) {
        return;
    }
    bool const contacts = exactContacts_;
    exactContacts_ = false;
    prepareJoints(h_, false);
    takeExactRows(true);
    exactContacts_ = contacts;
    std::vector<ExactRow>& rows = engine_.exact_.rows();
    for (ExactRow& row : rows) {
        row.active = !row.oneSided || row.error <= taut;
        row.impulse = 0;
    }
    engine_.follows_.assign(engine_.bodies_.size(), 1.0);
    engine_.right_.resize(rows.size());
    jointsStrike_ = !rows.empty() && engine_.exact_.factorise(engine_.states_, engine_.follows_);
    if (jointsStrike_) {
        followImpact();
    }
}

void IslandSolver::followImpact() {
    std::vector<ExactRow>& rows = engine_.exact_.rows();
    std::vector<double>& right = engine_.right_;
    bool stale = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        right[i] = -rateOf(rows[i]);
        if (rows[i].oneSided && rows[i].error <= taut && !rows[i].active) {
            rows[i].active = stale = true;
        }
    }
    // A rope that would have to push lets go, one set of them after the other.
    for (;;) {
        if (stale && !engine_.exact_.factorise(engine_.states_, engine_.follows_)) {
            jointsStrike_ = false;
            return;
        }
        stale = false;
        std::span<double const> const found = engine_.exact_.solve(right);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].oneSided && rows[i].active && found[i] < 0) {
                rows[i].active = false;
                stale = true;
            }
        }
        if (stale) {
            continue;
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            rows[i].impulse += found[i];
            give(rows[i], found[i], 1);
        }
        return;
    }
}

std::array<double, 2> IslandSolver::speedsAfter(ContactRow const& row, std::size_t point, double impulse) {
    std::vector<ExactRow>& rows = engine_.exact_.rows();
    memory_.resize(island_.bodies.size());
    for (std::size_t i = 0; i < memory_.size(); ++i) {
        memory_[i].state = stateOf(island_.bodies[i]);
    }
    jointImpulses_.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        jointImpulses_[i] = rows[i].impulse;
    }
    push(row, row.points[point], impulse, 0);
    followImpact();
    std::array<double, 2> speeds{};
    for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
        speeds[n] = normalSpeed(row, row.points[n]);
    }
    for (std::size_t i = 0; i < memory_.size(); ++i) {
        stateOf(island_.bodies[i]) = memory_[i].state;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].impulse = jointImpulses_[i];
    }
    return speeds;
}

void IslandSolver::endJointedImpacts() {
    std::vector<ExactRow> const& rows = engine_.exact_.rows();
    std::size_t next = 0;
    for (SlotIndex const slot : island_.joints) {
        JointEntry& joint = engine_.joints_[slot];
        std::array<double, 5> const kept = joint.rows->impulses();
        for (JointRow& row : joint.rows->rows()) {
            row.impulse = row.exact() && row.stiff != 0 ? rows[next++].impulse : 0;
        }
        joint.force += joint.rows->impulseOnA(0) / engine_.duration_;
        joint.rows->setImpulses(kept);
    }
}

} // namespace trembler::native
