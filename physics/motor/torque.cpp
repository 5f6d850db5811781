#include "physics/motor/torque.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

namespace {

// N m s: the decrease of the torque per speed.
double slopeOf(ElectricMotor const& motor, double inertia, double step) {
    return std::min(std::abs(motor.torque) / motor.idleSpeed, inertia / step);
}

} // namespace

double reducedInertia(double a, double b) {
    return 1 / (1 / a + 1 / b);
}

double motorTorque(ElectricMotor const& motor, double speed, double inertia, double step) {
    if (!(motor.idleSpeed > 0)) {
        return motor.torque;
    }
    return slopeOf(motor, inertia, step) * (std::copysign(motor.idleSpeed, motor.torque) - speed);
}

double motorRate(ElectricMotor const& motor, double inertia, double step) {
    return motor.idleSpeed > 0 && inertia > 0 ? slopeOf(motor, inertia, step) / inertia : 0;
}

double brakingTorque(Generator const& generator, double speed, double inertia, double step) {
    double const most = std::min(generator.braking, inertia * std::abs(speed) / step);
    return -std::copysign(most, speed);
}

} // namespace trembler
