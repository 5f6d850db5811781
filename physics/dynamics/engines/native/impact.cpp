// Impacts with restitution, at the times at which they occur.
//
// Bodies that are about to meet are moved until they do, and then bounce. So the height to which a ball rises
// does not depend on the substeps. Impacts that occur at the same time, as in Newton's cradle, are computed
// one after the other, the fastest first, each as that of two bodies, until no two approach each other (the
// "sequential" law of impacts); those of the same speed are computed together (tied_impact.cpp).
#include "physics/dynamics/engines/native/island_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::native {
namespace {

// Surfaces this close (m) meet.
constexpr double meetingGap = 1e-6;
// Bodies that rest on each other approach by the speed that their loads give them in a substep; this multiple
// of it is an impact, and less is none: so a bouncing body comes to rest.
constexpr double gainsOfImpact = 2;
constexpr double faintest = 1e-9; // m/s
// Bodies that pass each other by this share of the smaller one's extent meet along another normal than that
// with which they began.
constexpr double steadyNormal = 1e-4;
// What joints hold as good as fixed yields at least by this share of what it would yield without them.
constexpr double leastYield = 1e-4;
// Impacts of one moment, for each contact of the island.
constexpr std::size_t mostStrikes = 40;

} // namespace

double IslandSolver::approachLimit(ContactRow const& row, double h) const {
    double gain = 0;
    for (SlotIndex const slot : {row.a, row.b}) {
        MovingState const& state = stateOf(slot);
        BodyEntry const& entry = engine_.bodies_[slot];
        gain += length(entry.load.force) * state.inverseMass +
                std::abs(entry.load.torque) * state.inverseInertia * entry.extent;
    }
    return std::max(faintest, gainsOfImpact * h * gain);
}

IslandSolver::Hit IslandSolver::firstHit(double time) {
    Hit hit;
    for (ContactRow& row : rows_) {
        row.awaits = false;
        if (!row.bounces) {
            continue;
        }
        double const limit = approachLimit(row, h_);
        BodyEntry const& a = engine_.bodies_[row.a];
        BodyEntry const& b = engine_.bodies_[row.b];
        double const gain = dot(row.normal, stateOf(row.b).inverseMass * b.load.force -
                                                stateOf(row.a).inverseMass * a.load.force);
        for (int n = 0; n < row.count; ++n) {
            double const gap = gapOf(row, static_cast<std::size_t>(n));
            double const speed = normalSpeed(row, row.points[static_cast<std::size_t>(n)]);
            // gap + speed t + gain t²/2 = 0, the first t.
            double after = 0;
            double meeting = speed;
            if (gap > meetingGap) {
                double const root = speed * speed - 2 * gain * gap;
                if (root < 0 || (speed >= 0 && gain >= 0)) {
                    continue;
                }
                after = 2 * gap / (-speed + std::sqrt(root));
                meeting = speed + gain * after;
            }
            if (after >= 0 && after <= time && meeting < -limit) {
                row.awaits = true;
                hit.after = hit.any ? std::min(hit.after, after) : after;
                hit.any = true;
            }
        }
    }
    return hit;
}

bool IslandSolver::hitsAside(double after) const {
    return std::any_of(rows_.begin(), rows_.end(), [&](ContactRow const& row) {
        if (!row.awaits) {
            return false;
        }
        BodyEntry const& a = engine_.bodies_[row.a];
        BodyEntry const& b = engine_.bodies_[row.b];
        Vec2 const way = after * (stateOf(row.b).velocity - stateOf(row.a).velocity);
        double const size = std::min(a.fixed ? b.extent : a.extent, b.fixed ? a.extent : b.extent);
        return std::abs(cross(row.normal, way)) > steadyNormal * size;
    });
}

double IslandSolver::kineticEnergyNow() const {
    double sum = 0;
    for (SlotIndex const slot : island_.bodies) {
        BodyEntry const& entry = engine_.bodies_[slot];
        sum += kineticEnergy(entry.mass, entry.inertia, stateOf(slot).velocity, stateOf(slot).spin);
    }
    return sum;
}

