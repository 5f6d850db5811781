// Numerically difficult circuits: twelve orders of magnitude, ten thousand nodes, loops and stars of ideal
// conductors, values beyond the values that files may state.
#include "measure/stability/netlist_draft.hpp"
#include "physics/electricity/analyses/kept_analyses.hpp"
#include "physics/electricity/analyses/nodal_analysis.hpp"
#include "tests/physics/electricity/nodal_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace trembler::test {
namespace {

using stability::Draft;
using stability::localResidual;
constexpr double residualLimit = 1e-9;
using Kind = Netlist::Kind;

TEST(ElectricityNodalRobust, ParallelResistorsTwelveOrdersOfMagnitudeApart) {
    Draft draft(2);
    draft.source(0, 10, 1e3);
    draft.join(0, 1, leastResistance);
    draft.netlist.branches.push_back({0, 1, Kind::connection, greatestResistance, 0});
    draft.earth(1, 1e3);
    NodalAnalysis analysis;
    NodalSolution const& solution = analysis.solve(draft.netlist);
    double const together = 1 / (1 / leastResistance + 1 / greatestResistance);
    double const current = 10 / (2e3 + together);
    EXPECT_NEAR(solution.currents[1] / (current * together / leastResistance), 1, 1e-12);
    EXPECT_NEAR(solution.currents[2] / (current * together / greatestResistance), 1, 1e-9); // 5e-15 A
    EXPECT_LE(localResidual(draft.netlist, solution), residualLimit);
}

TEST(ElectricityNodalRobust, AMilliohmBehindAGigaohm) {
    // The potential of the many milliohms is determined only by a gigaohm at either end.
    constexpr std::uint32_t side = 40;
    Draft draft(side * side);
    draft.source(0, 1e3, greatestResistance);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            if (x + 1 < side) {
                draft.join(y * side + x, y * side + x + 1, leastResistance);
            }
            if (y + 1 < side) {
                draft.join(y * side + x, (y + 1) * side + x, leastResistance);
            }
        }
    }
    draft.earth(side * side - 1, greatestResistance);
    NodalAnalysis analysis;
    NodalSolution const& solution = analysis.solve(draft.netlist);
    EXPECT_NEAR(solution.objects[side].potential, 500, 1e-9);
    EXPECT_NEAR(solution.currents.front() / 5e-7, 1, 1e-9);
    // Along the diagonal the sheet is symmetric: each corner's two neighbours carry half of it.
    EXPECT_NEAR(solution.currents[1] / 2.5e-7, 1, 1e-9);
    EXPECT_NEAR(solution.currents[2] / 2.5e-7, 1, 1e-9);
    EXPECT_LE(localResidual(draft.netlist, solution), residualLimit);
}

TEST(ElectricityNodalRobust, RandomMeshesWithRatiosOfTwelveOrders) {
    std::mt19937 engine(7);
    auto const random = [&] { return static_cast<std::uint32_t>(engine()); };
    auto const uniform = [&] { return random() / 4294967296.0; };
    double worst = 0;
    for (int round = 0; round < 40; ++round) {
        std::uint32_t const nodes = 20 + random() % 300;
        Draft draft(nodes);
        auto const ohm = [&] { return std::pow(10.0, -3 + 12 * uniform()); };
        draft.source(0, 9, ohm());
        for (std::uint32_t v = 1; v < nodes; ++v) {
            draft.join(random() % v, v, ohm());
        }
        for (std::uint32_t extra = 0; extra < 2 * nodes; ++extra) {
            std::uint32_t const b = 1 + random() % (nodes - 1);
            draft.join(random() % b, b, ohm());
        }
        draft.earth(nodes - 1, ohm());
        NodalAnalysis analysis;
        NodalSolution const& solution = analysis.solve(draft.netlist);
        ASSERT_GT(solution.largest, 0);
        worst = std::max({worst, localResidual(draft.netlist, solution), solution.residual});
        for (double const i : solution.currents) {
            ASSERT_TRUE(std::isfinite(i));
        }
    }
    EXPECT_LE(worst, residualLimit);
    RecordProperty("worst_residual", std::to_string(worst));
}

