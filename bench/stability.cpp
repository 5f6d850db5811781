// The hard cases of measure/stability/ over many jittered seeds: the results with the automatic settings, and
// the cheapest fixed settings that keep all limits. Makes the tables of docs/measurements/stability.md:
//
//   bench_stability --markdown > table.md
//
// --case TEXT selects the cases whose name contains it. With --substeps only this number is tried, and all
// figures are shown. Progress goes to standard error.
#include "measure/stability/hard_case.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

using namespace trembler;
using namespace trembler::stability;

struct Worst {
    std::vector<Figure> figures;
    bool holds = true;
    double seconds = 0; ///< wall, per run
};

Worst worstOf(HardCase const& one, Setting const& setting, int seeds, bool stopAtFault) {
    Worst worst;
    auto const begin = std::chrono::steady_clock::now();
    int const runs = one.jittered ? seeds : 1;
    int done = 0;
    for (int seed = 1; seed <= runs && (worst.holds || !stopAtFault); ++seed) {
        fmt::print(stderr, "\r{} {}, {} substeps, seed {} of {}    ", one.row, one.name,
                   setting.solver.substeps == DynamicsSettings::automatic
                       ? "automatic"
                       : std::to_string(setting.solver.substeps),
                   seed, runs);
        std::vector<Figure> const figures = one.run(setting, static_cast<std::uint64_t>(seed));
        ++done;
        if (worst.figures.empty()) {
            worst.figures = figures;
        }
        for (std::size_t i = 0; i < figures.size(); ++i) {
            worst.figures[i].value = std::max(worst.figures[i].value, figures[i].value);
        }
        worst.holds = worst.holds && holds(figures);
    }
    fmt::print(stderr, "\r{:100}\r", "");
    worst.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / done;
    return worst;
}

std::string withUnit(double value, std::string const& unit) {
    return fmt::format("{:.3g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string text(std::vector<Figure> const& figures, bool limits) {
    std::string all;
    for (Figure const& figure : figures) {
        if (limits && !(figure.limit < std::numeric_limits<double>::infinity())) {
            continue;
        }
        bool const bad = !limits && !figure.holds();
        all += fmt::format("{}{} {}{}{}{}", all.empty() ? "" : "; ", figure.what, limits ? "≤ " : "",
                           bad ? "**" : "", withUnit(limits ? figure.limit : figure.value, figure.unit),
                           bad ? "**" : "");
    }
    return all;
}

// The fewest fixed substeps, at the automatic scale, with which all of the seeds keep their limits.
std::string cheapest(HardCase const& one, Setting setting, int seeds) {
    for (int const n : {1, 2, 4, 6, 8, 12, 16, 24, 32, 48, 64}) {
        setting.solver.substeps = n;
        if (worstOf(one, setting, seeds, true).holds) {
            return fmt::format("{} substep{}", n, n == 1 ? "" : "s");
        }
    }
    return "none up to 64 substeps";
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("The hard cases over many jittered seeds");
    int seeds = 20;
    int searchSeeds = 5;
    std::string wanted;
    std::vector<int> substeps;
    bool search = true;
    bool markdown = false;
    Setting setting;
    app.add_option("--seeds", seeds, "Jittered worlds of each case")->check(CLI::Range(1, 1000));
    app.add_option("--search-seeds", searchSeeds, "Worlds that a fixed setting must hold in")
        ->check(CLI::Range(1, 1000));
    app.add_option("--case", wanted, "Only cases whose name contains this");
    app.add_option("--engine", setting.engine, "box2d, chipmunk, ode or native");
    app.add_option("--substeps", substeps, "Only these fixed numbers of substeps")->delimiter(',');
    app.add_option("--scale", setting.solver.scale, "Engine units per metre; 0: automatic");
    app.add_option("--iterations", setting.solver.velocityIterations);
    app.add_option("--position-iterations", setting.solver.positionIterations);
    app.add_flag("!--no-search", search, "Leave out the search for the cheapest setting");
    app.add_flag("--markdown", markdown, "The table of docs/measurements/stability.md");
    CLI11_PARSE(app, argc, argv);
    if (markdown) {
        fmt::print("| case | must hold | reached with automatic settings, worst of {} seeds | holds | "
                   "cheapest fixed setting that holds, {} seeds |\n|---|---|---|---|---|\n",
                   seeds, searchSeeds);
    }
    bool all = true;
    for (HardCase const& one : allCases()) {
        std::string const name = one.name.empty() ? one.row : one.row + ", " + one.name;
        if (name.find(wanted) == std::string::npos) {
            continue;
        }
        for (int const n : substeps) {
            setting.solver.substeps = n;
            Worst const worst = worstOf(one, setting, seeds, false);
            fmt::print("{:<48} {:>2} substeps {} {}; {:.2f} s\n", name, n, worst.holds ? "holds" : "FAILS",
                       text(worst.figures, false), worst.seconds);
            std::fflush(stdout);
        }
        if (!substeps.empty()) {
            continue;
        }
        Worst const worst = worstOf(one, setting, seeds, false);
        all = all && worst.holds;
        if (markdown) {
            fmt::print("| {} | {} | {} | {} | {} |\n", name, text(worst.figures, true),
                       text(worst.figures, false), worst.holds ? "yes" : "**no**",
                       one.version    ? one.version()
                       : !one.tunable ? "–"
                       : search       ? cheapest(one, setting, searchSeeds)
                                      : "not searched");
        } else {
            fmt::print("{:<58} {} {}; {:.2f} s\n", name, worst.holds ? "holds" : "FAILS",
                       text(worst.figures, false), worst.seconds);
        }
        std::fflush(stdout);
    }
    return all ? 0 : 1;
}
