#include "tests/puzzle/edit/any_command.hpp"

#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/clipboard.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/own_parts.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/commands/rotate_on_grid.hpp"
#include "puzzle/edit/commands/shapes.hpp"
#include "puzzle/edit/commands/solutions.hpp"
#include "puzzle/edit/commands/translations.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "tests/puzzle/edit/any_further_command.hpp"

namespace trembler::edit {

namespace {

/// A change of a piece of a doorbell; if there is none, it is added.
Command anyOfPieces(LevelDocument const& document, std::function<int(int)> const& next) {
    Json const& level = document.tree();
    GameData const& data = document.data();
    std::vector<std::string> bells;
    for (std::string const& name : objectNames(level)) {
        if (findObject(level, name)->value("part", Json()) == "doorbell") {
            bells.push_back(name);
        }
    }
    if (bells.empty()) {
        return addObject(level, {"doorbell", {next(9) / 2.0, 2}});
    }
    std::vector<std::string> const pieces{"striker", "bell", "backboard", "none"};
    std::string const piece = pieces[static_cast<std::size_t>(next(4))];
    switch (next(6)) {
    case 0:
        return setField(data, level, bells, "density", "", 100 + next(900), piece);
    case 1:
        return setField(data, level, bells, "look", "/colour", "#b5372f", piece);
    case 2:
        return addProperty(data, level, bells, "magnet", piece);
    case 3:
        return resetProperty(data, level, bells, "density", piece);
    case 4:
        return removeProperty(data, level, bells, "material", piece);
    default:
        return resetPiece(level, bells, piece);
    }
}

} // namespace

Command anyCommand(LevelDocument const& document, std::function<int(int)> const& next) {
    Json const& level = document.tree();
    GameData const& data = document.data();
    auto const number = [&] { return (next(200) - 100) / 16.0; };
    auto const point = [&] {
        double const x = number();
        return Vec2{x, number()};
    };
    std::vector<std::string> const all = objectNames(level);
    auto const one = [&] {
        return all.empty() ? std::string("none")
                           : all[static_cast<std::size_t>(next(static_cast<int>(all.size())))];
    };
    auto const some = [&] {
        std::vector<std::string> names{one()};
        for (int i = next(3); i > 0; --i) {
            names.push_back(one());
        }
        return names;
    };
    auto const end = [&] { // of a joint or connection
        std::vector<std::string> const names = namesOfObjectsAndPieces(data, level);
        return names.empty() ? std::string("none")
                             : names[static_cast<std::size_t>(next(static_cast<int>(names.size())))];
    };
    auto const index = [&] { return static_cast<std::size_t>(next(3)); };
    auto const place = [&]() -> std::string {
        auto const lines = goalLines(level);
        return lines.empty() ? ""
                             : lines[static_cast<std::size_t>(next(static_cast<int>(lines.size())))].place;
    };
    auto const area = [&] { return Area{Box{point(), {1, 2}}, {}}; };
    auto const kind = [&](std::vector<std::string> const& kinds) {
        return kinds[static_cast<std::size_t>(next(static_cast<int>(kinds.size())))];
    };
    if (next(4) == 0) {
        return anyFurtherCommand(document, next);
    }
    switch (next(62)) {
    case 0:
        return addObject(level, {"steel ball", point(), number()});
    case 1: {
        DrawnShape const drawn = drawnPolygon(std::vector<Vec2>{point(), point(), point(), point()});
        return addObject(level, {"", drawn.at, 0, Json{{"shape", drawn.shape}}, "drawn"});
    }
    case 2:
        return removeObjects(data, level, some());
    case 3:
        return duplicateObjects(data, level, some(), point());
    case 4:
        return renameObject(data, level, one(), kind({"a", "b", "c"}));
    case 5:
        return renameJoint(data, level, index(), kind({"j", "k"}));
    case 6:
        return setPart(level, some(), kind({"", "crate"}));
    case 7:
        return moveObjects(data, level, all, point());
    case 8:
        return moveObjects(data, level, some(), point());
    case 9:
        return rotateObjects(data, level, {one()}, number(), point());
    case 10:
        return next(2) == 0 ? rotateObjects(data, level, some(), number() * 10, point())
                            : rotateOnGrid(data, level, some(), 90 * next(4), point(), 0.1);
    case 11:
        return scaleObjects(data, level, some(), {1.5, 1.5}, point());
    case 12:
        return scaleObjects(data, level, some(), {2, 1}, point());
    case 13:
        return mirrorObjects(data, level, some(), next(2) == 0 ? Mirror::leftRight : Mirror::upDown, point());
    case 14:
        return alignObjects(data, level, some(), static_cast<Alignment>(next(6)));
    case 15:
        return distributeObjects(data, level, all, next(2) == 0 ? Axis::x : Axis::y);
    case 16:
        return setField(data, level, some(), "mass", "", 1 + next(9));
    case 17:
        return setField(data, level, some(), "look", "/colour", "#b5372f");
    case 18:
        return addProperty(data, level, some(), kind({"magnet", "fixed", "damping", "electric_motor"}));
    case 19:
        return resetProperty(data, level, some(), kind({"material", "mass", "angle_deg"}));
    case 20:
        return removeProperty(data, level, some(), kind({"material", "friction", "fixed"}));
    case 21:
        return setWorldField(data, level, "gravity", "", Json::array({0, next(10)}));
    case 22:
        return setBounds(level, Box{point(), {9, 9}});
    case 23:
        return setJointField(data, level, index(), "/collide", next(2) == 0);
    case 24:
        return addJoint(data, level, kind({"hinge", "rope", "spring"}), end(), end(), point(), point());
    case 25:
        return removeJoints(data, level, {index()});
    case 26:
        return addConnection(level, end(), end());
    case 27:
        return removeConnections(level, {index()});
    case 28:
        return setTitle(level, kind({"x", "y"}));
    case 29:
        return setText(level, kind({"", "words"}));
    case 30:
        return addHint(level, "hint");
    case 31:
        return removeHint(level, index());
    case 32:
        return addTool(level, kind({"steel ball", "plank"}), 1 + next(3));
    case 33:
        return removeTool(level, index());
    case 34:
        return addPlacingArea(level, area());
    case 35:
        return removePlacingArea(level, index());
    case 36:
        return addGoal(
            level, place(),
            newCondition(kind({"touching", "inside", "moved", "not", "all"}), {one(), one()}, area()));
    case 37:
        return wrapGoal(level, place(), kind({"all", "any", "not", "sequence"}));
    case 38:
        return removeGoal(level, place());
    case 39:
        return unwrapGoal(level, place());
    case 40:
        return setGoalOption(level, place(), "for", next(4));
    case 41:
        return renameSolution(level, "wait", kind({"stay", "wait"}));
    case 42:
        return groupObjects(level, some());
    case 43:
        return next(2) == 0 ? lockObjects(level, some(), next(2) == 0)
                            : hideObjects(level, some(), next(2) == 0);
    case 44:
        return ungroupObjects(level, some());
    case 45:
        return addStep(
            level, newStep(kind({"place", "wire", "run", "grab", "cut"}), {one(), one()}, point()).value());
    case 46:
        return next(2) == 0 ? removeStep(level, index()) : moveStep(level, index(), index());
    case 47:
        return setWires(level, next(4));
    case 48:
        return setDemonstration(level, next(4) != 0);
    case 49:
        return addGoal(level, "", newCondition(kind({"touching", "inside", "moved"}), {one(), one()}, area()),
                       GoalTree::task);
    case 50:
        return next(3) == 0 ? removeGoal(level, "", GoalTree::task)
                            : wrapGoal(level, "", kind({"all", "any", "not"}), GoalTree::task);
    case 51:
        return setGoalOption(level, "", next(2) == 0 ? "id" : "text", kind({"this", "that"}),
                             next(2) == 0 ? GoalTree::goals : GoalTree::task);
    case 52:
        return next(4) == 0 ? removeLanguage(level, kind({"de", "fr"}))
                            : addLanguage(level, kind({"de", "fr"}));
    case 53:
        return next(2) == 0 ? translateTitle(level, "de", kind({"", "Titel"}))
                            : translateText(level, "de", kind({"", "Worte"}));
    case 54:
        return translateHint(level, "de", index(), kind({"", "Hinweis", "Tipp"}));
    case 55:
        return next(3) == 0   ? translateGoal(level, "de", kind({"this", "that"}), kind({"", "Ziel"}))
               : next(2) == 0 ? setHint(level, index(), kind({"hint", "another"}))
                              : moveHint(level, index(), index());
    case 56:
        return addObject(level, {kind({"doorbell", "push switch"}), point(), number()});
    case 57:
    case 58:
        return anyOfPieces(document, next);
    case 59:
        return next(2) == 0   ? moveTool(level, index(), index())
               : next(2) == 0 ? moveSolution(level, index(), index())
                              : setSolutionFrames(level, kind({"wait", "stay"}), next(3) * 100);
    case 60:
        return setFlipped(level, some(), next(2) == 0);
    default:
        return pasteText(data, level, copiedText(data, level, some()), point());
    }
}

} // namespace trembler::edit
