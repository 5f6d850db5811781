#include "audio/effect/core/rubbing.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace trembler {
namespace {

TEST(Rubbing, SpeedIsThatOfSlidingOrElseThatOfRolling) {
    EXPECT_EQ(rubbingSpeed(1.5, 0.3), 1.5) << "a body that slides and rolls counts as sliding";
    EXPECT_EQ(rubbingSpeed(0.01, 0.3), 0.3);
    EXPECT_EQ(rubbingSpeed(0, 0.3), 0.3);
    EXPECT_EQ(rubbingSpeed(0.01, 0.01), 0);
    EXPECT_EQ(rubbingSpeed(0, 0), 0);
    double const nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(rubbingSpeed(nan, nan), 0) << "a body with invalid velocities makes no noise";
}

// A steel block of 2 kg that slides on steel (μ = 0.4) is braked by Coulomb's friction of 7.85 N.
TEST(Rubbing, ForceIsAShareOfCoulombsFrictionOrOfTheRollingLoad) {
    double const load = 2 * 9.81;
    EXPECT_NEAR(rubbingForce(load, 1, 0.4), 0.785, 0.001);
    EXPECT_NEAR(rubbingForce(load, 3, 0.4), 0.785, 0.001)
        << "Coulomb's friction does not depend on the speed";
    EXPECT_NEAR(rubbingForce(load, 0, 0.4), 0.589, 0.001);
    EXPECT_EQ(rubbingForce(load, 0, 0.4), rubbingForce(load, 0, 0))
        << "rolling noise does not depend on friction";
    EXPECT_EQ(rubbingForce(load, 1, 0), 0);
}

} // namespace
} // namespace trembler
