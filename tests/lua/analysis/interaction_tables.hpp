// The tables about interactions of docs/scripting-analysis.md, as Markdown.
#pragma once

#include "tests/lua/analysis/comparison.hpp"

#include <string>
#include <vector>

namespace trembler::lua::analysis {

/// Every interaction: its lines, in how many plays it was compared, and whether the worlds are equal. The
/// same on every machine.
[[nodiscard]] std::string hashTable(std::vector<Comparison> const& compared);
/// The time of a turn in C++ and in Lua.
[[nodiscard]] std::string timeTable(std::vector<Comparison> const& compared);

} // namespace trembler::lua::analysis
