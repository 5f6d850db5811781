// Electricity: connections between conductors, and who is on because of them.
#pragma once

namespace trembler {

class Registry;

/// Registers the Electricity resolver, the single-cable and two-wire detail levels and the interactions on
/// electricity. After dynamics.
void registerElectricity(Registry& registry);

} // namespace trembler
