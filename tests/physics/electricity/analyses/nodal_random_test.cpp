// Random circuits compared with the dense tableau, Tellegen's theorem, and the same circuits in another
// order.
#include "physics/electricity/analyses/nodal_analysis.hpp"
#include "tests/physics/electricity/nodal_kit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trembler::test {
namespace {

int anyBelow(int bound) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, bound));
}

double ohm(int orders) {
    return std::pow(10.0, anyBelow(1000) / 999.0 * orders - 0.5 * orders);
}

/// A plan of a circuit of objects, some of which are resistors, sources and returns.
struct Plan {
    struct Object {
        double resistance = 0;
        double emf = 0;
        double inside = 0;
        bool source = false;
        bool returning = false;
    };
    std::vector<Object> objects;
    std::vector<std::pair<int, int>> wires;
};

Plan randomPlan(bool idealSource, int orders) {
    Plan plan;
    int const count = 3 + anyBelow(10);
    for (int i = 0; i < count; ++i) {
        Plan::Object object;
        if (anyBelow(10) < 6) {
            object.resistance = ohm(orders);
        }
        if (anyBelow(10) < 2) {
            object.source = true;
            object.emf = anyBelow(41) - 20;
            object.inside = ohm(orders);
        }
        object.returning = anyBelow(10) < 2;
        plan.objects.push_back(object);
    }
    if (idealSource) {
        plan.objects[0] = {.resistance = 0, .emf = 9, .inside = 0, .source = true, .returning = false};
    }
    int const wires = anyBelow(2 * count + 1);
    for (int i = 0; i < wires; ++i) {
        int const a = anyBelow(count);
        int const b = anyBelow(count);
        if (a != b) {
            plan.wires.emplace_back(std::min(a, b), std::max(a, b));
        }
    }
    std::sort(plan.wires.begin(), plan.wires.end());
    plan.wires.erase(std::unique(plan.wires.begin(), plan.wires.end()), plan.wires.end());
    return plan;
}

/// The plan as a netlist, by the definition of one.
Netlist netlistOf(Plan const& plan) {
    Netlist netlist;
    for (std::uint32_t v = 0; v < plan.objects.size(); ++v) {
        netlist.objects.push_back({v, 0});
        netlist.vertex.push_back(v);
        netlist.resistances.push_back(plan.objects[v].resistance);
    }
    for (auto const& [a, b] : plan.wires) {
        auto const u = static_cast<std::uint32_t>(a);
        auto const v = static_cast<std::uint32_t>(b);
        netlist.branches.push_back({u, v, Netlist::Kind::connection,
                                    0.5 * netlist.resistances[u] + 0.5 * netlist.resistances[v], 0});
    }
    for (std::uint32_t v = 0; v < plan.objects.size(); ++v) {
        if (plan.objects[v].source) {
            netlist.branches.push_back({netlist.earth(), v, Netlist::Kind::source,
                                        plan.objects[v].inside + 0.5 * netlist.resistances[v],
                                        plan.objects[v].emf});
        }
    }
    for (std::uint32_t v = 0; v < plan.objects.size(); ++v) {
        if (plan.objects[v].returning) {
            netlist.branches.push_back(
                {v, netlist.earth(), Netlist::Kind::returning, 0.5 * netlist.resistances[v], 0});
        }
    }
    return netlist;
}

/// Whether ideal conductors lead from an ideal source to the return node.
bool idealShort(Netlist const& netlist) {
    std::vector<std::uint8_t> earthed(netlist.objects.size() + 1, 0);
    earthed.back() = 1;
    for (std::size_t round = 0; round < earthed.size(); ++round) {
        for (Netlist::Branch const& b : netlist.branches) {
            if (b.resistance == 0 && b.kind != Netlist::Kind::source) {
                earthed[b.from] = earthed[b.to] = earthed[b.from] | earthed[b.to];
            }
        }
    }
    return std::any_of(netlist.branches.begin(), netlist.branches.end(), [&](Netlist::Branch const& b) {
        return b.kind == Netlist::Kind::source && b.resistance == 0 && earthed[b.to] != 0;
    });
}

TEST(ElectricityNodalRandom, AgreesWithTheDenseTableau) {
    EXPECT_TRUE(rc::check("potentials and currents through resistances", [] {
        Netlist const netlist = netlistOf(randomPlan(anyBelow(2) == 0, 4));
        RC_PRE(!idealShort(netlist));
        Netlist const tree = withoutIdealLoops(netlist);
        Tableau const expected = solveTableau(tree, 0);
        NodalAnalysis analysis;
        NodalSolution const& found = analysis.solve(netlist);
        RC_ASSERT(found.residual <= 1e-12);
        long double largest = 1e-6L; // A: below, the tableau itself is too inexact
        for (long double const i : expected.currents) {
            largest = std::max(largest, std::abs(i));
        }
        for (std::size_t v = 0; v < netlist.objects.size(); ++v) {
            if (!found.objects[v].floating) {
                RC_ASSERT(std::abs(found.objects[v].potential - expected.potentials[v]) <= 1e-12L * 20);
            }
        }
        std::size_t b = 0;
        for (std::size_t t = 0; t < tree.branches.size(); ++t, ++b) {
            while (!(netlist.branches[b] == tree.branches[t])) {
                ++b;
            }
            if (netlist.branches[b].resistance != 0) {
                RC_ASSERT(std::abs(found.currents[b] - expected.currents[t]) <= 1e-11L * largest);
            }
        }
    }));
}

