// Electric motors and generators as properties.
#pragma once

namespace trembler {

class Registry;
void registerMotors(Registry& registry);

} // namespace trembler
