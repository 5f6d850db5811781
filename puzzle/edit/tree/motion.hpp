// Applies a motion of the plane to objects and to the joints that go with them.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/math/vec2.hpp"

#include <functional>
#include <map>
#include <set>
#include <string>

namespace trembler::edit {

using Shifts = std::map<std::string, Vec2>; // of objects by name, m

/// Moves each object by its own shift. A joint at one point goes with its objects if they have the same
/// shift; of one with two ends, each goes with its object.
void shiftObjects(GameData const& data, Json& level, Shifts const& shifts);

/// A motion of points, and of directions.
struct Motion {
    std::function<Vec2(Vec2)> point;
    std::function<Vec2(Vec2)> direction;
    bool mirrors = false; ///< angles change their sign
};
/// Moves the joints of these objects: those all of whose objects are among them.
void moveJoints(GameData const& data, Json& level, std::set<std::string> const& objects,
                Motion const& motion);

} // namespace trembler::edit
