// The energy added by a frame of lag between simulations, compared with the theory of delayed forces.
#include "measure/accuracy/ladders/co_simulation.hpp"
#include "puzzle/data/game_data.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::accuracy {
namespace co_simulation_test {
namespace {

constexpr double frame = 1.0 / 60; // s

// The exact growth, not the first order as in the code: for a linear oscillator a frame is a linear map of
// position and velocity, and it changes the energy by the same factor as areas. `late`: 1/s², of the force
// that is held for a frame; `own`: 1/s², of the spring, which is integrated implicitly.
double growthOfTheMap(double late, double own, int substeps) {
    double columns[2][2]{};
    for (int start = 0; start < 2; ++start) {
        double x = start == 0 ? 1 : 0;
        double v = start == 0 ? 0 : 1;
        double const held = -late * x;
        double const h = frame / substeps;
        for (int i = 0; i < substeps; ++i) {
            v = (v + h * held - h * own * x) / (1 + h * h * own);
            x += h * v;
        }
        columns[start][0] = x;
        columns[start][1] = v;
    }
    double const determinant = columns[0][0] * columns[1][1] - columns[0][1] * columns[1][0];
    double const trace = columns[0][0] + columns[1][1];
    double const turn = std::acos(trace / 2 / std::sqrt(determinant)); // the phase of a frame
    return std::pow(determinant, 6.283185307179586 / turn) - 1;
}

TEST(CoSimulation, TheTheoryIsTheFirstOrderOfTheFramesLinearMap) {
    for (int const substeps : {1, 2, 4, 8, 16}) {
        double const exact = std::log1p(growthOfTheMap(8, 1, substeps));
        double const first = std::log1p(predictedGrowth({8, 1}, substeps, 1, false));
        EXPECT_NEAR(first, exact, 0.01 * std::abs(exact) + 2e-4) << substeps;
    }
}

TEST(CoSimulation, AMagnetOnASpringGainsTheEnergyThatTheLagAdds) {
    double before = -1;
    for (int const substeps : {1, 2, 4, 8, 16}) {
        Swing const found = magnetOnSpring(gameData(), substeps, false);
        // Pushed by µ0/4π q²/r², softened, whose stiffness at 1 m is next to 2 F/r.
        double const softened = 1 + 0.05 * 0.05;
        double const late = 3.025 * (3 / softened - 1) / std::pow(softened, 1.5);
        double const expected = growthOfTheMap(late, 1, substeps);
        EXPECT_NEAR(found.growth, expected, 0.03 * std::abs(expected) + 5e-4) << substeps;
        EXPECT_NEAR(found.predicted, expected, 0.03 * std::abs(expected) + 5e-4) << substeps;
        EXPECT_GT(found.growth, before) << "more substeps reduce the damping that compensates for the lag";
        before = found.growth;
        EXPECT_EQ(found.growth < 0, substeps == 1)
            << "with one substep the spring loses more than the lag adds, with more it does not";
        Swing const ahead = magnetOnSpring(gameData(), substeps, true);
        EXPECT_NEAR(ahead.growth, ahead.predicted, 0.05 * std::abs(ahead.predicted) + 2e-3)
            << "the rest is the spring's own loss";
    }
    EXPECT_GT(before, 0.08);
}

// With n parts the map of a part replaces that of a frame: the force lags by a part, and the growth is
// smaller accordingly.
double growthInParts(double late, double own, int substeps, int parts) {
    double const share = static_cast<double>(parts);
    // The same oscillator with time counted in parts: per part, frequencies are n times lower.
    return growthOfTheMap(late / (share * share), own / (share * share), substeps / parts);
}

TEST(CoSimulation, PartsOfAFrameReduceTheLag) {
    double const softened = 1 + 0.05 * 0.05;
    double const late = 3.025 * (3 / softened - 1) / std::pow(softened, 1.5);
    double before = 0;
    for (int const parts : {1, 2, 4, 8}) {
        Swing const found = magnetOnSpring(gameData(), 16, false, parts);
        double const expected = growthInParts(late, 1, 16, parts);
        EXPECT_NEAR(found.growth, expected, 0.03 * std::abs(expected) + 5e-4) << parts;
        EXPECT_NEAR(found.predicted, expected, 0.03 * std::abs(expected) + 5e-4) << parts;
        if (parts > 1) {
            EXPECT_LT(found.growth, 0.55 * before) << "half of the lag, less the spring's own loss";
        }
        before = found.growth;
    }
}

TEST(CoSimulation, AFloatOnASpringGainsEnergyUnlessItLooksAhead) {
    for (int const substeps : {1, 4, 16}) {
        double const expected = growthOfTheMap(9.81, 1, substeps); // g over the draught
        Swing const late = floatOnSpring(gameData(), substeps, 1, false);
        EXPECT_NEAR(late.growth, expected, 0.03 * std::abs(expected) + 5e-4) << substeps;
        // The rest is the spring's own loss.
        Swing const ahead = floatOnSpring(gameData(), substeps, 1, true);
        double const spring = -1 * 2 * 3.141592653589793 / std::sqrt(10.81) * frame / substeps;
        EXPECT_NEAR(std::log1p(ahead.growth), spring, 0.1 * std::abs(spring) + 2e-3) << substeps;
        EXPECT_LT(ahead.growth, 0) << "it never increases the oscillation";
        EXPECT_EQ(late.growth < 0, substeps == 1);
    }
    for (int const period : {2, 4}) {
        // A frame of the map stands for `period` frames, with `period` times the substeps.
        Swing const late = floatOnSpring(gameData(), 4, period, false);
        double const lag = period * frame / 2 * (1 - 1.0 / (4 * period));
        double const rate = 9.81 * lag - frame / 4; // 1/s
        EXPECT_NEAR(std::log1p(late.growth), rate * 2 * 3.141592653589793 / std::sqrt(10.81), 0.05 * rate * 2)
            << period;
        Swing const ahead = floatOnSpring(gameData(), 4, period, true);
        EXPECT_LT(ahead.growth, 0) << period;
        EXPECT_LT(-ahead.growth, 0.1 * late.growth) << period;
    }
}

} // namespace
} // namespace co_simulation_test
} // namespace trembler::accuracy
