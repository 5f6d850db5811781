// Checks that the parts of a level's toolbox exist.
#pragma once

#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"

namespace trembler {

/// Adds a problem, at its place in the file, for each entry of the toolbox whose part is not in the library.
void checkToolbox(LevelFile const& level, PartLibrary const& library, Problems& problems);

} // namespace trembler
