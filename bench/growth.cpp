// How cost grows with the number of each thing that a level can contain: processor time to load a level up to
// its first frame, and per frame after that, for a hundred to a hundred thousand of each, and the exponent k
// of n^k that fits the last three sizes best. Prints a table in Markdown, for
// docs/measurements/performance.md, and its progress to standard error. Exit status 1 if an exponent exceeds
// the row's limit.
//
//   bench_growth [ROW...] [--most N] [--engine E]
//
// Processor time, so that other programs on the machine have little influence, and medians of up to five
// trials. The time of a frame is the mean of five, so that work which is done in only one of them counts.
// Sizes that would take more than half a minute, extrapolated from smaller ones, are skipped.
#include "bench/growth_levels/rows.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <optional>

namespace {

using namespace trembler;
using bench::framesOfGrowth;
using bench::GrowthRow;

constexpr double patience = 30; // s

double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Measured {
    double n = 0;
    double load = 0;  // s
    double frame = 0; // s
};

/// Loads a level of n, runs its frames and returns the times of both.
Measured measureOnce(GameData const& gameData, GrowthRow const& row, int n, std::string const& text,
                     std::string const& engine) {
    Measured measured{static_cast<double>(n), 0, 0};
    double const before = processorTime();
    std::optional<Session> session;
    bool refused = false;
    try {
        LevelFile const file = readLevel(gameData.registry, JsonDocument::parse(text, row.key));
        WorldOptions options;
        options.detail = file.detail;
        options.detail["dynamics"] = engine;
        session.emplace(gameData.registry, gameData.parts, file, options);
        if (!file.solutions.empty()) {
            session->load(file.solutions.front());
        }
        session->step();
    } catch (InputError const& error) {
        refused = true;
        if (!row.refused) {
            std::fprintf(stderr, "%s\n", error.what());
        }
    }
    double const loaded = processorTime();
    measured.load = loaded - before;
    if (refused != row.refused) {
        throw std::runtime_error(std::string("the level is ") + (refused ? "refused" : "not refused"));
    }
    if (!refused) {
        for (int frame = 0; frame < framesOfGrowth; ++frame) {
            session->step();
        }
        measured.frame = (processorTime() - loaded) / framesOfGrowth;
    }
    return measured;
}

double total(Measured const& measured) {
    return measured.load + framesOfGrowth * measured.frame;
}

/// The medians of up to five trials; fewer if they take long.
Measured measure(GameData const& gameData, GrowthRow const& row, int n, std::string const& engine) {
    constexpr double enough = 5; // s
    constexpr std::size_t most = 5;
    std::string const text = row.make(n).dump();
    std::vector<Measured> trials;
    double spent = 0;
    while (trials.size() < most && (trials.empty() || spent < enough)) {
        trials.push_back(measureOnce(gameData, row, n, text, engine));
        spent += total(trials.back());
    }
    auto const median = [&](double Measured::*time) {
        std::vector<double> all;
        for (Measured const& trial : trials) {
            all.push_back(trial.*time);
        }
        auto const middle = all.begin() + static_cast<std::ptrdiff_t>((all.size() - 1) / 2);
        std::nth_element(all.begin(), middle, all.end());
        return *middle;
    };
    Measured const measured{static_cast<double>(n), median(&Measured::load), median(&Measured::frame)};
    std::fprintf(stderr, "%-24s n = %-7d load %10.2f ms, frame %10.4f ms, %zu trials\n", row.key.c_str(), n,
                 1000 * measured.load, 1000 * measured.frame, trials.size());
    return measured;
}

/// The exponent of n that fits the last three sizes best: the slope of a line through the logarithms. Times
/// close to the clock's resolution are ignored; in small sizes the constant cost of an empty level dominates.
std::optional<double> exponent(std::vector<Measured> const& all, double Measured::*time) {
    constexpr double least = 2e-4; // s
    double const largest = all.empty() ? 0 : all.back().n;
    double count = 0;
    double sumX = 0;
    double sumY = 0;
    double sumXX = 0;
    double sumXY = 0;
    for (Measured const& one : all) {
        if (one.*time > least && one.n >= largest / 100) {
            double const x = std::log(one.n);
            double const y = std::log(one.*time);
            count += 1, sumX += x, sumY += y, sumXX += x * x, sumXY += x * y;
        }
    }
    double const spread = count * sumXX - sumX * sumX;
    return spread > 0 ? std::optional((count * sumXY - sumX * sumY) / spread) : std::nullopt;
}

std::string milliseconds(double seconds) {
    return seconds >= 0.1 ? fmt::format("{:.0f}", 1000 * seconds) : fmt::format("{:.2g}", 1000 * seconds);
}

/// Returns false if the exponent exceeds `most`.
bool print(GrowthRow const& row, std::vector<Measured> const& all, std::vector<int> const& sizes,
           char const* what, double Measured::*time, double most) {
    std::string line = fmt::format("| {} | {} |", row.what, what);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        line += i < all.size() ? fmt::format(" {} |", milliseconds(all[i].*time)) : " – |";
    }
    std::optional<double> const found = exponent(all, time);
    std::puts((line + " " + (found ? fmt::format("{:.2f}", *found) : "–") + " |").c_str());
    std::fflush(stdout);
    if (found && *found > most) {
        std::fprintf(stderr, "%s, %s: grows as n^%.2f, MISSED the limit of n^%.2f\n", row.key.c_str(), what,
                     *found, most);
        return false;
    }
    return true;
}

/// Returns false if a limit is exceeded.
bool printRow(GameData const& gameData, GrowthRow const& row, std::vector<int> const& sizes,
              std::string const& engine) {
    std::vector<Measured> all;
    for (int const n : sizes) {
        if (static_cast<std::size_t>(n) > row.most) {
            break;
        }
        if (all.size() >= 2) { // extrapolates the growth so far
            double const before = total(all[all.size() - 2]);
            double const last = total(all.back());
            if (last * last / std::max(1e-3, before) > patience) {
                std::fprintf(stderr, "%-24s n = %-7d would take too long\n", row.key.c_str(), n);
                break;
            }
        }
        all.push_back(measure(gameData, row, n, engine));
    }
    bool const load = print(row, all, sizes, "load", &Measured::load, row.mostOfLoad);
    return (row.refused || print(row, all, sizes, "frame", &Measured::frame, row.mostOfFrame)) && load;
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::string> wanted;
    int most = 100000;
    std::string engine = "box2d";
    CLI::App program("How cost grows with what a level states in number.");
    program.add_option("ROW", wanted, "Only these");
    program.add_option("--most", most, "The largest number")->check(CLI::Range(100, 1000000));
    program.add_option("--engine", engine, "box2d, chipmunk, ode or native");
    CLI11_PARSE(program, argc, argv);

    std::vector<int> sizes;
    std::string head = "| ms of processor time, n = | |";
    std::string rule = "|---|---|";
    for (int n = 100; n <= most; n *= 10) {
        sizes.push_back(n);
        head += fmt::format(" {} |", n);
        rule += "---|";
    }
    std::puts((head + " grows as n^ |\n" + rule + "---|").c_str());
    GameData const gameData;
    bool all = true;
    for (GrowthRow const& row : bench::growthRows()) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), row.key) == wanted.end()) {
            continue;
        }
        try {
            all = printRow(gameData, row, sizes, engine) && all;
        } catch (std::exception const& error) {
            std::fprintf(stderr, "%s: %s\n", row.key.c_str(), error.what());
            all = false;
        }
    }
    return all ? 0 : 1;
}
