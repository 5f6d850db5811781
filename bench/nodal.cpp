// The cost of nodal analysis by size of a circuit: from scratch, with only new resistances, with only new
// EMFs; and the share of refinement and bookkeeping around Eigen's factorisation. For comparison, two-wire
// and flow on the same circuits.
#include "bench/measure.hpp"
#include "physics/electricity/analyses/max_flow.hpp"
#include "physics/electricity/analyses/nodal_analysis.hpp"
#include "physics/electricity/analyses/two_wire.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace {

using namespace trembler;

/// A circuit, its netlist, and a capacity for each object.
struct Sample {
    Circuit circuit;
    Netlist netlist;
    std::vector<Microamperes> capacities;
};

/// A tree with a fifth more wires, as in a house, or a square grid. The first object is the source, the last
/// the return; every second object is a resistor of 1 to 1000 ohm.
Sample sampleOf(std::uint32_t objects, bool sheet) {
    std::mt19937 engine(11);
    auto const random = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(engine() % bound); };
    std::vector<std::vector<std::uint32_t>> neighbours(objects);
    auto const join = [&](std::uint32_t a, std::uint32_t b) {
        if (a != b && std::find(neighbours[a].begin(), neighbours[a].end(), b) == neighbours[a].end()) {
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        }
    };
    auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(objects)));
    for (std::uint32_t v = 1; v < objects; ++v) {
        if (!sheet) {
            join(random(v), v);
        } else {
            join(v - (v % side == 0 ? 0 : 1), v);
            join(v >= side ? v - side : v, v);
        }
    }
    for (std::uint32_t i = 0; !sheet && i < objects / 5; ++i) {
        join(random(objects), random(objects));
    }
    Sample sample;
    sample.circuit.offsets.push_back(0);
    for (std::uint32_t v = 0; v < objects; ++v) {
        sample.circuit.objects.push_back({v, 0});
        sample.circuit.networks.emplace_back();
        sample.circuit.neighbours.insert(sample.circuit.neighbours.end(), neighbours[v].begin(),
                                         neighbours[v].end());
        sample.circuit.offsets.push_back(static_cast<std::uint32_t>(sample.circuit.neighbours.size()));
        sample.capacities.push_back(1'000'000 + random(9'000'000));
    }
    sample.circuit.sources = {{"", 0}};
    sample.circuit.returns = {{"", objects - 1}};
    Column<Resistance> resistances;
    for (std::uint32_t v = 1; v < objects; v += 2) {
        resistances.set({v, 0}, {1.0 + random(1000)});
    }
    Column<Emf> emfs;
    emfs.set({0, 0}, {12, 0.1});
    Column<RatedPower> const ratings;
    Column<Fuse> const fuses;
    makeNetlist(sample.circuit, {resistances, emfs, ratings, fuses}, "", sample.netlist);
    return sample;
}

void measure(std::uint32_t objects, bool sheet) {
    Sample sample = sampleOf(objects, sheet);
    bench::Series again;
    bench::Series numbers;
    bench::Series emf;
    bench::Series twoWire;
    bench::Series flow;
    NodalAnalysis kept;
    (void)kept.solve(sample.netlist);
    int const repetitions = objects > 5000 ? 15 : 101;
    for (int i = 0; i < repetitions; ++i) {
        again.time([&] {
            NodalAnalysis fresh;
            bench::keep(fresh.solve(sample.netlist).largest);
        });
        sample.netlist.branches.front().resistance += sample.netlist.branches.front().resistance == 0 ? 0 : 1;
        for (Netlist::Branch& branch : sample.netlist.branches) {
            branch.resistance += branch.resistance == 0 ? 0 : 0.5;
        }
        numbers.time([&] { bench::keep(kept.solve(sample.netlist).largest); });
        for (Netlist::Branch& branch : sample.netlist.branches) {
            branch.emf += branch.emf == 0 ? 0 : 0.25;
        }
        emf.time([&] { bench::keep(kept.solve(sample.netlist).largest); });
        std::vector<std::uint8_t> on(sample.circuit.size(), 0);
        twoWire.time([&] {
            markTwoWire(sample.circuit, on);
            bench::keep(on.front());
        });
        if (i < 15) {
            flow.time([&] {
                NetworkMembers const members(sample.circuit);
                bench::keep(maxFlow(sample.circuit, members, "", sample.capacities).total);
            });
        }
    }
    bench::Table table(std::to_string(objects) + (sheet ? " objects, a sheet" : " objects, a house"));
    table.row("nodal, everything from scratch", 1e6 * again.median(), "us");
    table.row("nodal, other resistances", 1e6 * numbers.median(), "us");
    table.row("nodal, other EMF", 1e6 * emf.median(), "us");
    table.row("two-wire", 1e6 * twoWire.median(), "us");
    table.row("flow", 1e6 * flow.median(), "us");
    table.row("nodal: residual, of the largest current", 1e18 * kept.solve(sample.netlist).residual, "e-18",
              kept.solve(sample.netlist).residual, 1e-9);
    table.print();
}

} // namespace

int main() {
    for (std::uint32_t const objects : {10U, 100U, 1000U, 10000U}) {
        measure(objects, false);
        measure(objects, true);
    }
    return 0;
}
