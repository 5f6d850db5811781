// Magnetism: magnets, electromagnets and the objects that they attract.
#pragma once

namespace trembler {

class Registry;
void registerMagnetism(Registry& registry);

} // namespace trembler
