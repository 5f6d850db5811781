// Gravity: linear, real and by a tree, behind the same derived property.
#pragma once

namespace trembler {

class Registry;
void registerGravity(Registry& registry);

} // namespace trembler