TEST(ElectricityNodalRobust, TenThousandNodes) {
    constexpr std::uint32_t side = 100;
    Draft draft(side * side);
    std::mt19937 random(3);
    draft.source(0, 12, 0.1);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            double const ohm = 0.5 + static_cast<double>(random() % 1000) / 100;
            if (x + 1 < side) {
                draft.join(y * side + x, y * side + x + 1, ohm);
            }
            if (y + 1 < side) {
                draft.join(y * side + x, (y + 1) * side + x, ohm);
            }
        }
    }
    draft.earth(side * side - 1, 0);
    NodalAnalysis analysis;
    NodalSolution const& solution = analysis.solve(draft.netlist);
    EXPECT_LE(solution.residual, residualLimit);
    EXPECT_LE(localResidual(draft.netlist, solution), residualLimit);
    // Current is conserved, and all potentials lie between those of the poles.
    EXPECT_NEAR(solution.currents.front() / solution.currents.back(), 1, 1e-12);
    for (auto const& object : solution.objects) {
        ASSERT_GE(object.potential, 0);
        ASSERT_LE(object.potential, 12);
    }
}

TEST(ElectricityNodalRobust, AChainOfTenThousandResistorsThroughAWorld) {
    constexpr int count = 10000;
    NodalWorld circuit;
    circuit.battery("plus", 10);
    std::vector<std::string> row{"plus"};
    for (int i = 0; i < count; ++i) {
        row.push_back(std::to_string(i));
        circuit.resistor(row.back(), i % 2 == 0 ? 1e-3 : 1e3);
    }
    circuit.returning("minus");
    row.emplace_back("minus");
    circuit.wire({row});
    circuit.begin();
    double const expected = 10 / (count / 2 * 1e-3 + count / 2 * 1e3);
    EXPECT_NEAR(circuit.at("0").current / expected, 1, 1e-9);
    EXPECT_NEAR(circuit.at(std::to_string(count - 1)).current / expected, 1, 1e-9);
    EXPECT_LE(circuit.circuitOf("0").residual, residualLimit);
    EXPECT_EQ(circuit.circuitOf("0").objects, count + 2U);
}

TEST(ElectricityNodalRobust, ThousandsOfIdealConductors) {
    // A sheet of ideal conductors between two resistors, and a star.
    constexpr std::uint32_t side = 60;
    Draft draft(side * side + 2);
    std::uint32_t const first = side * side;
    draft.source(first, 5, 0);
    draft.join(0, first, 3);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            if (x + 1 < side) {
                draft.join(y * side + x, y * side + x + 1, 0);
            }
            if (y + 1 < side) {
                draft.join(y * side + x, (y + 1) * side + x, 0);
            }
        }
    }
    draft.join(side * side - 1, first + 1, 2);
    draft.earth(first + 1, 0);
    NodalAnalysis analysis;
    NodalSolution const& solution = analysis.solve(draft.netlist);
    EXPECT_NEAR(solution.currents[0], 1, 1e-14);
    EXPECT_NEAR(solution.currents[2], 0.5, 1e-12); // by symmetry
    EXPECT_LE(solution.residual, residualLimit);
    EXPECT_EQ(solution.objects[7].potential, solution.objects[70].potential); // exactly one node
}

TEST(ElectricityNodalRobust, WhereNoCurrentFlowsThereIsNoResidual) {
    // A resistor that leads nowhere: its current is rounding error, and so is its error in Kirchhoff's law,
    // which is all of it.
    Draft draft(3);
    draft.join(0, 2, 0.88965224);
    draft.source(0, -6, 0.81266207);
    draft.source(1, 18, 0.015423701);
    NodalAnalysis analysis;
    std::mt19937 engine(1);
    for (int round = 0; round < 2000; ++round) {
        for (auto& branch : draft.netlist.branches) {
            branch.resistance = std::pow(10.0, -2 + 4 * (static_cast<double>(engine()) / 4294967296.0));
        }
        NodalSolution const& solution = analysis.solve(draft.netlist);
        ASSERT_LE(solution.largest, 1e-20);
        ASSERT_EQ(solution.residual, 0) << solution.largest;
    }
}

