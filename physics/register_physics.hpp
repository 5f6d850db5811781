// Registers all effects of physics.
#pragma once

#include <set>
#include <string>

namespace trembler {

class Registry;

/// The effects that a world may lack: all except dynamics.
[[nodiscard]] std::set<std::string> const& dispensableEffects();

/// Registers the runtime's own components and every effect, in the order in which conflicting resolvers run.
/// Of an effect in `without` only the properties are registered: levels that state them can be loaded, but
/// they have no effect. Throws std::invalid_argument for a name that is not in dispensableEffects().
void registerEverything(Registry& registry, std::set<std::string> const& without = {});

} // namespace trembler
