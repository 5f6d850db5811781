#include "tests/puzzle/edit/any_further_command.hpp"

#include "puzzle/edit/commands/clipboard.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/own_parts.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/commands/shapes.hpp"
#include "puzzle/edit/commands/solutions.hpp"

namespace trembler::edit {

namespace {

std::string oneOf(std::vector<std::string> const& all, std::function<int(int)> const& next) {
    return all.empty() ? std::string("none")
                       : all[static_cast<std::size_t>(next(static_cast<int>(all.size())))];
}

Solution anySolution(std::function<int(int)> const& next) {
    Solution solution;
    solution.name = oneOf({"", "wait", "drop"}, next);
    solution.placements.push_back({"steel ball", {next(8) / 4.0, 2}, 0, {}, next(2) == 0});
    solution.solves = next(2) == 0;
    if (next(2) == 0) {
        solution.frames = 1 + next(600);
    }
    return solution;
}

Json anyEntry(std::string const& list, std::vector<std::string> const& objects,
              std::function<int(int)> const& next) {
    Json const at = Json::array({next(16) / 4.0, 2});
    std::string const name =
        next(2) == 0 ? "steel ball " + std::to_string(1 + next(2)) : oneOf(objects, next);
    if (list == "placements") {
        return Json{
            {"part", oneOf({"steel ball", "plank", "scale"}, next)}, {"at", at}, {"angle_deg", next(90)}};
    }
    if (list == "wires") {
        return Json::array({name, oneOf(objects, next)});
    }
    if (list == "changes") {
        return Json{{"frame", 1 + next(9)}, {"detail", {{"dynamics", "box2d"}}}};
    }
    switch (next(3)) {
    case 0:
        return Json{{"frame", 1 + next(90)}, {"grab", name}, {"at", at}};
    case 1:
        return Json{{"frame", 1 + next(90)}, {"release", true}};
    default:
        return Json{{"frame", 1 + next(90)}, {"cut", {name, oneOf(objects, next)}}};
    }
}

Command anyOfSolutions(Json const& level, std::function<int(int)> const& next) {
    std::string const name = oneOf({"wait", "stay", "drop"}, next);
    std::string const list = oneOf({"placements", "wires", "inputs", "changes", "none"}, next);
    std::vector<std::string> const objects = objectNames(level);
    auto const index = static_cast<std::size_t>(next(3));
    switch (next(9)) {
    case 0:
        return addSolution(level, anySolution(next));
    case 1:
        return recordAgain(level, name, anySolution(next));
    case 2:
        return next(3) == 0 ? removeSolution(level, name) : expectSolved(level, name, next(2) == 0);
    case 3:
    case 4:
        return setSolutionEntry(level, name, list, index, anyEntry(list, objects, next));
    case 5:
        return removeSolutionEntry(level, name, list, index);
    case 6:
        return moveSolutionEntry(level, name, list, index, static_cast<std::size_t>(next(3)));
    default:
        return addSolutionEntry(level, name, list, anyEntry(list, objects, next));
    }
}

} // namespace

Command anyFurtherCommand(LevelDocument const& document, std::function<int(int)> const& next) {
    Json const& level = document.tree();
    GameData const& data = document.data();
    std::vector<std::string> const all = objectNames(level);
    auto const point = [&] {
        double const x = (next(200) - 100) / 16.0;
        return Vec2{x, (next(200) - 100) / 16.0};
    };
    auto const index = [&] { return static_cast<std::size_t>(next(3)); };
    auto const one = [&] { return oneOf(all, next); };
    auto const place = [&]() -> std::string {
        auto const lines = goalLines(level);
        return lines.empty() ? ""
                             : lines[static_cast<std::size_t>(next(static_cast<int>(lines.size())))].place;
    };
    switch (next(23)) {
    case 0:
        return addListEntry(data, level, {one()}, "shape", "", Json());
    case 1:
        return removeListEntry(data, level, {one()}, "shape", "", index());
    case 2:
        return addConnection(level, one(), one());
    case 3:
        return changeConnection(level, index(), one(), one(), oneOf({"", "wire"}, next));
    case 4:
        return moveJointPoint(level, index(), oneOf({"at", "at_b", "ground_a"}, next), point());
    case 5:
        return changeGoal(level, place(), newCondition("touching", {one(), one()}, {}));
    case 6:
        return setGoalArea(level, place(), Area{Box{point(), {1, 2}}, {}});
    case 7:
        return moveGoal(level, place(), index());
    case 8:
        return cutObjects(data, level, {one(), one()});
    case 9:
        return replaceByPart(data, level, {one()}, one(), "crate");
    case 10:
        return placeAnywhere(level);
    case 11:
        return setPlacingArea(level, index(), Area{Box{point(), {2, 2}}, {}});
    case 12:
        return next(2) == 0 ? resetWorldProperty(level, oneOf({"gravity", "air", "bounds"}, next))
                            : setBounds(level, {});
    case 13:
        return setDetail(data, level, oneOf({"dynamics", "gravity", "none"}, next),
                         oneOf({"", "box2d", "linear", "none"}, next));
    case 14:
        return setMods(level, next(2) == 0 ? std::vector<std::string>{}
                                           : std::vector<std::string>{oneOf({"windmill", "other"}, next)});
    case 15:
        return setStep(level, index(), newStep("run", {}, {}).value());
    case 16:
        return setToolCount(level, index(), next(5));
    case 21:
        return moveCorner(data, level, one(), index(), point());
    default:
        return anyOfSolutions(level, next);
    }
}

} // namespace trembler::edit
