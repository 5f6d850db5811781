// Every effect of physics that the program knows: one line each.
#pragma once

#include <set>
#include <string>

namespace trembler {

class Registry;

/// The effects that a world may do without: all but dynamics.
[[nodiscard]] std::set<std::string> const& dispensableEffects();

/// Registers the runtime's own components and every effect, in the order in which conflicting resolvers run.
/// Of an effect in `without` only the properties are known: levels that state them load, and nothing comes of
/// it. Throws std::invalid_argument for a name that is not in dispensableEffects().
void registerEverything(Registry& registry, std::set<std::string> const& without = {});

} // namespace trembler
