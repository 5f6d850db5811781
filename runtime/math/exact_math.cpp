#include "runtime/math/exact_math.hpp"

#include "runtime/math/vec2.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace trembler {
namespace {

// π/2 and ln 2 as sums of numbers, the first of which have so few digits that small multiples are exact.
constexpr double halfPi1 = 0x1.921fb544p+0;
constexpr double halfPi2 = 0x1.0b4611a6p-34;
constexpr double halfPi3 = 0x1.3198a2e037073p-69;
constexpr double ln2High = 0x1.62e42feep-1;
constexpr double ln2Low = 0x1.a39ef35793c76p-33;
constexpr double piRest = 0x1.1a62633145c07p-53; // π minus the double nearest to it

// Taylor's series, which for angles up to π/4 is as good as any: the first term left out is below 1e-19.
double sinSmall(double r) {
    double const s = r * r;
    double sum = 0;
    for (int n = 17; n >= 3; n -= 2) {
        sum = -s / (n * (n - 1)) * (1 + sum);
    }
    return r + r * sum;
}
double cosSmall(double r) {
    double const s = r * r;
    double sum = 0;
    for (int n = 18; n >= 2; n -= 2) {
        sum = -s / (n * (n - 1)) * (1 + sum);
    }
    return 1 + sum;
}

struct Reduced {
    double rest;          // within π/4
    std::int64_t quarter; // multiples of π/2 that were taken away
};
Reduced reduce(double angle) {
    double const k = std::floor(angle / (pi / 2) + 0.5); // exact functions: floor, and below frexp and ldexp
    return {((angle - k * halfPi1) - k * halfPi2) - k * halfPi3, static_cast<std::int64_t>(k)};
}
double quarterSin(double r, std::int64_t quarter) {
    switch (quarter & 3) {
    case 0:
        return sinSmall(r);
    case 1:
        return cosSmall(r);
    case 2:
        return -sinSmall(r);
    default:
        return -cosSmall(r);
    }
}

// Of 0 <= t <= 1.
double atanUpToOne(double t) {
    constexpr double tan30 = 0x1.279a74590331cp-1; // 1/√3
    double base = 0;
    double x = t;
    if (t > 0.2679491924311227) { // tan 15°
        base = pi / 6;
        x = (t - tan30) / (1 + t * tan30);
    }
    double const s = x * x;
    double sum = 0;
    for (int n = 31; n >= 3; n -= 2) {
        sum = -s * (1.0 / n + sum);
    }
    return base + (x + x * sum);
}

} // namespace

double exactSin(double angle) {
    Reduced const r = reduce(angle);
    return quarterSin(r.rest, r.quarter);
}

double exactCos(double angle) {
    Reduced const r = reduce(angle);
    return quarterSin(r.rest, r.quarter + 1);
}

CosineAndSine exactTurn(double angle) {
    if (!std::isfinite(angle)) {
        double const none = std::numeric_limits<double>::quiet_NaN();
        return {none, none};
    }
    // The remainder is an exact function.
    Reduced const r = reduce(std::abs(angle) <= largestAngle ? angle : std::remainder(angle, 2 * pi));
    return {quarterSin(r.rest, r.quarter + 1), quarterSin(r.rest, r.quarter)};
}

double exactAtan2(double y, double x) {
    double const ax = std::abs(x);
    double const ay = std::abs(y);
    if (ax == 0 && ay == 0) {
        return 0;
    }
    double angle = ay <= ax ? atanUpToOne(ay / ax) : pi / 2 - (atanUpToOne(ax / ay) - piRest / 2);
    if (x < 0) {
        angle = pi - (angle - piRest);
    }
    return y < 0 ? -angle : angle;
}

double exactExp(double x) {
    if (x != x || x > 709) { // NOLINT(misc-redundant-expression): not a number
        return x > 709 ? std::numeric_limits<double>::infinity() : x;
    }
    if (x < -700) {
        return 0;
    }
    double const k = std::floor(x / (ln2High + ln2Low) + 0.5);
    double const r = (x - k * ln2High) - k * ln2Low;
    double sum = 0;
    for (int n = 14; n >= 2; --n) {
        sum = r / n * (1 + sum);
    }
    return std::ldexp(1 + (r + r * sum), static_cast<int>(k));
}

double exactLog(double x) {
    if (!(x >= 0)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (x == 0) {
        return -std::numeric_limits<double>::infinity();
    }
    if (x == std::numeric_limits<double>::infinity()) {
        return x;
    }
    int exponent = 0;
    double m = std::frexp(x, &exponent); // in [1/2, 1)
    if (m < 0.7071067811865476) {
        m *= 2;
        --exponent;
    }
    double const f = m - 1;
    double const s = f / (2 + f);
    double const s2 = s * s;
    double sum = 0;
    for (int n = 23; n >= 3; n -= 2) {
        sum = s2 * (1.0 / n + sum);
    }
    // log m = 2 s + 2 s sum, and 2 s = f - s f, whose first term has no rounding.
    double const k = exponent;
    return k * ln2High + (f - (s * f - (2 * s * sum + k * ln2Low)));
}

} // namespace trembler
