#include "audio/effect/core/mode_shapes.hpp"

#include "runtime/math/vec2.hpp"

#include <cmath>

namespace trembler {

namespace {

/// The terms of the shape of a bar's mode, apart from the place along it.
struct BarMode {
    double root = 0;
    double sigma = 0;   // of cosh βx + cos βx - σ (sinh βx + sin βx)
    double growing = 0; // (1 - σ) e^β / 2
};

BarMode barMode(int n) {
    BarMode mode;
    mode.root = (n + 0.5) * pi;   // the limit for high n, off by 2 in 1000 for the first
    for (int i = 0; i < 4; ++i) { // Newton
        double const sech = 1 / std::cosh(mode.root);
        mode.root -= (std::cos(mode.root) - sech) / (-std::sin(mode.root) + sech * std::tanh(mode.root));
    }
    double const decay = std::exp(-mode.root);
    mode.growing = (-decay + std::cos(mode.root) - std::sin(mode.root)) /
                   (1 - decay * decay - 2 * decay * std::sin(mode.root));
    mode.sigma = 1 - 2 * decay * mode.growing;
    return mode;
}

// A cache, as impacts need the low modes very often.
BarMode knownBarMode(int n) {
    constexpr int known = 64;
    static std::array<BarMode, known> const table = [] {
        std::array<BarMode, known> made;
        for (int i = 1; i < known; ++i) {
            made[static_cast<std::size_t>(i)] = barMode(i);
        }
        return made;
    }();
    return n < known ? table[static_cast<std::size_t>(n)] : barMode(n);
}

} // namespace

double barRoot(int n) {
    return knownBarMode(n).root;
}

// Terms are arranged so that no two large numbers are subtracted.
double barShape(int n, double x) {
    BarMode const mode = knownBarMode(n);
    return std::cos(mode.root * x) - mode.sigma * std::sin(mode.root * x) +
           (1 + mode.sigma) / 2 * std::exp(-mode.root * x) + mode.growing * std::exp(mode.root * (x - 1));
}

double plateFactor(int m, int n, double a, double b, double poissonRatio) {
    struct Coefficients {
        double g;
        double h;
        double j;
    };
    auto const coefficients = [](int lines) -> Coefficients {
        switch (lines) {
        case 0:
            return {0, 0, 0};
        case 1:
            return {0, 0, 12 / (pi * pi)};
        case 2:
            return {1.506, 1.248, 5.017};
        default: {
            double const g = lines - 0.5;
            return {g, g * g * (1 - 2 / (g * pi)), g * g * (1 + 6 / (g * pi))};
        }
        }
    };
    Coefficients const x = coefficients(m);
    Coefficients const y = coefficients(n);
    double const alongX = x.g * x.g / (a * a);
    double const alongY = y.g * y.g / (b * b);
    double const both = 2 / (a * a * b * b) * (poissonRatio * x.h * y.h + (1 - poissonRatio) * x.j * y.j);
    return std::sqrt(alongX * alongX + alongY * alongY + both);
}

double plateShape(int n, double x) {
    switch (n) {
    case 0:
        return 1;
    case 1:
        return std::sqrt(3.0) * (2 * x - 1);
    default:
        return barShape(n - 1, x);
    }
}

std::span<BallMode const> ballModes() {
    static constexpr std::array<BallMode, 32> modes{
        {{2.6462, 2},  {3.5300, 1},   {3.9374, 3},  {4.9955, 0},   {5.0070, 2},  {5.0459, 4},  {6.0834, 5},
         {6.6086, 3},  {7.0865, 6},   {7.1011, 1},  {8.0703, 7},   {8.0773, 1},  {8.2147, 4},  {8.5272, 2},
         {9.0418, 8},  {9.7772, 5},   {9.8823, 3},  {10.0052, 9},  {10.3759, 2}, {10.7144, 1}, {10.9628, 10},
         {11.2250, 4}, {11.2773, 6},  {11.3971, 0}, {11.9160, 11}, {12.2136, 2}, {12.4277, 3}, {12.5744, 5},
         {12.7096, 7}, {12.8658, 12}, {13.7920, 1}, {13.8017, 3}}};
    return modes;
}

std::span<BellPartial const> bellPartials() {
    static constexpr std::array<BellPartial, 16> partials{{{0.5, 0.8},
                                                           {1, 0.7},
                                                           {1.2, 1},
                                                           {1.5, 0.4},
                                                           {2, 1.2},
                                                           {2.5, 0.3},
                                                           {2.667, 0.5},
                                                           {3, 1},
                                                           {3.333, 0.3},
                                                           {4, 0.9},
                                                           {5.333, 0.7},
                                                           {6.667, 0.6},
                                                           {8, 0.5},
                                                           {9.333, 0.4},
                                                           {10.667, 0.3},
                                                           {12, 0.25}}};
    return partials;
}

} // namespace trembler
