// Finds the placement of a solution because of which no world can be built.
#pragma once

#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/model/level.hpp"

#include <functional>

namespace trembler {

/// The error of a solution with all of whose placements no world can be built, for example because a tank's
/// water would lie in a pond: the messages of `error`, whose places may be in files of parts, and then the
/// placement in the file. `builds(n)` is whether a world can be built with the first n placements and no
/// wires; it is asked O(log n) times. If all placements can be built, the wires are to blame, and `error` is
/// returned as it is.
[[nodiscard]] InputError refusedSolution(LevelFile const& level, Solution const& solution,
                                         std::function<bool(std::size_t)> const& builds,
                                         InputError const& error);

} // namespace trembler
