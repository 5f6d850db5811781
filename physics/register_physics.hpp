// Every effect that the program knows: one line each.
#pragma once

namespace trembler {

class Registry;

/// Registers the runtime's own components and every effect, in the order in which conflicting resolvers run.
void registerEverything(Registry& registry);

} // namespace trembler
