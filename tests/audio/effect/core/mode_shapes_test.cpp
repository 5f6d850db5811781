// Modes of bars, plates and balls against the equations that they must fulfil, and against published tables.
#include "audio/effect/core/mode_shapes.hpp"
#include "runtime/math/vec2.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace trembler {
namespace {

double integral(std::function<double(double)> const& f, double from, double to, int steps = 4000) {
    double sum = 0; // Simpson
    double const h = (to - from) / steps;
    for (int i = 0; i <= steps; ++i) {
        sum += f(from + i * h) * (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2);
    }
    return sum * h / 3;
}

TEST(BarModes, RootsSolveTheFrequencyEquation) {
    double const published[] = {4.73004074, 7.85320462, 10.9956079, 14.1371655, 17.2787597};
    for (int n = 1; n <= 5; ++n) {
        EXPECT_NEAR(barRoot(n), published[n - 1], 1e-6);
        EXPECT_NEAR(std::cos(barRoot(n)) * std::cosh(barRoot(n)), 1, 1e-6 * std::cosh(barRoot(n)));
    }
    for (int n = 6; n <= 200; ++n) {
        EXPECT_NEAR(barRoot(n), (n + 0.5) * pi, 1e-6);
    }
}

TEST(BarModes, ShapesAreFreeAtTheEndsOrthogonalAndOfUnitMeanSquare) {
    for (int n = 1; n <= 12; ++n) {
        auto const shape = [n](double x) { return barShape(n, x); };
        EXPECT_NEAR(integral([&](double x) { return shape(x) * shape(x); }, 0, 1), 1, 1e-6) << n;
        EXPECT_NEAR(shape(0), 2, 1e-9) << n;
        EXPECT_NEAR(std::abs(shape(1)), 2, 1e-9) << n;
        // Free vibration neither moves nor turns the bar as a whole.
        EXPECT_NEAR(integral(shape, 0, 1), 0, 1e-6) << n;
        EXPECT_NEAR(integral([&](double x) { return x * shape(x); }, 0, 1), 0, 1e-6) << n;
        for (int m = 1; m < n; ++m) {
            EXPECT_NEAR(integral([&](double x) { return shape(x) * barShape(m, x); }, 0, 1), 0, 1e-5)
                << m << " and " << n;
        }
    }
    EXPECT_NEAR(std::abs(barShape(1000, 1)), 2, 1e-9) << "stays finite and exact";
    // Nodes of the first mode at 22.4 % from either end, where a xylophone's bars lie.
    EXPECT_LT(std::abs(barShape(1, 0.2242)), 0.002);
}

TEST(PlateModes, AgreeWithLeissasTableForASquare) {
    // Leissa, Vibration of Plates (1969), free square plate, Poisson ratio 0.3: ω a² sqrt(ρ t / D).
    auto const factor = [](int m, int n) { return pi * pi * plateFactor(m, n, 1, 1, 0.3); };
    EXPECT_NEAR(factor(1, 1), 13.489, 0.15 * 13.489);
    EXPECT_NEAR(factor(2, 0), (19.789 + 24.432) / 2, 0.15 * 22); // the pair that couples
    EXPECT_NEAR(factor(2, 1), 35.024, 0.15 * 35.024);
    // Very long plates are bars: (β/π)².
    EXPECT_NEAR(plateFactor(2, 0, 1, 0.01, 0.3), std::pow(barRoot(1) / pi, 2), 0.01);
    EXPECT_NEAR(plateFactor(5, 0, 1, 0.01, 0.3), std::pow(barRoot(4) / pi, 2), 0.01);
}

// Spherical Bessel function of the first kind, by its power series.
double besselJ(int l, double x) {
    double front = 1;
    for (int k = 1; k <= l; ++k) {
        front *= x / (2 * k + 1);
    }
    double sum = 0;
    double term = 1;
    for (int k = 1; k < 200; ++k) {
        sum += term;
        term *= -(x * x / 2) / (k * (2.0 * l + 2 * k + 1));
    }
    return front * sum;
}
// Lamb's equation of the spheroidal modes: the surface is free of stress where it is zero.
double surfaceStress(int l, double x, double poisson) {
    double const y = x * std::sqrt((1 - 2 * poisson) / (2 - 2 * poisson));
    double const t11 = (l * (l - 1) - x * x / 2) * besselJ(l, y) + 2 * y * besselJ(l + 1, y);
    if (l == 0) {
        return t11;
    }
    double const t13 = l * (l + 1) * ((l - 1) * besselJ(l, x) - x * besselJ(l + 1, x));
    double const t41 = (l - 1) * besselJ(l, y) - y * besselJ(l + 1, y);
    double const t43 = (l * l - 1 - x * x / 2) * besselJ(l, x) + x * besselJ(l + 1, x);
    return t11 * t43 - t41 * t13;
}

TEST(BallModes, AreTheRootsOfLambsEquation) {
    double before = 0;
    for (BallMode const& mode : ballModes()) {
        double const below = surfaceStress(mode.degree, mode.root - 2e-4, 0.3);
        double const above = surfaceStress(mode.degree, mode.root + 2e-4, 0.3);
        EXPECT_LT(below * above, 0) << "a root near " << mode.root << " of degree " << mode.degree;
        EXPECT_GT(mode.root, before);
        before = mode.root;
    }
    // No root is missing: count the sign changes up to the last one.
    int roots = 0;
    for (int degree = 0; degree <= 14; ++degree) {
        for (double x = 0.5; x < before + 1e-3; x += 1e-3) {
            roots += surfaceStress(degree, x, 0.3) * surfaceStress(degree, x + 1e-3, 0.3) < 0 ? 1 : 0;
        }
    }
    EXPECT_EQ(roots, static_cast<int>(ballModes().size()));
}

} // namespace
} // namespace trembler
