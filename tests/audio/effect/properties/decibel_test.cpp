// Sound levels, and the A-weighting of the standard.
#include "audio/effect/properties/decibel.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

namespace trembler {
namespace {

TEST(Decibel, LevelsAreThoseOfTheirDefinition) {
    EXPECT_NEAR(levelOf(1), 93.979, 1e-3) << "1 Pa";
    EXPECT_NEAR(levelOf(20e-6 * 20e-6), 0, 1e-9) << "the reference pressure";
    EXPECT_NEAR(levelOf(0.2 * 0.2), 80, 1e-9) << "10000 times the reference pressure";
    // Twice the power is 3.01 dB more, twice the pressure 6.02 dB.
    EXPECT_NEAR(powerOf(3.0103), 2, 1e-5);
    EXPECT_NEAR(std::sqrt(powerOf(6.0206)), 2, 1e-5);
    EXPECT_EQ(powerOf(0), 1);
    for (int bels = -12; bels <= 14; ++bels) {
        double const power = std::pow(10.0, bels);
        EXPECT_NEAR(powerOf(10.0 * bels), power, 1e-12 * power);
    }
}

TEST(Decibel, LevelAndMeanSquareAreInverse) {
    EXPECT_TRUE(rc::check("levelOf and meanSquareOf", [] {
        double const level = *rc::gen::inRange(-119'999, 200'001) / 1000.0;
        RC_ASSERT(std::abs(levelOf(meanSquareOf(level)) - level) < 1e-9);
        double const meanSquare = std::pow(10.0, *rc::gen::inRange(-20'000, 8'001) / 1000.0); // Pa²
        RC_ASSERT(std::abs(meanSquareOf(levelOf(meanSquare)) / meanSquare - 1) < 1e-9);
    }));
}

TEST(Decibel, NothingIsQuieterThanSilence) {
    EXPECT_EQ(levelOf(0), silentLevel);
    EXPECT_EQ(levelOf(-1), silentLevel) << "rounding may leave a sum of powers below zero";
    EXPECT_EQ(levelOf(std::numeric_limits<double>::denorm_min()), silentLevel);
    EXPECT_EQ(levelOf(std::numeric_limits<double>::quiet_NaN()), silentLevel);
    EXPECT_EQ(levelOf(meanSquareOf(silentLevel - 1)), silentLevel);
    EXPECT_GT(levelOf(meanSquareOf(silentLevel + 1)), silentLevel);
}

TEST(Decibel, WeightsAreThoseOfTheStandard) {
    // IEC 61672-1:2013, Table 3: from 10 Hz to 20 kHz in thirds of an octave, in tenths of a decibel. The
    // frequencies are the exact ones, 1 kHz times powers of the tenth root of 10.
    double const table[] = {-70.4, -63.4, -56.7, -50.5, -44.7, -39.4, -34.6, -30.2, -26.2,
                            -22.5, -19.1, -16.1, -13.4, -10.9, -8.6,  -6.6,  -4.8,  -3.2,
                            -1.9,  -0.8,  0.0,   0.6,   1.0,   1.2,   1.3,   1.2,   1.0,
                            0.5,   -0.1,  -1.1,  -2.5,  -4.3,  -6.6,  -9.3};
    int tenths = -20;
    for (double const decibels : table) {
        double const frequency = 1000 * std::pow(10.0, tenths / 10.0);
        EXPECT_NEAR(10 * std::log10(aWeighting(frequency)), decibels, 0.051) << frequency << " Hz";
        ++tenths;
    }
    EXPECT_EQ(tenths, 14) << "the last one was 20 kHz";
    EXPECT_EQ(aWeighting(0), 0);
}

} // namespace
} // namespace trembler
