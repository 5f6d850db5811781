// The hard cases of tests/stability/ over many jittered seeds: what is reached with the automatic settings,
// and the cheapest fixed setting that holds. It makes the table of docs/stability.md.
//
//   bench_stability [--seeds N] [--case TEXT] [--engine NAME] [--substeps N,N...] [--scale X] [--iterations
//   N]
//
// TEXT picks the cases whose name contains it. With --substeps only these are tried and all figures shown.
#include "tests/stability/hard_case.hpp"

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
    int runs = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        std::vector<Figure> const figures = one.run(setting, static_cast<std::uint64_t>(seed));
        ++runs;
        if (worst.figures.empty()) {
            worst.figures = figures;
        }
        for (std::size_t i = 0; i < figures.size(); ++i) {
            worst.figures[i].value = std::max(worst.figures[i].value, figures[i].value);
        }
        worst.holds = worst.holds && holds(figures);
        if (stopAtFault && !worst.holds) {
            break;
        }
    }
    worst.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / runs;
    return worst;
}

std::string text(std::vector<Figure> const& figures) {
    std::string all;
    for (Figure const& figure : figures) {
        all += fmt::format("{}{} {:.3g}{}{}{}", all.empty() ? "" : "; ", figure.what, figure.value,
                           figure.unit.empty() ? "" : " ", figure.unit,
                           figure.holds() ? "" : fmt::format(" (limit {:.3g})", figure.limit));
    }
    return all;
}

// The fewest fixed substeps, at the automatic scale, with which all seeds hold.
std::string cheapest(HardCase const& one, Setting setting, int seeds) {
    for (int const n : {1, 2, 4, 6, 8, 12, 16, 24, 32, 48, 64}) {
        setting.solver.substeps = n;
        if (worstOf(one, setting, seeds, true).holds) {
            return fmt::format("{} substeps", n);
        }
    }
    return "none up to 64 substeps";
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("The hard cases over many jittered seeds");
    int seeds = 20;
    std::string wanted;
    std::vector<int> substeps;
    bool search = true;
    Setting setting;
    app.add_option("--seeds", seeds)->check(CLI::Range(1, 1000));
    app.add_option("--case", wanted);
    app.add_option("--engine", setting.engine);
    app.add_option("--substeps", substeps)->delimiter(',');
    app.add_option("--scale", setting.solver.scale);
    app.add_option("--iterations", setting.solver.velocityIterations);
    app.add_option("--position-iterations", setting.solver.positionIterations);
    app.add_flag("!--no-search", search, "Leave out the search for the cheapest setting");
    CLI11_PARSE(app, argc, argv);
    for (HardCase const& one : allCases()) {
        std::string const name = one.name.empty() ? one.row : one.row + ", " + one.name;
        if (name.find(wanted) == std::string::npos) {
            continue;
        }
        for (int const n : substeps) {
            setting.solver.substeps = n;
            Worst const worst = worstOf(one, setting, seeds, false);
            fmt::print("{:<48} {:>2} substeps {} {}; {:.2f} s\n", name, n, worst.holds ? "holds" : "FAILS",
                       text(worst.figures), worst.seconds);
            std::fflush(stdout);
        }
        if (substeps.empty()) {
            Worst const worst = worstOf(one, setting, seeds, false);
            fmt::print("| {} | {} | {} | {} |\n", name, worst.holds ? "yes" : "**no**", text(worst.figures),
                       !one.tunable ? "" : search ? cheapest(one, setting, seeds) : "not searched");
            std::fflush(stdout);
        }
    }
    return 0;
}
