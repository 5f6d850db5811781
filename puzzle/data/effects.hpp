// Every effect that the game knows.
#pragma once

#include <set>
#include <string>

namespace trembler {

class Registry;

/// All that the game can do without: those of physics (see dispensableEffects()), and sound.
[[nodiscard]] std::set<std::string> dispensableGameEffects();

/// Registers the runtime's own components, physics and sound, in the order in which conflicting resolvers
/// run. Of an effect in `without` only the properties are known, see registerEverything().
void registerEffects(Registry& registry, std::set<std::string> const& without = {});

} // namespace trembler
