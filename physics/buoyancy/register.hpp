// Buoyancy: liquids lift and slow down the objects in them.
#pragma once

namespace trembler {

class Registry;
void registerBuoyancy(Registry& registry);

} // namespace trembler
