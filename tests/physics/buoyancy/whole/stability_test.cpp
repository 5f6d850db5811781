// Heel, stability and the small oscillations of floating boxes, against the naval architect's formulas.
#include "physics/dynamics/properties/solver_choice.hpp"
#include "tests/physics/buoyancy/pool.hpp"

#include <gtest/gtest.h>

#include <array>

namespace trembler::test {
namespace {

constexpr double g = 9.81;

// A box of beam b, height h and relative density r: the metacentre's height above its centre of mass,
// GM = KB + BM - KG = T/2 + b²/12T - h/2 with the draught T = r h.
double metacentricHeight(double b, double h, double r) {
    double const draught = r * h;
    return draught / 2 + b * b / (12 * draught) - h / 2;
}

TEST(Stability, AnEccentricLoadHeelsABoxByTheWallSidedFormula) {
    // A small dense weight is fastened to the deck, out of the water. While neither deck nor bottom crosses
    // the surface, the righting arm is sin a (GM + BM/2 tan² a), and the heeling arm is the common centre of
    // mass's distance from the middle times cos a.
    double const beam = 0.8;
    double const height = 0.24;
    double const side = 0.06;
    for (double const offset : {0.05, 0.12, -0.2}) {
        Liquid calm;
        calm.linearDrag = 4;
        Pool pool;
        pool.water(calm);
        ObjectId const box = pool.body("box", boxPiece(beam, height), {0, 0}, 400);
        ObjectId const weight =
            pool.body("weight", boxPiece(side, side), {offset, height / 2 + side / 2}, 8000);
        Joint weld;
        weld.form = JointForm::weld;
        weld.a = box;
        weld.b = weight;
        weld.at = {offset, height / 2};
        pool.joint("weld", weld);
        pool.seconds(30);
        double const m = pool.mass(box);
        double const w = pool.mass(weight);
        double const total = m + w;
        double const draught = total / (1000 * worldDepth * beam);
        double const keelToMass = (m * height / 2 + w * (height + side / 2)) / total;
        double const aside = w * offset / total;
        double const bm = beam * beam / (12 * draught);
        double const gm = draught / 2 + bm - keelToMass;
        double low = -0.5;
        double high = 0.5;
        for (int i = 0; i < 100; ++i) {
            double const a = (low + high) / 2;
            double const righting = std::sin(a) * (gm + bm / 2 * std::tan(a) * std::tan(a));
            (righting < aside * std::cos(a) ? low : high) = a;
        }
        ASSERT_LT(beam / 2 * std::tan(std::abs(low)), std::min(draught, height - draught)) << "wall-sided";
        ASSERT_GT(std::abs(low), 0.03) << "the heel must be large enough to measure";
        EXPECT_NEAR(pool.angle(box), -low, 0.01 * std::abs(low)) << offset;
    }
}

struct Oscillation {
    double period = 0;
    double growth = 0; // of the amplitude, from the first to the last quarter
};

// The period follows from the crossings of the mean, with linear interpolation; the growth from the extremes.
Oscillation oscillationOf(std::vector<double> const& values) {
    double mean = 0;
    for (double const value : values) {
        mean += value / static_cast<double>(values.size());
    }
    std::vector<double> crossings;
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (values[i - 1] < mean && values[i] >= mean) {
            crossings.push_back(static_cast<double>(i) - (values[i] - mean) / (values[i] - values[i - 1]));
        }
    }
    auto const extent = [&](std::size_t from, std::size_t to) {
        auto const [low, high] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(from),
                                                     values.begin() + static_cast<std::ptrdiff_t>(to));
        return *high - *low;
    };
    std::size_t const quarter = values.size() / 4;
    return {(crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1) / 60,
            extent(3 * quarter, values.size()) / extent(0, quarter)};
}

Liquid const ideal{.linearDrag = 0, .quadraticDrag = 0, .current = {}};

Pool::Options wakeful() {
    Pool::Options options;
    options.solver.sleeping = false;
    return options;
}

TEST(Stability, SmallHeaveHasThePeriodOfItsDraught) {
    // ω² = ρ g b d / m = g / T for bodies with vertical sides.
    for (double const ratio : {0.2, 0.5, 0.8}) {
        double const height = 0.3;
        Pool pool(wakeful());
        pool.water(ideal);
        ObjectId const box =
            pool.body("box", boxPiece(0.9, height), {0, height / 2 - ratio * height + 0.02}, 1000 * ratio);
        std::vector<double> heights;
        for (int frame = 0; frame < 1200; ++frame) {
            pool.run(1);
            heights.push_back(pool.at(box).y);
        }
        Oscillation const found = oscillationOf(heights);
        EXPECT_NEAR(found.period / (2 * pi * std::sqrt(ratio * height / g)), 1, 0.005) << ratio;
        EXPECT_NEAR(found.growth, 1, 0.05) << ratio;
    }
}

