#include "runtime/math/exact_math.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace trembler {
namespace {

// In units in the last place, against the C library's functions of long double.
double error(double got, long double exact) {
    double const near = std::abs(static_cast<double>(exact));
    double const unit = std::nextafter(near, std::numeric_limits<double>::infinity()) - near;
    return static_cast<double>(std::fabs(static_cast<long double>(got) - exact)) / unit;
}

TEST(ExactMath, IsAsExactAsItSays) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> small(-30, 30);
    std::uniform_real_distribution<double> large(-largestAngle, largestAngle);
    for (int i = 0; i < 100'000; ++i) {
        double const a = small(random);
        double const b = small(random);
        double const far = large(random);
        ASSERT_LT(error(exactSin(a), std::sin(static_cast<long double>(a))), 2) << a;
        ASSERT_LT(error(exactCos(a), std::cos(static_cast<long double>(a))), 2) << a;
        ASSERT_LT(std::fabs(exactSin(far) - std::sin(static_cast<long double>(far))), 2e-16L) << far;
        ASSERT_LT(std::fabs(exactCos(far) - std::cos(static_cast<long double>(far))), 2e-16L) << far;
        ASSERT_LT(
            error(exactAtan2(a, b), std::atan2(static_cast<long double>(a), static_cast<long double>(b))), 3)
            << a << " " << b;
        ASSERT_LT(error(exactExp(20 * a), std::exp(static_cast<long double>(20 * a))), 2) << 20 * a;
        double const positive = std::exp(20 * b);
        ASSERT_LT(error(exactLog(positive), std::log(static_cast<long double>(positive))), 2) << positive;
    }
}

TEST(ExactMath, TurnsByAnyAngle) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> any(-largestAngle, largestAngle);
    for (int i = 0; i < 10'000; ++i) {
        double const a = any(random);
        ASSERT_EQ(exactTurn(a).sine, exactSin(a)) << a;
        ASSERT_EQ(exactTurn(a).cosine, exactCos(a)) << a;
    }
    for (double const huge : {1e7, -3e12, 1.7e308}) {
        CosineAndSine const turn = exactTurn(huge);
        EXPECT_NEAR(turn.cosine * turn.cosine + turn.sine * turn.sine, 1, 1e-15) << huge;
    }
    // Whole turns of the double nearest to 2π, 2.4e-16 short of the circle, are taken away beyond the limit.
    EXPECT_NEAR(exactTurn(1e7).sine, std::sin(1e7L), 1e7 * 2.4e-16);
    EXPECT_TRUE(std::isnan(exactTurn(std::numeric_limits<double>::infinity()).cosine));
    EXPECT_TRUE(std::isnan(exactTurn(std::numeric_limits<double>::quiet_NaN()).sine));
}

TEST(ExactMath, HasTheValuesThatHaveNoRounding) {
    double const infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(exactSin(0), 0);
    EXPECT_EQ(exactCos(0), 1);
    EXPECT_EQ(exactAtan2(0, 0), 0);
    EXPECT_EQ(exactAtan2(0, 1), 0);
    EXPECT_EQ(exactAtan2(0, -1), 0x1.921fb54442d18p+1);
    EXPECT_EQ(exactAtan2(1, 0), 0x1.921fb54442d18p+0);
    EXPECT_EQ(exactExp(0), 1);
    EXPECT_EQ(exactExp(1000), infinity);
    EXPECT_EQ(exactExp(-1000), 0);
    EXPECT_EQ(exactLog(1), 0);
    EXPECT_EQ(exactLog(0), -infinity);
    EXPECT_TRUE(std::isnan(exactLog(-1)));
}

} // namespace
} // namespace trembler
