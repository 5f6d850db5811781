// Potentials and currents between conductances, against dense elimination in long double and against
// formulas.
#include "physics/electricity/analyses/conductance_solver.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler {
namespace conductance_solver_test {
namespace {

using Edge = ConductanceSolver::Edge;
using Potential = ConductanceSolver::Potential;

struct Problem {
    std::vector<Edge> edges;
    std::vector<std::uint8_t> fixed;
    std::vector<double> siemens;
    std::vector<double> emfs;
    std::vector<double> injected;
    std::vector<double> given; ///< V, of the fixed nodes
};

struct Solution {
    std::vector<double> volts;
    std::vector<double> amperes;
};

Solution solutionOf(Problem const& problem, ConductanceSolver& solver) {
    solver.setStructure(problem.edges, problem.fixed);
    solver.setConductances(problem.siemens);
    std::vector<Potential> potentials;
    for (double const volt : problem.given) {
        potentials.push_back({volt, 0});
    }
    Solution found;
    solver.solve(problem.emfs, problem.injected, potentials, found.amperes);
    for (Potential const& potential : potentials) {
        found.volts.push_back(potential.high + potential.low);
    }
    return found;
}

Solution solutionOf(Problem const& problem) {
    ConductanceSolver solver;
    return solutionOf(problem, solver);
}

/// Gauss's elimination with the largest pivot of each column, on the whole matrix, fixed nodes included.
std::vector<long double> byElimination(Problem const& problem) {
    std::size_t const n = problem.fixed.size();
    std::vector<std::vector<long double>> rows(n, std::vector<long double>(n + 1, 0));
    for (std::size_t v = 0; v < n; ++v) {
        rows[v][n] = problem.injected.empty() ? 0 : problem.injected[v];
    }
    for (std::size_t e = 0; e < problem.edges.size(); ++e) {
        auto const [from, to] = problem.edges[e];
        long double const g = problem.siemens[e];
        long double const emf = problem.emfs.empty() ? 0 : problem.emfs[e];
        rows[from][from] += g;
        rows[from][to] -= g;
        rows[from][n] -= g * emf;
        rows[to][to] += g;
        rows[to][from] -= g;
        rows[to][n] += g * emf;
    }
    for (std::size_t v = 0; v < n; ++v) {
        if (problem.fixed[v] != 0) {
            std::fill(rows[v].begin(), rows[v].end(), 0.0L);
            rows[v][v] = 1;
            rows[v][n] = problem.given[v];
        }
    }
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column; row < n; ++row) {
            if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) {
                pivot = row;
            }
        }
        std::swap(rows[column], rows[pivot]);
        for (std::size_t row = 0; row < n; ++row) {
            long double const share = rows[row][column] / rows[column][column];
            for (std::size_t k = column; row != column && share != 0 && k <= n; ++k) {
                rows[row][k] -= share * rows[column][k];
            }
        }
    }
    std::vector<long double> volts;
    for (std::size_t v = 0; v < n; ++v) {
        volts.push_back(rows[v][n] / rows[v][v]);
    }
    return volts;
}

double anyBetween(double low, double high) {
    return low +
           (high - low) * *rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)),
                                        [](int i) { return i / 1e6; });
}

std::uint32_t below(std::uint32_t bound) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0U, bound));
}

Problem anyProblem(double orders) {
    Problem made;
    std::uint32_t const count = 2 + below(12);
    made.fixed.assign(count, 0);
    made.fixed[0] = 1;
    for (std::uint32_t v = 1; v < count; ++v) {
        made.fixed[v] = below(5) == 0 ? 1 : 0;
        made.edges.push_back({below(v), v});
    }
    for (std::uint32_t extra = below(2 * count); extra > 0; --extra) {
        std::uint32_t const to = 1 + below(count - 1);
        made.edges.push_back({to, below(to)}); // including parallel and reversed edges
    }
    for (std::size_t e = 0; e < made.edges.size(); ++e) {
        made.siemens.push_back(std::pow(10, anyBetween(-orders / 2, orders / 2)));
        made.emfs.push_back(below(3) == 0 ? anyBetween(-20, 20) : 0);
    }
    for (std::uint32_t v = 0; v < count; ++v) {
        made.injected.push_back(below(4) == 0 ? anyBetween(-2, 2) : 0);
        made.given.push_back(made.fixed[v] != 0 ? anyBetween(-10, 10) : 0);
    }
    return made;
}

TEST(ConductanceSolver, FindsThePotentialsOfDenseElimination) {
    EXPECT_TRUE(rc::check("dense elimination finds the same", [] {
        Problem const problem = anyProblem(4);
        Solution const found = solutionOf(problem);
        auto const expected = byElimination(problem);
        double scale = 1e-3;
        for (long double const volt : expected) {
            scale = std::max(scale, static_cast<double>(std::abs(volt)));
        }
        for (std::size_t v = 0; v < expected.size(); ++v) {
            RC_ASSERT(std::abs(found.volts[v] - static_cast<double>(expected[v])) <= 1e-11 * scale);
        }
        for (std::size_t e = 0; e < problem.edges.size(); ++e) {
            auto const [from, to] = problem.edges[e];
            auto const drop = static_cast<double>(expected[from] - expected[to]);
            double const current = problem.siemens[e] * (drop + problem.emfs[e]);
            RC_ASSERT(std::abs(found.amperes[e] - current) <= 1e-10 * problem.siemens[e] * (scale + 20));
        }
    }));
}

