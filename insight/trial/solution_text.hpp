// A solution as one line of text: for journals and for comparing solutions.
#pragma once

#include "runtime/level/model/level.hpp"

#include <string>

namespace trembler::insight {

/// Its placements, wires and inputs; not its name, changes and places in a file. Placements are in canonical
/// order, as their order never matters, so equal texts mean equal runs.
[[nodiscard]] std::string toText(Solution const& solution);
/// The inverse. The text must be one that toText() has made.
[[nodiscard]] Solution solutionFrom(std::string const& text);
/// 16 hex digits of a hash of the entries that decide its run: that text, its changes and its stated
/// duration. Not its name, nor whether it is expected to solve the level.
[[nodiscard]] std::string identityOf(Solution const& solution);

} // namespace trembler::insight
