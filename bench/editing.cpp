// What the level editor costs while one drags: a step of moving every object of a level, which reads the
// level and builds its world anew, and a check for problems. In processor time, because the machine is
// shared.
//
//     bench_editing [LEVEL...]
#include "bench/measure.hpp"
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/problems/live_problems.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"

#include <ctime>
#include <filesystem>

namespace {

using namespace trembler;

constexpr int steps = 60;
constexpr double mostPerStep = 4; // ms

template <class F>
void timeProcessor(bench::Series& series, F&& f) {
    std::clock_t const begin = std::clock();
    f();
    series.add(1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
}

void measure(GameData const& data, std::filesystem::path const& file) {
    edit::LevelDocument document = edit::LevelDocument::open(data, file);
    edit::Json const before = document.tree();
    std::vector<std::string> const all = edit::objectNames(before);
    edit::Gesture const gesture{document.newGesture(), edit::Gesture::Next::replaces};
    bench::Series command;
    bench::Series reading;
    bench::Series building;
    bench::Series checking;
    bench::Series whole;
    for (int i = 1; i <= steps; ++i) {
        std::clock_t const begin = std::clock();
        timeProcessor(command, [&] { document.run(edit::moveObjects(before, all, {0.01 * i, 0}), gesture); });
        LevelFile level;
        timeProcessor(reading, [&] { level = readLevel(data.registry, document.json()); });
        timeProcessor(building, [&] {
            auto const world = buildWorld(data.registry, level, data.parts);
            bench::keep(world);
        });
        whole.add(1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        timeProcessor(checking, [&] {
            edit::LiveProblems problems;
            problems.refresh(document);
        });
    }
    bench::Table table(data.shortName(file) + ", " + std::to_string(all.size()) + " objects");
    table.row("the command", command.median(), "ms");
    table.row("reading the level", reading.median(), "ms");
    table.row("building its world", building.median(), "ms");
    table.row("a step of a drag", whole.median(), "ms", whole.median(), mostPerStep);
    table.row("a check for problems, when one pauses", checking.median(), "ms");
    table.print();
}

} // namespace

int main(int count, char** arguments) {
    GameData const data;
    std::vector<std::filesystem::path> files(arguments + 1, arguments + count);
    for (auto const& file : files.empty() ? data.levels() : files) {
        measure(data, file);
    }
    return 0;
}
