// Electricity: connections between conductors, and which objects are on because of them.
#pragma once

namespace trembler {

class Registry;

/// Registers the Electricity resolver, its detail levels (single-cable, two-wire, nodal, flow) and the
/// interactions on electricity. After dynamics.
void registerElectricity(Registry& registry);

/// Its properties, and the connections of a level, in which nothing flows: a program without electricity
/// reads every level and part.
void knowElectricity(Registry& registry);

} // namespace trembler
