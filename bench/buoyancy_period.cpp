// Out-of-order execution of buoyancy (6.12.5): the motion of Experiment IV's raft if F_B is computed only in
// every nth frame, for n from 1 to 12, at both detail levels, with and without looking ahead.
//
//     bench_buoyancy_period [--svg FILE] [--csv FILE]
//
// Prints Markdown. The simulation is deterministic, so every machine prints the same numbers except for the
// times. For each run: the greatest deviation of the raft's height from the run with period 1, the time at
// which the raft has come to rest, and the remaining amplitude at the end.
#include "physics/buoyancy/properties/settings.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace trembler;

constexpr int frames = 1800; // half a minute
constexpr int longestPeriod = 12;
constexpr double restAmplitude =
    0.005;                   // m: half a centimetre, less than a pixel of the level on a 720-line screen
constexpr int watched = 120; // frames over which the final amplitude is taken

struct Variant {
    char const* detail;
    char const* component;
    bool lookAhead;
    char const* name;
    char const* stroke; // SVG attributes: colour for looking ahead, dashes for the detail level
    char const* colour;
};
constexpr std::array<Variant, 4> variants{{
    {"particles", "Particle Buoyancy", false, "particles, as in the thesis", "stroke-dasharray='6 4'",
     "#b3541e"},
    {"exact", "Buoyancy", false, "exact", "", "#b3541e"},
    {"particles", "Particle Buoyancy", true, "particles, looking ahead", "stroke-dasharray='6 4'", "#2b6ca3"},
    {"exact", "Buoyancy", true, "exact, looking ahead", "", "#2b6ca3"},
}};

std::vector<double> heights(GameData const& gameData, Variant const& variant, int period) {
    LevelFile const level = loadLevel(gameData.registry, gameData.home / "levels/experiments/4-raft.json");
    WorldOptions options;
    options.detail["buoyancy"] = variant.detail;
    options.periods[variant.component] = period;
    auto const world = buildWorld(gameData.registry, level, gameData.parts, {}, options);
    ObjectId const settings = world->store().find("world");
    auto& column = world->store().column<BuoyancySettings>();
    BuoyancySettings value = column.has(settings) ? column[settings] : BuoyancySettings{};
    value.lookAhead = variant.lookAhead;
    column.set(settings, value);
    ObjectId const raft = world->store().find("raft body");
    std::vector<double> found;
    for (int frame = 0; frame < frames; ++frame) {
        world->step();
        found.push_back(world->find<Position>(raft)->value.y);
    }
    return found;
}

struct Measures {
    double deviation = 0;          // m, the greatest deviation from period 1
    std::optional<double> settled; // s
    double swing = 0;              // m, from lowest to highest at the end
};

double swingOf(std::vector<double> const& values, std::size_t from) {
    auto const [low, high] =
        std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(from),
                            values.begin() + static_cast<std::ptrdiff_t>(from + watched));
    return *high - *low;
}

Measures measure(std::vector<double> const& values, std::vector<double> const& reference) {
    Measures found;
    for (std::size_t i = 0; i < values.size(); ++i) {
        found.deviation = std::max(found.deviation, std::abs(values[i] - reference[i]));
    }
    found.swing = swingOf(values, values.size() - watched);
    // From the end backwards to the last time at which it was farther from its place of rest.
    double const rest = values.back();
    std::size_t last = values.size();
    while (last > 0 && std::abs(values[last - 1] - rest) < restAmplitude) {
        --last;
    }
    if (found.swing < restAmplitude) {
        found.settled = static_cast<double>(last) / 60;
    }
    return found;
}

using Results = std::array<std::array<Measures, longestPeriod + 1>, variants.size()>;

void printTable(Results const& results) {
    for (std::size_t v = 0; v < variants.size(); ++v) {
        fmt::print("**{}**\n\n| period (frames) | greatest deviation (cm) | at rest after (s) | swing after "
                   "{} s (cm) "
                   "|\n|---|---|---|---|\n",
                   variants[v].name, frames / 60);
        for (int period = 1; period <= longestPeriod; ++period) {
            Measures const& m = results[v][static_cast<std::size_t>(period)];
            fmt::print("| {} | {:.1f} | {} | {:.1f} |\n", period, 100 * m.deviation,
                       m.settled ? fmt::format("{:.1f}", *m.settled) : "never", 100 * m.swing);
        }
        fmt::print("\n");
    }
}

