// An identity of a level: a hash of everything that its runs depend on.
#pragma once

#include "runtime/level/model/level.hpp"

#include <string>

namespace trembler::insight {

/// 16 hex digits of a hash of the entries that decide the physics and the rules: the world, the objects,
/// joints and connections, where parts may be placed, the toolbox, the goals, the task and the mods. Not what
/// the level shows to people (title, text, hints, teaching, translations, texts of goals), nor what the
/// editor keeps, nor the recorded solutions: none of them changes what a run of given placements does, so
/// none may change the random numbers of a measurement. Parts enter by their names only.
[[nodiscard]] std::string identityOf(LevelFile const& level);

} // namespace trembler::insight
