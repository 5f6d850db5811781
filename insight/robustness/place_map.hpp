// Where the parts of a solution may lie.
#pragma once

#include "insight/robustness/robustness.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace trembler::insight {

struct PlaceMapOptions {
    double step = 0.05; ///< m, between neighbours, unless a map would need too many places
    /// Places that one map shows at most. If more are needed, its step is doubled until they suffice.
    std::size_t places = 500;
};

/// Where one part may lie while the others stay in their places: a grid of displacements.
struct PlaceMap {
    std::string part;
    std::size_t placement = 0; ///< its index in the solution
    double step = 0;           ///< m, between neighbours: that of the options, or 2, 4, 8 ... times that
    std::size_t row = 0;       ///< of the recorded place ...
    std::size_t column = 0;    ///< ... in the grid
    std::size_t runs = 0;      ///< that were made for it
    /// From the top row to the lowest, each from left to right: '#' solved, '.' not solved, ' ' it does not
    /// fit there, '-' not run, as no place next to it solves the level, '?' not run, because the work was
    /// stopped. As far as it solves the level, and one place more to each side.
    std::vector<std::string> rows;
};

/// One map for each placement of each solution, by solution. The whole area for placing is looked at in a
/// coarse grid of at most a quarter of the places; from each place found there that solves the level, and
/// from the recorded one, the map then grows over all neighbours that solve it. What solves it in a spot that
/// is smaller than the coarse grid's step, and apart from all others, may be missed. At most places / 4 runs
/// and `places` runs for each step that is tried.
[[nodiscard]] std::vector<std::vector<PlaceMap>> placeMapsOf(LevelUnderTest const& level,
                                                             std::vector<SolvedBy> const& solutions,
                                                             PlaceMapOptions const& options,
                                                             Workers& workers);

} // namespace trembler::insight