TEST(ElectricityNodalRandom, IdealConductorsAreTheLimitOfEqualSmallResistances) {
    EXPECT_TRUE(rc::check("currents through all branches", [] {
        Netlist const netlist = netlistOf(randomPlan(anyBelow(2) == 0, 2));
        RC_PRE(!idealShort(netlist));
        Tableau const expected = solveTableau(netlist, 1e-8L);
        NodalAnalysis analysis;
        NodalSolution const& found = analysis.solve(netlist);
        for (std::size_t b = 0; b < netlist.branches.size(); ++b) {
            RC_ASSERT(std::abs(found.currents[b] - expected.currents[b]) <= 1e-5L * (1 + found.largest));
        }
    }));
}

TEST(ElectricityNodalRandom, EnergyIsConserved) {
    // Tellegen: the power of the EMFs equals the heat; for any other potentials the sum of the powers is zero
    // as well.
    EXPECT_TRUE(rc::check("Tellegen's theorem", [] {
        Plan const plan = randomPlan(anyBelow(2) == 0, 6);
        NodalWorld circuit("nodal");
        for (std::size_t i = 0; i < plan.objects.size(); ++i) {
            std::string const name = "object " + std::to_string(i);
            ObjectId const id = circuit.conductor(name);
            Plan::Object const& object = plan.objects[i];
            if (object.resistance > 0) {
                circuit.store().column<Resistance>().set(id, {object.resistance});
            }
            if (object.source) {
                circuit.store().column<ElectricalSource>().set(id, {});
                circuit.store().column<Emf>().set(id, {object.emf, object.inside});
            }
            if (object.returning) {
                circuit.store().column<ElectricalReturn>().set(id, {});
            }
        }
        circuit.returning("so that there is one"); // else single-cable electricity would be used
        for (auto const& [a, b] : plan.wires) {
            circuit.wire({{"object " + std::to_string(a), "object " + std::to_string(b)}});
        }
        circuit.begin();
        double supplied = 0;
        double power = 0;
        for (auto const& entry : circuit.quantities().byIndex) {
            RC_ASSERT(std::isfinite(entry.power));
            RC_ASSERT(entry.power >= 0);
            supplied += entry.supplied;
            power += entry.power;
        }
        RC_ASSERT(std::abs(supplied - power) <= 1e-9 * std::max(power, 1e-12));
    }));
}

/// A world with the plan's circuit, in which calls make and break every wire, in a random order.
std::vector<double> currentsAfterDetours(Plan const& plan, std::vector<std::size_t> const& order) {
    NodalWorld circuit("nodal");
    for (std::size_t i = 0; i < plan.objects.size(); ++i) {
        std::string const name = "object " + std::to_string(i);
        Plan::Object const& object = plan.objects[i];
        if (object.source) {
            circuit.battery(name, object.emf, object.inside);
        } else if (object.returning) {
            circuit.returning(name);
        } else {
            circuit.conductor(name);
        }
        if (object.resistance > 0) {
            circuit.store().column<Resistance>().set(circuit[name], {object.resistance});
        }
    }
    circuit.returning("so that there is one");
    circuit.begin();
    auto const line = [&](std::size_t w, bool add) {
        return Script::Line{circuit["object " + std::to_string(plan.wires[w].first)],
                            circuit["object " + std::to_string(plan.wires[w].second)], 0, add};
    };
    for (std::size_t const w : order) {
        circuit.call({line(w, true)});
        circuit.call({line(order.front(), false)});
        circuit.call({line(order.front(), true)});
    }
    std::vector<double> currents;
    for (std::size_t i = 0; i < plan.objects.size(); ++i) {
        auto const entry = circuit.at("object " + std::to_string(i));
        currents.insert(currents.end(), {entry.current, entry.potential, entry.power});
    }
    return currents;
}

TEST(ElectricityNodalRandom, TheHistoryOfACircuitHasNoInfluence) {
    EXPECT_TRUE(rc::check("bit for bit", [] {
        Plan const plan = randomPlan(true, 6);
        RC_PRE(!plan.wires.empty());
        std::vector<std::size_t> order(plan.wires.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::vector<double> const one = currentsAfterDetours(plan, order);
        for (std::size_t i = order.size(); i-- > 1;) {
            std::swap(order[i], order[static_cast<std::size_t>(anyBelow(static_cast<int>(i) + 1))]);
        }
        RC_ASSERT(currentsAfterDetours(plan, order) == one);
    }));
}

} // namespace
} // namespace trembler::test
