// The torque of a direct-current motor, against its straight line from standstill to idling.
#include "physics/motor/torque.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

namespace trembler {
namespace torque_test {
namespace {

// Equal and opposite torques on two free bodies: their relative speed changes as that of one body would.
TEST(ReducedInertia, IsTheInertiaOfARelativeRotation) {
    double const a = 0.3;
    double const b = 1.7;
    double const torque = 2.5;
    double const apart = torque / a - -torque / b; // rad/s², by Euler's law for each
    EXPECT_NEAR(torque / reducedInertia(a, b), apart, 1e-12);
    double const endless = std::numeric_limits<double>::infinity();
    EXPECT_EQ(reducedInertia(a, endless), a) << "against the world";
    EXPECT_EQ(reducedInertia(a, 0), 0);
    EXPECT_EQ(reducedInertia(endless, endless), endless);
}

TEST(MotorTorque, IsAStraightLineThatNeverOvershoots) {
    EXPECT_TRUE(rc::check([] {
        auto const number = [](int low, int high) { return *rc::gen::inRange(low, high) / 16.0; };
        ElectricMotor const motor{number(-1000, 1000), number(1, 1000), {}};
        double const inertia = number(1, 10000);
        double const speed = number(-2000, 2000);
        double const idle = motor.torque < 0 ? -motor.idleSpeed : motor.idleSpeed;
        double const torque = motorTorque(motor, speed, inertia, 1.0 / 60);
        double const after = speed + torque / inertia / 60;
        RC_ASSERT((idle - after) * (idle - speed) >= -1e-9); // never beyond
        RC_ASSERT(std::abs(torque) <= std::abs(motor.torque * (1 - speed / idle)) + 1e-9);
        if (inertia * 60 * motor.idleSpeed >= std::abs(motor.torque)) { // heavy enough to follow the line
            RC_ASSERT(std::abs(torque - motor.torque * (1 - speed / idle)) < 1e-6);
        }
    }));
}

} // namespace
} // namespace torque_test
} // namespace trembler