TEST(Stability, SmallRollHasThePeriodOfItsMetacentricHeight) {
    // ω² = Δ g GM / I with I = m (b² + h²) / 12.
    for (double const ratio : {0.3, 0.5, 0.7}) {
        double const beam = 0.9;
        double const height = 0.3;
        Pool pool(wakeful());
        pool.water(ideal);
        ObjectId const box =
            pool.body("box", boxPiece(beam, height), {0, height / 2 - ratio * height}, 1000 * ratio, 0.03);
        std::vector<double> angles;
        for (int frame = 0; frame < 1200; ++frame) {
            pool.run(1);
            angles.push_back(pool.angle(box));
        }
        Oscillation const found = oscillationOf(angles);
        double const inertia = (beam * beam + height * height) / 12;
        double const expected = 2 * pi * std::sqrt(inertia / (g * metacentricHeight(beam, height, ratio)));
        EXPECT_NEAR(found.period / expected, 1, 0.01) << ratio;
        EXPECT_NEAR(found.growth, 1, 0.08) << ratio;
    }
}

TEST(Stability, OscillationsGrowUnlessForcesLookAhead) {
    // A force that is held for n frames (the time t) lags by half of that, so the heave grows at a rate of ω²
    // t / 4 (1 - 1/N), with N substeps in the time t.
    constexpr int substeps = 4;
    for (int const period : {1, 2, 4}) {
        std::array<double, 2> growth{};
        for (bool const ahead : {false, true}) {
            Pool::Options options = wakeful();
            options.engine = "box2d"; // by the semi-implicit Euler method
            options.buoyancy.lookAhead = ahead;
            options.period = period;
            options.solver.substeps = substeps; // else it would get one step for the time of the force
            Pool pool(options);
            pool.water(ideal);
            ObjectId const box = pool.body("box", boxPiece(0.9, 0.6), {0, 0.004}, 500);
            std::vector<double> heights;
            for (int frame = 0; frame < 480; ++frame) {
                pool.run(1);
                heights.push_back(pool.at(box).y);
            }
            growth[ahead ? 1 : 0] = oscillationOf(heights).growth;
        }
        double const steps = period * substeps;
        double const rate = g / 0.3 * period / 60.0 / 4 * (1 - 1 / steps);
        double const expected = std::exp(rate * 6); // from the first to the last quarter of 8 s
        EXPECT_NEAR(std::log(growth[0]) / std::log(expected), 1, 0.15) << period;
        EXPECT_NEAR(growth[1], 1, 0.15) << period;
    }
}

TEST(Stability, ATallNarrowBodyFallsOver) {
    // GM is negative: it must end on one of its sides.
    ASSERT_LT(metacentricHeight(0.2, 0.8, 0.5), 0);
    for (double const tilt : {0.01, -0.01}) {
        Pool pool;
        pool.water();
        ObjectId const box = pool.body("box", boxPiece(0.2, 0.8), {0, 0}, 500, tilt);
        pool.seconds(30);
        EXPECT_NEAR(std::abs(pool.angle(box)), pi / 2, 0.01);
        EXPECT_EQ(pool.angle(box) > 0, tilt > 0);
        EXPECT_NEAR(pool.at(box).y, 0, 1e-3);
    }
}

TEST(Stability, ASquareLogFloatsTilted) {
    // The classical case: a square log of relative density 1/2 is unstable with level sides and floats on its
    // edge, turned by 45 degrees; one of relative density 0.1 stays level (GM = a (1/(12 r) - (1 - r)/2) >
    // 0).
    Pool pool;
    pool.water();
    ObjectId const half = pool.body("half", boxPiece(0.4, 0.4), {0, 0}, 500, 0.02);
    ObjectId const light = pool.body("light", boxPiece(0.4, 0.4), {3, 0.1}, 100, 0.1);
    pool.seconds(40);
    EXPECT_NEAR(std::abs(pool.angle(half)), pi / 4, 0.01);
    EXPECT_NEAR(pool.angle(light), 0, 0.01);
}

TEST(Stability, AnOverturnedHullRightsItself) {
    // A hull with a keel of lead, put upside down.
    Pool pool;
    pool.water();
    ObjectId const hull = pool.body(
        "hull", polygonPiece({{-0.3, -0.15}, {0.3, -0.15}, {0.5, 0.15}, {-0.5, 0.15}}), {0, 0.3}, 300, 3);
    ObjectId const keel =
        pool.body("keel", boxPiece(0.3, 0.06), rotated({0, -0.18}, 3) + Vec2{0, 0.3}, 8000, 3);
    Joint weld;
    weld.form = JointForm::weld;
    weld.a = hull;
    weld.b = keel;
    weld.at = rotated({0, -0.15}, 3) + Vec2{0, 0.3};
    pool.joint("weld", weld);
    pool.seconds(40);
    EXPECT_NEAR(std::remainder(pool.angle(hull), 2 * pi), 0, 0.02);
    EXPECT_LT(pool.at(keel).y, pool.at(hull).y - 0.1);
    double const weight = (pool.mass(hull) + pool.mass(keel)) * g;
    EXPECT_NEAR((pool.force(hull) + pool.force(keel)).y / weight, 1, 1e-2);
}

} // namespace
} // namespace trembler::test
