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

/// Takes all points by turns until none changes: `improve` returns by how much a point's speed changed, m/s.
/// The order decides only about the rounding.
template <class Improve>
void byTurns(std::vector<TiedPoint>& points, double enough, Improve const& improve) {
    for (int turn = 0; turn < mostTurns; ++turn) {
        double change = 0;
        for (TiedPoint& tied : points) {
            change = std::max(change, improve(tied));
        }
        if (change <= enough) {
            return;
        }
    }
}

} // namespace

bool IslandSolver::strikeTogether(std::span<ContactRow* const> near, double fastest) {
    auto const isTied = [&](ContactRow const* row) {
        auto const end = row->points.begin() + row->count;
        return std::any_of(row->points.begin(), end, [&](PointRow const& point) {
            return -normalSpeed(*row, point) >= (1 - sameSpeed) * fastest;
        });
    };
    if (std::count_if(near.begin(), near.end(), isTied) < 2) {
        return false;
    }
    std::vector<TiedPoint> points;
    for (ContactRow* const row : near) {
        if (!isTied(row)) {
            continue;
        }
        for (std::size_t n = 0; n < static_cast<std::size_t>(row->count); ++n) {
            double const speed = normalSpeed(*row, row->points[n]);
            double const leaves = speed < 0 ? -row->detail->restitution * speed : 0;
            points.push_back({row, &row->points[n], leaves});
        }
    }
    double const had = kineticEnergyNow();
    double const enough = exactTies * fastest;
    byTurns(points, enough, [&](TiedPoint& tied) {
        double const wanted = tied.leaves - normalSpeed(*tied.row, *tied.point);
        double const more = std::max(wanted / tied.point->normalInverse, -tied.normal);
        tied.normal += more;
        push(*tied.row, *tied.point, more, 0);
        return std::abs(more) * tied.point->normalInverse;
    });
    byTurns(points, enough, [&](TiedPoint& tied) {
        double const most = tied.row->friction * tied.normal;
        double const wanted = -tied.point->tangentMass * slipOf(*tied.row, *tied.point);
        double const more = std::clamp(tied.across + wanted, -most, most) - tied.across;
        tied.across += more;
        push(*tied.row, *tied.point, 0, more);
        return std::abs(more) / tied.point->tangentMass;
    });
    for (TiedPoint const& tied : points) {
        tied.row->detail->struck += tied.normal;
        tied.row->detail->contact->pressed = true;
    }
    // Where restitutions differ the law may give more energy than there was.
    takeGainAway(kineticEnergyNow() / ((1 + 1e-9) * had));
    return true;
}

} // namespace trembler::native
