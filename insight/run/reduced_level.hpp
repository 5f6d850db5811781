// A level and a solution without the entries that a variation leaves out.
#pragma once

#include "insight/run/placed_names.hpp"
#include "insight/run/variation.hpp"

#include <set>
#include <string>
#include <vector>

namespace trembler::insight {

/// A level and a solution without the entries that were left out.
struct ReducedLevel {
    LevelFile level;
    Solution solution;
    std::set<std::string> effects; ///< left out
    std::vector<LeftOut> later;    ///< entries left out of the running world, ascending by first frame
};

/// Takes a variation's placements, wires, inputs, objects, joints and connections out. With an object go its
/// joints, gears between those, and connections. Names of placed parts follow from their part and place, so
/// they may differ from those of the whole run, see PlacedNames: wires, inputs and touches name the same
/// objects as before, and a wire to a placed part goes with the part. Throws std::invalid_argument for an
/// index or a name that does not exist.
[[nodiscard]] ReducedLevel reduced(LevelFile const& level, Variation const& variation);

/// The solution alone without placements, wires and inputs; other entries of `leftOut` are ignored. Throws as
/// reduced().
[[nodiscard]] Solution reducedSolution(LevelFile const& level, Solution const& solution,
                                       std::vector<LeftOut> const& leftOut);

/// The names of placed objects in the run of a variation.
[[nodiscard]] PlacedNames namesWithout(LevelFile const& level, Variation const& variation);

} // namespace trembler::insight
