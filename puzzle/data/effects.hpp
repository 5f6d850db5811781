// All effects of the game.
#pragma once

#include <set>
#include <string>

namespace trembler {

class Registry;

/// The effects that the game can run without: those of physics (see dispensableEffects()), and sound.
[[nodiscard]] std::set<std::string> dispensableGameEffects();

/// Registers the runtime's own components, physics and sound, in the order in which conflicting resolvers
/// run. Of an effect in `without` only the properties are registered, see registerEverything().
void registerEffects(Registry& registry, std::set<std::string> const& without = {});

} // namespace trembler