bool IslandSolver::strike(ContactRow& row, double slowest) {
    std::array<double, 2> speed{};
    bool approaches = false;
    for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
        speed[n] = normalSpeed(row, row.points[n]);
        approaches = approaches || speed[n] < -slowest;
    }
    if (!approaches) {
        return false;
    }
    std::array<double, 2> impulse{};
    bool const jointed =
        jointsStrike_ && (engine_.bodies_[row.a].joints > 0 || engine_.bodies_[row.b].joints > 0);
    // By how much an impulse at a point changes the speed there and at the other point, 1/kg.
    std::array<double, 2> own{row.points[0].normalInverse, row.points[1].normalInverse};
    double shared = row.coupling;
    if (jointed) {
        for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
            double const trial = std::max(std::abs(speed[n]), slowest) / row.points[n].normalInverse;
            std::array<double, 2> const after = speedsAfter(row, n, trial);
            own[n] = std::max((after[n] - speed[n]) / trial, leastYield * row.points[n].normalInverse);
            shared = (after[1 - n] - speed[1 - n]) / trial;
        }
    }
    bool solved = false;
    if (row.count == 2 && speed[0] < 0 && speed[1] < 0) {
        // Both points at once: K (j0, j1) = -(1 + e) speed.
        double const k00 = own[0];
        double const k11 = own[1];
        double const k01 = shared;
        double const determinant = k00 * k11 - k01 * k01;
        if (determinant > 1e-9 * k00 * k11) {
            double const r0 = -(1 + row.detail->restitution) * speed[0];
            double const r1 = -(1 + row.detail->restitution) * speed[1];
            impulse = {(k11 * r0 - k01 * r1) / determinant, (k00 * r1 - k01 * r0) / determinant};
            solved = impulse[0] >= 0 && impulse[1] >= 0;
        }
    }
    if (!solved) {
        std::size_t const n = row.count == 2 && speed[1] < speed[0] ? 1 : 0;
        impulse = {};
        impulse[n] = -(1 + row.detail->restitution) * speed[n] / own[n];
    }
    for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
        push(row, row.points[n], impulse[n], 0);
    }
    if (jointed) {
        followImpact(); // friction acts against the slip that joints leave
    }
    for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
        PointRow const& point = row.points[n];
        double const most = row.friction * impulse[n];
        if (most > 0) {
            push(row, point, 0, std::clamp(-point.tangentMass * slipOf(row, point), -most, most));
        }
    }
    if (jointed) {
        followImpact();
    }
    row.detail->struck += impulse[0] + impulse[1];
    row.detail->contact->pressed = true;
    return true;
}

void IslandSolver::bounce(double ahead) {
    // Everything that touches now takes part, also what does not bounce.
    std::vector<ContactRow*> near;
    double fastest = 0;
    for (ContactRow& row : rows_) {
        row.detail->struck = 0;
        bool touches = row.awaits && ahead > 0;
        for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
            double const speed = normalSpeed(row, row.points[n]);
            double const gap = gapOf(row, n);
            touches = touches || gap <= meetingGap + 1e-9 * std::abs(speed);
            if (touches) {
                fastest = std::max(fastest, -speed);
            }
        }
        row.awaits = false;
        if (touches) {
            near.push_back(&row);
        }
    }
    double const least = 1e-4 * fastest;
    jointsStrike_ = false;
    double had = 0;
    if (fastest > 0) {
        beginJointedImpacts();
        had = jointsStrike_ ? kineticEnergyNow() : 0;
    }
    for (std::size_t strikes = mostStrikes * near.size(); strikes > 0; --strikes) {
        ContactRow* next = nullptr;
        double most = 0;
        for (ContactRow* const row : near) {
            double const slowest = std::max(least, row->bounces ? approachLimit(*row, h_) : 0);
            for (std::size_t n = 0; n < static_cast<std::size_t>(row->count); ++n) {
                double const speed = -normalSpeed(*row, row->points[n]);
                if (speed > slowest && speed > most) {
                    most = speed;
                    next = row;
                }
            }
        }
        if (next == nullptr) {
            break;
        }
        if (!jointsStrike_ && strikeTogether(near, most)) {
            continue;
        }
        if (!strike(*next, least)) {
            break;
        }
    }
    if (jointsStrike_) {
        endJointedImpacts();
        // No impact gives energy; rounding in nearly singular equations might.
        takeGainAway(kineticEnergyNow() / ((1 + 1e-6) * had));
    }
    for (ContactRow* const row : near) {
        // Joints may make bodies strike with more than their own mass, but what sounds is no more than there
        // was.
        double const yields = stateOf(row->a).inverseMass + stateOf(row->b).inverseMass;
        double const most = jointsStrike_ ? std::sqrt(8 * had / yields) : row->detail->struck;
        if (auto const impact = impactOf(*row, std::min(row->detail->struck, most))) {
            engine_.impacts_.push_back(*impact);
        }
    }
}

} // namespace trembler::native
