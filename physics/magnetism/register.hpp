// Magnetism: magnets, electromagnets and what they attract.
#pragma once

namespace trembler {

class Registry;
void registerMagnetism(Registry& registry);

} // namespace trembler