// One panel: a quantity over the period, one line for each variant.
class Panel {
public:
    Panel(double left, double top, std::string title, double greatest, double step)
        : left_(left), top_(top), greatest_(greatest) {
        body_ += fmt::format("<text x='{:.0f}' y='{:.0f}' font-size='15'>{}</text>\n", left, top - 14, title);
        for (double value = 0; value <= greatest * 1.0001; value += step) {
            body_ += fmt::format("<line x1='{:.1f}' x2='{:.1f}' y1='{:.1f}' y2='{:.1f}' stroke='#d8d0bf'/>"
                                 "<text x='{:.1f}' y='{:.1f}' text-anchor='end'>{:g}</text>\n",
                                 left, left + width, y(value), y(value), left - 8, y(value) + 4, value);
        }
        for (int period = 1; period <= longestPeriod; ++period) {
            body_ += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n", x(period),
                                 top + height + 18, period);
        }
        body_ +=
            fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>period of the buoyancy resolver "
                        "(frames)</text>\n",
                        left + width / 2, top + height + 40);
    }
    void line(std::array<std::optional<double>, longestPeriod + 1> const& values, Variant const& variant) {
        char const* const colour = variant.colour;
        std::string path;
        for (int period = 1; period <= longestPeriod; ++period) {
            auto const& value = values[static_cast<std::size_t>(period)];
            if (value) {
                double const shown = std::min(*value, greatest_);
                path += fmt::format("{}{:.1f},{:.1f} ", path.empty() ? "M" : "L", x(period), y(shown));
                body_ += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='3' fill='{}'/>\n", x(period),
                                     y(shown), colour);
            } else { // a cross at the upper edge: it never came to rest
                body_ += fmt::format("<path d='M{0:.1f},{2:.1f} l8,8 m0,-8 l-8,8' stroke='{1}' fill='none' "
                                     "stroke-width='2'/>\n",
                                     x(period) - 4, colour, top_ - 4);
            }
        }
        body_ += fmt::format("<path d='{}' stroke='{}' stroke-width='2' fill='none' {}/>\n", path, colour,
                             variant.stroke);
    }
    [[nodiscard]] std::string const& body() const { return body_; }
    static constexpr double width = 360;
    static constexpr double height = 240;

private:
    [[nodiscard]] double x(int period) const { return left_ + width * (period - 0.5) / longestPeriod; }
    [[nodiscard]] double y(double value) const { return top_ + height * (1 - value / greatest_); }

    double left_;
    double top_;
    double greatest_;
    std::string body_;
};

void writeSvg(Results const& results, char const* file) {
    Panel deviation(60, 50, "greatest deviation from period 1 (cm)", 20, 5);
    Panel settling(500, 50, "at rest after (s); crosses: not in half a minute", 30, 5);
    std::string legend;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        std::array<std::optional<double>, longestPeriod + 1> first;
        std::array<std::optional<double>, longestPeriod + 1> second;
        for (std::size_t period = 1; period <= longestPeriod; ++period) {
            first[period] = 100 * results[v][period].deviation;
            second[period] = results[v][period].settled;
        }
        deviation.line(first, variants[v]);
        settling.line(second, variants[v]);
        double const left = 60 + 210 * static_cast<double>(v);
        legend += fmt::format("<path d='M{:.0f},356 h30' stroke='{}' stroke-width='2' {}/>"
                              "<text x='{:.0f}' y='360'>{}</text>\n",
                              left, variants[v].colour, variants[v].stroke, left + 38, variants[v].name);
    }
    std::ofstream out(file);
    out << fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 900 380' font-family='sans-serif' "
        "font-size='12' fill='#333'>\n<rect width='900' height='380' fill='#faf6ec'/>\n{}{}{}"
        "</svg>\n",
        deviation.body(), settling.body(), legend);
}

void writeCsv(Results const& results, char const* file) {
    std::ofstream out(file);
    out << "detail,look_ahead,period,greatest_deviation_m,at_rest_after_s,final_swing_m\n";
    for (std::size_t v = 0; v < variants.size(); ++v) {
        for (int period = 1; period <= longestPeriod; ++period) {
            Measures const& m = results[v][static_cast<std::size_t>(period)];
            out << fmt::format("{},{},{},{:.5f},{},{:.5f}\n", variants[v].detail,
                               variants[v].lookAhead ? "yes" : "no", period, m.deviation,
                               m.settled ? fmt::format("{:.3f}", *m.settled) : "", m.swing);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    GameData const gameData;
    Results results;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        std::vector<double> const reference = heights(gameData, variants[v], 1);
        for (int period = 1; period <= longestPeriod; ++period) {
            results[v][static_cast<std::size_t>(period)] =
                measure(heights(gameData, variants[v], period), reference);
        }
    }
    printTable(results);
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::strcmp(argv[i], "--svg") == 0) {
            writeSvg(results, argv[i + 1]);
        } else if (std::strcmp(argv[i], "--csv") == 0) {
            writeCsv(results, argv[i + 1]);
        }
    }
    return 0;
}
