// A hard case: a scene, how long it must last, and the figures that must not exceed their limits.
#pragma once

#include "measure/stability/rig.hpp"

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace trembler::stability {

/// A measured quantity of a run and its limit.
struct Figure {
    std::string what; ///< for example "joint gap"
    std::string unit;
    double limit = 0;
    double value = 0;

    /// NaN counts as exceeding the limit.
    [[nodiscard]] bool holds() const { return value <= limit; }
};

struct HardCase {
    std::string row;  ///< of the table, for example "suspended chain"
    std::string name; ///< within it, for example "30 links, 1:100"
    std::function<std::vector<Figure>(Setting const&, std::uint64_t seed)> run;
    /// Whether the engine's settings influence the result.
    bool tunable = true;
    /// Whether a run is fast enough to be part of every test run.
    bool quick = true;
    /// Whether the seed influences the result.
    bool jittered = true;
    /// A hash of the case's subject in its present version, for the table: a test computes it again, and so
    /// finds stale rows. Much faster than a run; usually none.
    std::function<std::string()> version = nullptr;
};

[[nodiscard]] std::vector<HardCase> chainCases();
[[nodiscard]] std::vector<HardCase> stackCases();
[[nodiscard]] std::vector<HardCase> smallCases();
[[nodiscard]] std::vector<HardCase> impactCases();
[[nodiscard]] std::vector<HardCase> magnetCases();
[[nodiscard]] std::vector<HardCase> relayCases();
[[nodiscard]] std::vector<HardCase> liquidCases();
[[nodiscard]] std::vector<HardCase> networkCases();
[[nodiscard]] std::vector<HardCase> orbitCases();
[[nodiscard]] std::vector<HardCase> machineCases();
/// All cases, in the order of the table.
[[nodiscard]] std::vector<HardCase> allCases();

[[nodiscard]] inline bool holds(std::span<Figure const> figures) {
    for (Figure const& figure : figures) {
        if (!figure.holds()) {
            return false;
        }
    }
    return !figures.empty();
}

/// `value`, or infinity in place of NaN, so that no limit holds.
[[nodiscard]] inline double orWorst(double value) {
    return value == value ? value : std::numeric_limits<double>::infinity();
}

} // namespace trembler::stability
