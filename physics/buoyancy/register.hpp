// Buoyancy: liquids lift and slow down what is in them.
#pragma once

namespace trembler {

class Registry;
void registerBuoyancy(Registry& registry);

} // namespace trembler
