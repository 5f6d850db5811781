// The cost of the level editor during a drag: one step that moves one object, or all objects, of a level,
// with the drawn world updated. Then the cost once the mouse rests: the level is read, its world is built,
// and it is checked for problems. In processor time, because the machine is shared.
//
//     bench_editing [LEVEL...]      without levels: generated levels of 10, 100 and 1000 objects
#include "bench/measure.hpp"
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/problems/live_problems.hpp"
#include "puzzle/edit/world/edited_world.hpp"
#include "runtime/level/read/read_level.hpp"

#include <ctime>
#include <filesystem>

namespace {

using namespace trembler;
using edit::Json;

constexpr int steps = 60;
constexpr double mostPerStep = 8; // ms: half of a picture at 60 Hz

template <class F>
void timeProcessor(bench::Series& series, F&& f) {
    std::clock_t const begin = std::clock();
    f();
    series.add(1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
}

/// Crates, lamps, batteries, discs and planks side by side; every fifth hangs on a rope, every fifth is
/// wired.
Json madeLevel(int count) {
    Json objects = Json::array();
    Json joints = Json::array();
    Json connections = Json::array();
    auto const nameOf = [](int i) { return "thing " + std::to_string(i); };
    for (int i = 0; i < count; ++i) {
        Json const at = Json::array({-20 + 0.625 * (i % 60), 0.5 + 0.625 * (i / 60)});
        Json entry{{"name", nameOf(i)}, {"at", at}};
        Json disc{{"form", "circle"}, {"radius", 0.1}};
        Json plank{{"form", "box"}, {"width", 0.3}, {"height", 0.1}};
        switch (i % 5) {
        case 0:
            entry["part"] = "crate";
            break;
        case 1:
            entry["part"] = "battery";
            break;
        case 2:
            entry["properties"] = {{"material", "wood"}, {"shape", Json::array({disc})}};
            break;
        case 3:
            entry["part"] = "lamp";
            connections.push_back(Json::array({nameOf(i), nameOf(i - 2) + " plus"}));
            break;
        default:
            entry["properties"] = {{"material", "wood"}, {"shape", Json::array({plank})}};
            joints.push_back(Json{{"form", "rope"}, {"a", nameOf(i)}, {"b", nameOf(i - 2)}, {"at", at}});
        }
        objects.push_back(std::move(entry));
    }
    return {{"version", 2},
            {"title", "made"},
            {"objects", objects},
            {"joints", joints},
            {"connections", connections}};
}

/// One drag of some objects.
void drag(bench::Table& table, GameData const& data, edit::LevelDocument& document,
          std::vector<std::string> const& names, std::string const& words) {
    edit::EditedWorld world;
    world.build(data, document.level(), document.tree());
    Json const before = document.tree();
    edit::Gesture const gesture{document.newGesture(), edit::Gesture::Next::replaces};
    bench::Series command;
    bench::Series following;
    bench::Series whole;
    for (int i = 1; i <= steps; ++i) {
        std::clock_t const begin = std::clock();
        timeProcessor(command, [&] {
            document.run(edit::moveObjects(data, before, names, {0.01 * i, 0}), gesture);
        });
        bool followed = false;
        timeProcessor(following, [&] { followed = world.follow(document.tree()); });
        whole.add(1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        if (!followed) {
            std::printf("the world did not follow\n");
        }
    }
    table.row("the command, " + words, command.median(), "ms");
    table.row("the world follows, " + words, following.median(), "ms");
    table.row("a step of a drag, " + words, whole.median(), "ms", whole.median(), mostPerStep);
}

void measure(GameData const& data, edit::LevelDocument document, std::string const& title) {
    std::vector<std::string> const all = edit::objectNames(document.tree());
    bench::Table table(title + ", " + std::to_string(all.size()) + " objects");
    drag(table, data, document, {all.back()}, "one object");
    drag(table, data, document, all, "all objects");
    bench::Series reading;
    bench::Series building;
    bench::Series checking;
    for (int i = 0; i < 10; ++i) {
        document.run(edit::moveObjects(data, document.tree(), {all.back()}, {0.01, 0}));
        LevelFile level;
        timeProcessor(reading, [&] { level = readLevel(data.registry, document.json()); });
        edit::EditedWorld world;
        timeProcessor(building, [&] { world.build(data, level, document.tree()); });
        timeProcessor(checking, [&] {
            edit::LiveProblems problems;
            problems.refresh(document);
        });
    }
    table.row("reading the level, when the mouse rests", reading.median(), "ms");
    table.row("building its world, when the mouse rests", building.median(), "ms");
    table.row("a check for problems, when the mouse rests", checking.median(), "ms");
    table.print();
}

} // namespace

int main(int count, char** arguments) {
    GameData const data;
    for (int i = 1; i < count; ++i) {
        std::filesystem::path const file = arguments[i];
        measure(data, edit::LevelDocument::open(data, file), data.shortName(file));
    }
    for (int const objects : {10, 100, 1000}) {
        if (count == 1) {
            measure(data, edit::LevelDocument::fromText(data, madeLevel(objects).dump(1), {}, {}),
                    "a made level");
        }
    }
    return 0;
}