TEST(ElectricityNodalRobust, TheLeastCurrentOfACircuitHasAResidual) {
    // Beside a conductance that would let 1e12 times the current through, and carries none of it.
    Draft draft(402);
    draft.source(0, 1, greatestResistance);
    double sum = greatestResistance;
    for (std::uint32_t v = 0; v < 400; ++v) {
        double const ohm = greatestResistance / (1 + v % 7);
        draft.join(v, v + 1, ohm);
        sum += ohm;
    }
    draft.join(0, 401, leastResistance);
    draft.earth(400, greatestResistance);
    sum += greatestResistance;
    NodalAnalysis analysis;
    NodalSolution const& solution = analysis.solve(draft.netlist);
    EXPECT_NEAR(solution.largest * sum, 1, 1e-12);
    std::vector<double> balance(draft.netlist.objects.size() + 1, 0);
    for (std::size_t b = 0; b < solution.currents.size(); ++b) {
        balance[draft.netlist.branches[b].from] -= solution.currents[b];
        balance[draft.netlist.branches[b].to] += solution.currents[b];
    }
    balance.pop_back(); // the earth
    double worst = 0;
    for (double const b : balance) {
        worst = std::max(worst, std::abs(b));
    }
    EXPECT_GT(worst, 0);
    EXPECT_EQ(solution.residual, worst / solution.largest);
    EXPECT_LE(solution.residual, 1e-12);
}

TEST(ElectricityNodalRobust, AnyStatedValuesGiveFiniteResults) {
    double const infinite = std::numeric_limits<double>::infinity();
    double const nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> const odd{0, -0.0, -1, 1e-300, 1e300, infinite, -infinite, nan, 5};
    for (double const ohm : odd) {
        for (double const volt : odd) {
            for (double const inside : odd) {
                NodalWorld circuit;
                circuit.battery("plus", volt, inside);
                circuit.resistor("load", ohm);
                circuit.lamp("lamp", 6, 3);
                circuit.returning("minus");
                circuit.wire({{"plus", "load", "minus"}, {"load", "lamp", "minus"}, {"plus", "bar", "lamp"}});
                circuit.begin();
                for (char const* const name : {"plus", "load", "lamp", "bar", "minus"}) {
                    auto const entry = circuit.at(name);
                    ASSERT_TRUE(std::isfinite(entry.potential) && std::isfinite(entry.current) &&
                                std::isfinite(entry.power) && std::isfinite(entry.supplied))
                        << ohm << " ohm, " << volt << " V, " << inside << " ohm inside";
                }
                ASSERT_LE(circuit.circuitOf("plus").residual, residualLimit);
            }
        }
    }
}

TEST(ElectricityNodalRobust, TheSymbolicFactorisationIsKeptWhileTheStructureStays) {
    Draft open(5);
    open.source(0, 9, 1);
    open.join(0, 1, 2);
    open.join(1, 2, 3);
    open.join(1, 3, 5);
    open.earth(2, 0);
    Draft closed = open;
    closed.netlist.branches.insert(closed.netlist.branches.begin() + 1, {0, 4, Kind::connection, 7, 0});
    KeptAnalyses kept;
    double const first = kept.solve(open.netlist, "").currents[1];
    int const symbolic = kept.symbolicFactorisations();
    int const numeric = kept.numericFactorisations();
    // Only the EMF differs: the matrix is not factorised again.
    open.netlist.branches[0].emf = 18;
    EXPECT_DOUBLE_EQ(kept.solve(open.netlist, "").currents[1], 2 * first);
    EXPECT_EQ(kept.numericFactorisations(), numeric);
    open.netlist.branches[1].resistance = 4;
    (void)kept.solve(open.netlist, "");
    EXPECT_EQ(kept.symbolicFactorisations(), symbolic);
    EXPECT_GT(kept.numericFactorisations(), numeric);
    // Opened and closed again and again: two structures, each analysed once.
    (void)kept.solve(closed.netlist, "");
    int const both = kept.symbolicFactorisations();
    EXPECT_GT(both, symbolic);
    int const done = kept.numericFactorisations();
    for (int i = 0; i < 10; ++i) {
        NodalSolution const kept1 = kept.solve(i % 2 == 0 ? open.netlist : closed.netlist, "");
        NodalAnalysis fresh;
        NodalSolution const fresh1 = fresh.solve(i % 2 == 0 ? open.netlist : closed.netlist);
        EXPECT_EQ(kept1.currents, fresh1.currents); // bit for bit
    }
    EXPECT_EQ(kept.symbolicFactorisations(), both);
    EXPECT_EQ(kept.numericFactorisations(), done);
}

} // namespace
} // namespace trembler::test
