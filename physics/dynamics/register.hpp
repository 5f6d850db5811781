// Rigid bodies, joints and contacts.
#pragma once

namespace trembler {

class Registry;

/// Registers properties, rules for files, completions and components of Dynamics.
void registerDynamics(Registry& registry);

} // namespace trembler
