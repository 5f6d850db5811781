// Warnings about a run for players and authors: the world is still computed, but not as intended.
#pragma once

#include "puzzle/session/session.hpp"

#include <string>
#include <vector>

namespace trembler {

/// One line for each warning about the present world: an engine that gave up, or an object that is held
/// still. Usually none.
[[nodiscard]] std::vector<std::string> warningsOf(World const& world);

/// One line for each placed part that Session::check() refuses where it is: a recorded solution can state
/// places where no player could put the part. Only for a session that is building; otherwise none.
[[nodiscard]] std::vector<std::string> refusedPlaces(Session const& session);

} // namespace trembler
