// How cost grows with everything that a level can state in number: processor time to load a level up to its
// first frame, and per frame after that, for a hundred to a hundred thousand of each, and the exponent k of
// n^k that fits best. Prints a table in Markdown, for docs/performance.md.
//
//   bench_growth [ROW...] [--most N] [--engine E]
//
// Processor time, so that other programs on the machine count little. A size is left out where the one before
// it lets expect more than two minutes.
#include "game/core/workshop.hpp"
#include "game/session/session.hpp"
#include "runtime/level/limits.hpp"
#include "runtime/level/read_level.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <optional>

namespace {

using namespace trembler;
using Json = nlohmann::json;

constexpr double patience = 120; // s
constexpr int frames = 5;

double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Json level(std::string const& title) {
    return Json{{"version", 1},
                {"title", title},
                {"world", {{"gravity", {0, -9.81}}}},
                {"objects", Json::array()},
                {"joints", Json::array()},
                {"connections", Json::array()}};
}

Json box(double width, double height) {
    return Json::array({{{"form", "box"}, {"width", width}, {"height", height}}});
}

std::string numbered(char const* word, int number) {
    return fmt::format("{} {}", word, number);
}

void add(Json& level, std::string const& name, double x, double y, Json properties) {
    level["objects"].push_back({{"name", name}, {"at", {x, y}}, {"properties", std::move(properties)}});
}

void addFloor(Json& level, double length) {
    constexpr double piece = 500;
    for (int i = 0; piece * i < length; ++i) {
        add(level, numbered("floor", i), piece * (i + 0.5) - 10, -0.5,
            {{"shape", box(piece, 1)}, {"fixed", true}});
    }
}

/// A row of boxes of 0.5 m, `gap` m apart, `height` m above a floor.
Json row(int n, double gap, double height) {
    Json made = level("row");
    addFloor(made, n * (0.5 + gap) + 20);
    for (int i = 0; i < n; ++i) {
        add(made, numbered("box", i), i * (0.5 + gap), 0.25 + height, {{"shape", box(0.5, 0.5)}});
    }
    return made;
}

/// n conductors on one cable from a source to a return.
Json cable(int n) {
    Json made = level("cable");
    add(made, "source", -1, 0, {{"conductor", true}, {"electrical_source", true}});
    for (int i = 0; i < n; ++i) {
        add(made, numbered("wire", i), i, 0, {{"conductor", true}});
    }
    add(made, "return", n, 0, {{"conductor", true}, {"electrical_return", true}});
    std::string last = "source";
    for (int i = 0; i <= n; ++i) {
        std::string const next = i == n ? "return" : numbered("wire", i);
        made["connections"].push_back({last, next});
        last = next;
    }
    return made;
}

Json twoBodies() {
    Json made = level("two bodies");
    add(made, "a", 0, 0, {{"shape", box(0.5, 0.5)}});
    add(made, "b", 1, 0, {{"shape", box(0.5, 0.5)}});
    return made;
}

/// Things in a square lattice, `apart` m.
Json lattice(int n, double apart, Json const& properties) {
    Json made = level("lattice");
    int const side = static_cast<int>(std::ceil(std::sqrt(n)));
    for (int i = 0; i < n; ++i) {
        add(made, numbered("thing", i), apart * (i % side), apart * static_cast<double>(i / side),
            properties);
    }
    return made;
}

struct Row {
    std::string key;
    std::string what;
    std::function<Json(int)> make;
    /// Whether the level is refused, and this is what is measured.
    bool refused = false;
    /// More of it than a level may hold.
    std::size_t most = 1000000;
};

Json parallel(int n, char const* form) {
    Json made = twoBodies();
    for (int i = 0; i < n; ++i) {
        made["joints"].push_back({{"form", form},
                                  {"a", "a"},
                                  {"b", "b"},
                                  {"at", {0.4, 0}},
                                  {"at_b", {0.6, 0}},
                                  {"stiffness", 10}});
    }
    return made;
}

Json hinges(int n) {
    Json made = level("chain");
    for (int i = 0; i <= n; ++i) {
        add(made, numbered("link", i), i, 0, {{"shape", box(0.9, 0.1)}, {"collision", {{"mask", 0}}}});
    }
    for (int i = 0; i < n; ++i) {
        made["joints"].push_back({{"form", "hinge"},
                                  {"a", numbered("link", i)},
                                  {"b", numbered("link", i + 1)},
                                  {"at", {i + 0.5, 0}}});
    }
    return made;
}

Json cuts(int n) {
    Json made = cable(n);
    Json inputs = Json::array();
    for (int frame = 1; frame <= frames + 1; ++frame) {
        int const at = n / 2 + frame;
        inputs.push_back({{"frame", frame}, {"cut", {numbered("wire", at), numbered("wire", at + 1)}}});
    }
    made["solutions"] = {{{"name", "cut"}, {"inputs", inputs}}};
    return made;
}

Json refusedPlacements(int n) {
    Json made = twoBodies();
    made["toolbox"] = {{{"part", "crate"}}};
    Json placements = Json::array();
    for (int i = 0; i < n; ++i) {
        placements.push_back({{"part", "crate"}, {"at", {0.001 * i, 5}}});
    }
    made["solutions"] = {{{"name", "many"}, {"placements", placements}}};
    return made;
}

Json refusedConnections(int n) {
    Json made = cable(n);
    for (Json& connection : made["connections"]) {
        connection[1] = "nothing " + connection[1].get<std::string>();
    }
    return made;
}

Json solutions(int n) {
    Json made = lattice(n, 1, Json::object());
    made["solutions"] = Json::array();
    for (int i = 0; i < n; ++i) {
        made["solutions"].push_back(
            {{"name", numbered("solution", i)},
             {"inputs", {{{"frame", 1}, {"grab", numbered("thing", i)}, {"at", {0, 0}}}}}});
    }
    return made;
}

Json inputs(int n) {
    Json made = twoBodies();
    Json all = Json::array();
    for (int i = 0; i < n; ++i) {
        all.push_back({{"frame", 1 + i}, {"move", {0, 0}}});
    }
    made["solutions"] = {{{"name", "moves"}, {"inputs", all}}};
    return made;
}

Json goals(int n) {
    Json made = lattice(n, 2, {{"shape", box(0.5, 0.5)}});
    Json all = Json::array();
    for (int i = 1; i < n; ++i) { // "all" is one itself
        all.push_back({{"moved", {{"object", numbered("thing", i)}, {"by", 1000}}}});
    }
    made["goals"] = {{"all", all}};
    return made;
}

Json touchGoal(int n) {
    Json made = row(n, 0.5, 0);
    Json boxes = Json::array();
    for (int i = 0; i < n; ++i) {
        boxes.push_back(numbered("box", i));
    }
    made["goals"] = {{"touching", {boxes, boxes}}};
    return made;
}

Json floats(int n) {
    Json made = level("sea");
    constexpr double piece = 1000;
    for (int i = 0; piece * i < 2 * n + 20; ++i) {
        add(made, numbered("sea", i), piece * (i + 0.5) - 10, -5,
            {{"shape", box(piece, 10)}, {"liquid", true}, {"density", 1000}});
    }
    for (int i = 0; i < n; ++i) {
        add(made, numbered("float", i), 2 * i, 0, {{"shape", box(0.5, 0.5)}, {"density", 500}});
    }
    return made;
}

Json pools(int n) {
    Json made = level("pools");
    for (int i = 0; i < n; ++i) {
        add(made, numbered("pool", i), 2 * i, -5,
            {{"shape", box(1, 10)}, {"liquid", true}, {"density", 1000}});
        add(made, numbered("float", i), 2 * i, 0, {{"shape", box(0.5, 0.5)}, {"density", 500}});
    }
    return made;
}

Json lamps(int n) {
    Json made = level("lamps");
    add(made, "source", 0, 0, {{"conductor", true}, {"electrical_source", true}, {"emf", {{"voltage", 10}}}});
    add(made, "return", 2, 0, {{"conductor", true}, {"electrical_return", true}});
    for (int i = 0; i < n; ++i) {
        add(made, numbered("lamp", i), i, 5,
            {{"conductor", true}, {"electrical_device", true}, {"resistance", 100}});
        made["connections"].push_back({"source", numbered("lamp", i)});
        made["connections"].push_back({numbered("lamp", i), "return"});
    }
    return made;
}

std::vector<Row> rows() {
    Json const crate{{"shape", box(0.5, 0.5)}};
    Json const magnet{{"shape", box(0.2, 0.05)},
                      {"magnetic_poles", {{"poles", "both"}, {"north", {0.1, 0}}, {"south", {-0.1, 0}}}},
                      {"magnetic_strength", {{"strength", 10}}},
                      {"magnet", true}};
    return {
        {"objects", "objects without a body", [](int n) { return lattice(n, 1, Json::object()); }},
        {"falling", "boxes that fall", [=](int n) { return lattice(n, 2, crate); }},
        {"rest", "boxes side by side, at rest", [](int n) { return row(n, 0.5, 0); }},
        {"touching", "boxes in a row, each touching the next", [](int n) { return row(n, 0, 0); }},
        {"landing", "boxes that land in one frame", [](int n) { return row(n, 0.5, 0.01); }},
        {"chain", "hinges of a chain", hinges},
        {"parallel-hinges", "hinges between two bodies", [](int n) { return parallel(n, "hinge"); }},
        {"parallel-springs", "springs between two bodies", [](int n) { return parallel(n, "spring"); }},
        {"connections", "connections of a cable", cable},
        {"cuts", "the same, one cut in each frame", cuts},
        {"lamps", "lamps in parallel, nodal", lamps},
        {"magnets", "magnets", [=](int n) { return lattice(n, 1, magnet); }},
        {"floats", "boxes afloat", floats},
        {"pools", "pools, a box in each", pools},
        {"goals", "goals, each about a body of its own", goals, false, limits::conditions},
        {"touch-goal", "boxes in a goal that any two of them touch", touchGoal},
        {"solutions", "solutions", solutions, false, limits::solutions},
        {"inputs", "inputs of a solution", inputs},
        {"refused-placements", "placements, all but one refused", refusedPlacements, true,
         limits::placements},
        {"refused-connections", "connections to nothing, all refused", refusedConnections, true},
    };
}

struct Measured {
    double n = 0;
    double load = 0;  // s
    double frame = 0; // s
};

Measured measure(Workshop const& workshop, Row const& row, int n, std::string const& engine) {
    std::string const text = row.make(n).dump();
    Measured measured{static_cast<double>(n), 0, 0};
    double const before = processorTime();
    std::optional<Session> session;
    bool refused = false;
    try {
        LevelFile const file = readLevel(workshop.registry, JsonDocument::parse(text, row.key));
        WorldOptions options;
        options.detail = file.detail;
        options.detail["dynamics"] = engine;
        session.emplace(workshop.registry, workshop.parts, file, options);
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
        throw std::runtime_error(row.key + ": the level is " + (refused ? "refused" : "not refused"));
    }
    if (!refused) {
        for (int frame = 0; frame < frames; ++frame) {
            session->step();
        }
        measured.frame = (processorTime() - loaded) / frames;
    }
    return measured;
}

/// The exponent of n that fits best: the slope of a line through the logarithms. Times that the clock hardly
/// sees do not count, nor does what a level costs that states nothing.
std::string exponent(std::vector<Measured> const& all, double Measured::*time) {
    constexpr double least = 2e-4; // s
    double count = 0;
    double sumX = 0;
    double sumY = 0;
    double sumXX = 0;
    double sumXY = 0;
    for (Measured const& one : all) {
        if (one.*time > least && one.n >= 1000) {
            double const x = std::log(one.n);
            double const y = std::log(one.*time);
            count += 1, sumX += x, sumY += y, sumXX += x * x, sumXY += x * y;
        }
    }
    double const spread = count * sumXX - sumX * sumX;
    return spread > 0 ? fmt::format("{:.2f}", (count * sumXY - sumX * sumY) / spread) : "–";
}

std::string milliseconds(double seconds) {
    return seconds >= 0.1 ? fmt::format("{:.0f}", 1000 * seconds) : fmt::format("{:.2g}", 1000 * seconds);
}

void print(Row const& row, std::vector<Measured> const& all, std::vector<int> const& sizes, char const* what,
           double Measured::*time) {
    std::string line = fmt::format("| {} | {} |", row.what, what);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        line += i < all.size() ? fmt::format(" {} |", milliseconds(all[i].*time)) : " – |";
    }
    std::puts((line + " " + exponent(all, time) + " |").c_str());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::string> wanted;
    int most = 100000;
    std::string engine = "box2d";
    CLI::App program("How cost grows with what a level states in number.");
    program.add_option("ROW", wanted, "Only these");
    program.add_option("--most", most, "The largest number")->check(CLI::Range(100, 1000000));
    program.add_option("--engine", engine, "box2d, chipmunk or ode");
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
    Workshop const workshop;
    for (Row const& row : rows()) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), row.key) == wanted.end()) {
            continue;
        }
        std::vector<Measured> all;
        for (int const n : sizes) {
            if (static_cast<std::size_t>(n) > row.most) {
                break;
            }
            if (all.size() >= 2) { // as it grew up to here
                Measured const& a = all[all.size() - 2];
                Measured const& b = all.back();
                double const total = b.load + frames * b.frame;
                if (total * total / std::max(1e-3, a.load + frames * a.frame) > patience) {
                    break;
                }
            }
            all.push_back(measure(workshop, row, n, engine));
        }
        print(row, all, sizes, "load", &Measured::load);
        if (!row.refused) {
            print(row, all, sizes, "frame", &Measured::frame);
        }
    }
    return 0;
}
