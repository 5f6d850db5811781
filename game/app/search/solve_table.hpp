// Many searched levels in one table: which of them the search solves, and which are solved by chance.
#pragma once

#include "game/app/search/searched_level.hpp"

#include <string>
#include <vector>

namespace trembler {

/// A table in Markdown with a row for each level, and a sentence about all. Columns about placing at random
/// only if it was done.
[[nodiscard]] std::string solveTable(std::vector<SearchedLevel> const& levels);
/// "Solved by the search: 6 of 7 levels; at random: 3."
[[nodiscard]] std::string solveSummary(std::vector<SearchedLevel> const& levels);
/// One level in one line, for people.
[[nodiscard]] std::string solveLine(SearchedLevel const& level);

} // namespace trembler
