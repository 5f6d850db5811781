// Electricity: connections between conductors, and the objects that they switch on.
#pragma once

namespace trembler {

class Registry;

/// Registers the Electricity resolver, its detail levels (single-cable, two-wire, nodal, flow) and the
/// interactions on electricity. After dynamics.
void registerElectricity(Registry& registry);

} // namespace trembler
