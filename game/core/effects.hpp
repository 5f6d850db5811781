// Every effect that the game knows.
#pragma once

namespace trembler {

class Registry;

/// Registers the runtime's own components, physics and sound, in the order in which conflicting resolvers
/// run.
void registerEffects(Registry& registry);

} // namespace trembler