TEST(ConductanceSolver, CurrentIsConservedOverTwelveOrdersOfMagnitude) {
    EXPECT_TRUE(rc::check("Kirchhoff's first law, as a share of what passes", [] {
        Problem const problem = anyProblem(12);
        Solution const found = solutionOf(problem);
        std::vector<long double> balance(problem.injected.begin(), problem.injected.end());
        std::vector<long double> passing(balance.size(), 0);
        long double largest = 0;
        for (std::size_t e = 0; e < problem.edges.size(); ++e) {
            long double const i = found.amperes[e];
            RC_ASSERT(std::isfinite(found.amperes[e]));
            balance[problem.edges[e].from] -= i;
            balance[problem.edges[e].to] += i;
            passing[problem.edges[e].from] += std::abs(i);
            passing[problem.edges[e].to] += std::abs(i);
            largest = std::max(largest, std::abs(i));
        }
        for (std::size_t v = 0; v < balance.size(); ++v) {
            if (problem.fixed[v] == 0) {
                RC_ASSERT(std::abs(balance[v]) <= 1e-9L * std::max(passing[v], 1e-8L * largest));
            }
        }
    }));
}

// The effect of a source at one place on another equals the effect with the places exchanged.
TEST(ConductanceSolver, IsReciprocal) {
    EXPECT_TRUE(rc::check("Lorentz's reciprocity", [] {
        Problem problem = anyProblem(3);
        std::fill(problem.emfs.begin(), problem.emfs.end(), 0.0);
        std::fill(problem.given.begin(), problem.given.end(), 0.0);
        auto const count = static_cast<std::uint32_t>(problem.fixed.size());
        std::uint32_t const a = below(count);
        std::uint32_t const b = below(count);
        auto const voltAtFrom = [&](std::uint32_t at, std::uint32_t from) {
            std::fill(problem.injected.begin(), problem.injected.end(), 0.0);
            problem.injected[from] = 1;
            return solutionOf(problem).volts[at];
        };
        double const one = voltAtFrom(a, b);
        double const other = voltAtFrom(b, a);
        RC_ASSERT(std::abs(one - other) <= 1e-10 * (std::abs(one) + std::abs(other) + 1));
        RC_ASSERT(one >= -1e-10); // current that flows in raises every potential
    }));
}

TEST(ConductanceSolver, FollowsOhmsLawInSmallCircuits) {
    // Node 0 is at 0 V, 1 at 10 V; 2 is between them, 3 is a dead end at 2, and current flows into 4.
    Problem problem;
    problem.edges = {{1, 2}, {2, 0}, {2, 0}, {2, 3}, {4, 0}};
    problem.fixed = {1, 1, 0, 0, 0};
    problem.siemens = {0.5, 0.25, 0.25, 7, 0.1};
    problem.emfs = {0, 0, 0, 3, 0};
    problem.injected = {0, 0, 0, 0, 2};
    problem.given = {0, 10, 0, 0, 0};
    Solution const found = solutionOf(problem);
    EXPECT_DOUBLE_EQ(found.volts[0], 0);
    EXPECT_DOUBLE_EQ(found.volts[1], 10);
    EXPECT_NEAR(found.volts[2], 5, 1e-15);
    EXPECT_NEAR(found.volts[3], 8, 1e-15) << "an EMF raises the potential from `from` to `to`";
    EXPECT_NEAR(found.volts[4], 20, 1e-14);
    EXPECT_NEAR(found.amperes[0], 2.5, 1e-15);
    EXPECT_NEAR(found.amperes[1], 1.25, 1e-15);
    EXPECT_NEAR(found.amperes[3], 0, 1e-14) << "no current in a dead end";
    EXPECT_NEAR(found.amperes[4], 2, 1e-14);
}

TEST(ConductanceSolver, WithEveryPotentialGivenOnlyTheCurrentsAreFound) {
    Problem problem;
    problem.edges = {{0, 1}};
    problem.fixed = {1, 1};
    problem.siemens = {2};
    problem.emfs = {1};
    problem.injected = {0, 0};
    problem.given = {5, 3};
    Solution const found = solutionOf(problem);
    EXPECT_EQ(found.amperes, std::vector<double>{6});
    EXPECT_EQ(found.volts, (std::vector<double>{5, 3}));
}

TEST(ConductanceSolver, RepeatsOnlyNecessaryWorkWithTheSameResults) {
    EXPECT_TRUE(rc::check("the same bits as of a solver that has solved nothing else", [] {
        Problem first = anyProblem(6);
        Problem const second = anyProblem(6);
        ConductanceSolver solver;
        static_cast<void>(solutionOf(first, solver));
        RC_ASSERT(solver.symbolicFactorisations() == 1);
        bool const anyUnknown =
            std::find(first.fixed.begin(), first.fixed.end(), std::uint8_t{0}) != first.fixed.end();
        int const numeric = solver.numericFactorisations();
        RC_ASSERT((numeric > 0) == anyUnknown);
        first.injected.back() += 1; // the same matrix
        static_cast<void>(solutionOf(first, solver));
        RC_ASSERT(solver.symbolicFactorisations() == 1);
        RC_ASSERT(solver.numericFactorisations() == numeric);
        first.siemens.front() *= 2; // the same structure
        static_cast<void>(solutionOf(first, solver));
        RC_ASSERT(solver.symbolicFactorisations() == 1);
        RC_ASSERT((solver.numericFactorisations() > numeric) == anyUnknown);
        Solution const after = solutionOf(second, solver);
        Solution const fresh = solutionOf(second);
        RC_ASSERT(after.volts == fresh.volts);
        RC_ASSERT(after.amperes == fresh.amperes);
        ConductanceSolver moved(std::move(solver));
        RC_ASSERT(solutionOf(second, moved).volts == fresh.volts);
    }));
}

} // namespace
} // namespace conductance_solver_test
} // namespace trembler
