// Impacts of the same moment and the same speed, as of a ball that falls into a notch: computed one after the
// other, they would depend on their order, and throw the ball aside. So all of them are met at once: every
// point leaves with at least the share of its speed that restitution gives back (Newton's law of impacts),
// and an impulse acts only where no other one makes it leave faster.
#include "physics/dynamics/engines/native/island_solver.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::native {
namespace {

// Speeds that differ by less than this share are the same.
constexpr double sameSpeed = 1e-9;
constexpr int mostTurns = 200;
constexpr double exactTies = 1e-12; // of the speed of the impacts

struct TiedPoint {
    ContactRow* row;
    PointRow* point;
    double leaves = 0; // m/s
    double normal = 0; // N s
    double across = 0; // N s
};

} // namespace

double IslandSolver::slipOf(ContactRow const& row, PointRow const& point) const {
    MovingState const& a = stateOf(row.a);
    MovingState const& b = stateOf(row.b);
    return dot(perpendicular(row.normal), b.velocity - a.velocity) + b.spin * point.acrossB -
           a.spin * point.acrossA;
}

bool IslandSolver::strikeTogether(std::span<ContactRow* const> near, double fastest) {
    std::vector<TiedPoint> meetings;
    std::size_t rows = 0;
    for (ContactRow* const row : near) {
        bool tied = false;
        for (std::size_t n = 0; n < static_cast<std::size_t>(row->count); ++n) {
            tied = tied || -normalSpeed(*row, row->points[n]) >= (1 - sameSpeed) * fastest;
        }
        if (!tied) {
            continue;
        }
        ++rows;
        for (std::size_t n = 0; n < static_cast<std::size_t>(row->count); ++n) {
            double const speed = normalSpeed(*row, row->points[n]);
            double const leaves = speed < 0 ? -row->detail->restitution * speed : 0;
            meetings.push_back({row, &row->points[n], leaves});
        }
    }
    if (rows < 2) {
        return false;
    }
    double const had = kineticEnergyNow();
    // By turns, until none changes; the order decides only about the rounding.
    for (int round = 0; round < mostTurns; ++round) {
        double change = 0;
        for (TiedPoint& meeting : meetings) {
            double const wanted = meeting.leaves - normalSpeed(*meeting.row, *meeting.point);
            double const more = std::max(wanted / meeting.point->normalInverse, -meeting.normal);
            meeting.normal += more;
            push(*meeting.row, *meeting.point, more, 0);
            change = std::max(change, std::abs(more) * meeting.point->normalInverse);
        }
        if (change <= exactTies * fastest) {
            break;
        }
    }
    for (int round = 0; round < mostTurns; ++round) {
        double change = 0;
        for (TiedPoint& meeting : meetings) {
            double const most = meeting.row->friction * meeting.normal;
            double const wanted = -meeting.point->tangentMass * slipOf(*meeting.row, *meeting.point);
            double const more = std::clamp(meeting.across + wanted, -most, most) - meeting.across;
            meeting.across += more;
            push(*meeting.row, *meeting.point, 0, more);
            change = std::max(change, std::abs(more) / meeting.point->tangentMass);
        }
        if (change <= exactTies * fastest) {
            break;
        }
    }
    for (TiedPoint const& meeting : meetings) {
        meeting.row->detail->struck += meeting.normal;
        meeting.row->detail->contact->pressed = true;
    }
    // Where restitutions differ the law may give more energy than there was.
    takeGainAway(kineticEnergyNow() / ((1 + 1e-9) * had));
    return true;
}

} // namespace trembler::native
