// Checks statements of a level file that refer to other parts of it: connections, recorded inputs and
// changes.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/world/registry.hpp"

#include <map>
#include <string>

namespace trembler {

/// Complains about connections to objects that the level does not have, of an object with itself, and stated
/// twice; about inputs of solutions that cannot happen (InputCheck); and about changes that no world of the
/// registry allows (faultIn()). To be called once all of the level has been read from its document. `paths`
/// holds the place in the file of every name of an object or a joint. Names that may be those of pieces of
/// composite parts are accepted: they can only be checked against the parts.
void checkLevel(Registry const& registry, LevelFile const& level,
                std::map<std::string, std::string> const& paths, Problems& problems);

} // namespace trembler
