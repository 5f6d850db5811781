#include "puzzle/edit/commands/rotate_on_grid.hpp"

#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/extent.hpp"
#include "puzzle/edit/tree/grid_features.hpp"
#include "puzzle/edit/tree/motion.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace trembler::edit {
namespace {

constexpr double rightAngle = 1e-5;   // degrees
constexpr double betweenLines = 1e-7; // m: so far from the middle between two lines of the grid is in it

bool pointOnGrid(Vec2 at, double step) {
    return liesOnGrid(at.x, step) && liesOnGrid(at.y, step);
}

/// The quarter turns of the first object that has an angle of them: 0 to 3; nothing if none has.
std::optional<int> quarterTurns(Json const& level, std::vector<std::string> const& names) {
    for (std::string const& name : names) {
        Json const* const entry = findObject(level, name);
        double const quarters = entry == nullptr ? 0.5 : angleOf(*entry) / 90;
        if (std::abs(quarters - std::round(quarters)) * 90 < rightAngle) {
            return static_cast<int>(std::lround(quarters - 4 * std::floor(quarters / 4 + 1e-9))) % 4;
        }
    }
    return {};
}

/// From a coordinate to the grid; from the middle between two of its lines down or up.
double wayToGrid(double value, double step, bool down) {
    double const steps = value / step;
    double const tolerance = betweenLines / step;
    double const to = down ? std::ceil(steps - 0.5 - tolerance) : std::floor(steps + 0.5 + tolerance);
    return to * step - value;
}

/// How turned objects are moved back onto the grid; zero if they are on it, or were not before.
Vec2 wayBack(GameData const& data, Json const& level, std::vector<std::string> const& names, double step) {
    auto const quarters = quarterTurns(level, names);
    auto const box = extentOfObjects(data, level, names);
    if (!quarters || !box || pointOnGrid(box->corner, step)) {
        return {};
    }
    Vec2 const middle = box->corner + 0.5 * box->size;
    Vec2 const before = middle - 0.5 * Vec2{box->size.y, box->size.x}; // the corner, a quarter turn ago
    if (!pointOnGrid(before, step)) {
        return {};
    }
    // Down after one turn and up after the next, so that they cancel out.
    bool const down = *quarters % 2 == 1;
    return {wayToGrid(box->corner.x, step, down), wayToGrid(box->corner.y, step, down)};
}

} // namespace

Command rotateOnGrid(GameData const& data, Json const& level, std::vector<std::string> const& names,
                     double degrees, Vec2 centre, double step) {
    Command command = rotateObjects(data, level, names, degrees, centre);
    command.change = [&data, turn = std::move(command.change), turned = unlocked(level, names),
                      step](Json& tree) {
        turn(tree);
        Vec2 const way = wayBack(data, tree, turned, step);
        if (way == Vec2{}) {
            return;
        }
        Shifts shifts;
        for (std::string const& name : turned) {
            shifts[name] = way;
        }
        shiftObjects(data, tree, shifts);
    };
    return command;
}

} // namespace trembler::edit
