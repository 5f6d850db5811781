// Difficult networks for nodal analysis: twelve orders of magnitude, islands, short circuits, ten thousand
// nodes.
#include "measure/stability/hard_case.hpp"
#include "measure/stability/netlist_draft.hpp"
#include "physics/electricity/analyses/nodal_analysis.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::stability {
namespace {

constexpr double residualLimit = 1e-9;

// The larger of the recomputed residual and the one that the analysis reports.
double residualOf(Netlist const& netlist, NodalSolution const& solution) {
    return orWorst(std::max(localResidual(netlist, solution), solution.residual));
}

// Resistances from 1 mΩ to 1 GΩ in a random mesh.
std::vector<Figure> ratios(Setting const& /*setting*/, std::uint64_t seed) {
    Jitter jitter(seed);
    auto const below = [&](std::uint32_t n) {
        return std::min(n - 1, static_cast<std::uint32_t>((jitter() + 1) / 2 * n));
    };
    auto const ohm = [&] { return std::pow(10.0, 3 + 6 * jitter()); };
    constexpr std::uint32_t nodes = 300;
    Draft draft(nodes);
    draft.source(0, 9, ohm());
    for (std::uint32_t v = 1; v < nodes; ++v) {
        draft.join(below(v), v, ohm());
    }
    for (std::uint32_t extra = 0; extra < 2 * nodes; ++extra) {
        std::uint32_t const b = 1 + below(nodes - 1);
        draft.join(below(b), b, ohm());
    }
    draft.earth(nodes - 1, ohm());
    NodalAnalysis analysis;
    NodalSolution const& solution = analysis.solve(draft.netlist);
    return {{"residual", "", residualLimit, residualOf(draft.netlist, solution)}};
}

// A grid of a hundred by a hundred nodes.
std::vector<Figure> sheet(Setting const& /*setting*/, std::uint64_t seed) {
    constexpr std::uint32_t side = 100;
    Jitter jitter(seed);
    Draft draft(side * side);
    draft.source(0, 12, 0.1);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            if (x + 1 < side) {
                draft.join(y * side + x, y * side + x + 1, 5.5 + 5 * jitter());
            }
            if (y + 1 < side) {
                draft.join(y * side + x, (y + 1) * side + x, 5.5 + 5 * jitter());
            }
        }
    }
    draft.earth(side * side - 1, 0);
    NodalAnalysis analysis;
    NodalSolution const& solution = analysis.solve(draft.netlist);
    return {{"residual", "", residualLimit, residualOf(draft.netlist, solution)}};
}

// A ring of ten that feeds a lamp, an isolated island of five, and a battery short-circuited by 1 mΩ. The
// analysis must report every object of the island and the shorted source, and must solve the rest.
std::vector<Figure> islandsAndShorts(Setting const& /*setting*/, std::uint64_t seed) {
    Jitter jitter(seed);
    auto const ohm = [&] { return 10 + 9 * jitter(); };
    Draft well(16);
    well.source(0, 9, 1);
    for (std::uint32_t v = 0; v < 10; ++v) {
        well.join(v, (v + 1) % 10, ohm());
    }
    well.earth(5, 0);
    for (std::uint32_t v = 10; v < 15; ++v) {
        well.join(v, v == 14 ? 10 : v + 1, ohm());
    }
    NodalAnalysis analysis;
    NodalSolution const solution = analysis.solve(well.netlist);
    double wrong = 0;
    for (std::uint32_t v = 0; v < 16; ++v) {
        wrong += solution.objects[v].floating == (v >= 10) ? 0 : 1;
        wrong += solution.objects[v].shorted ? 1 : 0;
    }
    Draft shorted(3);
    shorted.source(0, 9, 1);
    shorted.join(0, 1, leastResistance);
    shorted.join(0, 2, ohm());
    shorted.join(2, 1, ohm());
    shorted.earth(1, 0);
    NodalSolution const through = analysis.solve(shorted.netlist);
    wrong += through.objects[0].shorted ? 0 : 1;
    Draft ideal(2); // an ideal source, shorted by an ideal conductor: no finite current exists
    ideal.source(0, 9, 0);
    ideal.join(0, 1, 0);
    ideal.earth(1, 0);
    NodalSolution const without = analysis.solve(ideal.netlist);
    wrong += without.objects[0].shorted && std::isfinite(without.largest) ? 0 : 1;
    return {{"residual", "", residualLimit,
             std::max({residualOf(well.netlist, solution), residualOf(shorted.netlist, through),
                       residualOf(ideal.netlist, without)})},
            {"not reported", "", 0, wrong}};
}

} // namespace

std::vector<HardCase> networkCases() {
    return {{"nodal", "resistance ratios 1e12", ratios, false},
            {"nodal", "floating islands and shorted sources", islandsAndShorts, false},
            {"nodal", "1e4 nodes", sheet, false}};
}

} // namespace trembler::stability
