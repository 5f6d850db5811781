#include "physics/motor/torque.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

double motorTorque(ElectricMotor const& motor, double speed, double inertia, double step) {
    if (!(motor.idleSpeed > 0)) {
        return motor.torque;
    }
    double const slope = std::min(std::abs(motor.torque) / motor.idleSpeed, inertia / step);
    return slope * (std::copysign(motor.idleSpeed, motor.torque) - speed);
}

double brakingTorque(Generator const& generator, double speed, double inertia, double step) {
    double const most = std::min(generator.braking, inertia * std::abs(speed) / step);
    return -std::copysign(most, speed);
}

} // namespace trembler
