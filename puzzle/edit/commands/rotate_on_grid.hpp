// Turns objects so that corners on the grid are on it again after a quarter turn.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/math/vec2.hpp"

#include <string>
#include <vector>

namespace trembler::edit {

/// As rotateObjects(), for objects that lie on a grid of this step, m, above zero. A quarter turn of a box
/// about its middle takes its corners off the grid by half a step if its width and height differ by an odd
/// number of steps: the objects are then moved back onto it. Four quarter turns lead to where they began, in
/// however many smaller turns each is made. What was not on the grid is only turned.
[[nodiscard]] Command rotateOnGrid(GameData const& data, Json const& level,
                                   std::vector<std::string> const& names, double degrees, Vec2 centre,
                                   double step);

} // namespace trembler::edit
