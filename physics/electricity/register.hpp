// Electricity: connections between conductors, and which objects are on because of them.
#pragma once

namespace trembler {

class Registry;

/// Registers the Electricity resolver, its detail levels (single-cable, two-wire, nodal, flow) and the
/// interactions on electricity. After dynamics.
void registerElectricity(Registry& registry);

} // namespace trembler
