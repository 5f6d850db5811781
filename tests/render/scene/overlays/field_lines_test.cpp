// Magnetic field lines compared with their known properties.
#include "physics/magnetism/magnetic_forces.hpp"
#include "render/scene/overlays/field_lines.hpp"
#include "render/scene/overlays/overlay_magnetism.hpp"
#include "tests/render/scene/scene_stage.hpp"

#include <numbers>

namespace trembler::render::test {
namespace {

Extent square(double half) {
    Extent extent;
    extent.add(Point{-half, -half});
    extent.add(Point{half, half});
    return extent;
}

TEST(FieldLines, FieldIsTheForceOnAUnitPole) {
    std::vector<FieldPole> const poles{{{-0.4, 0.1}, 3e4}, {{0.5, -0.2}, -1e4}, {{0.1, 0.9}, 2e4}};
    for (Vec2 const at : {Vec2{0, 0}, Vec2{1, 2}, Vec2{-0.4, 0.13}, Vec2{0.5, -0.2}}) {
        Vec2 expected;
        for (FieldPole const& pole : poles) {
            expected += poleForce(Vec2{pole.at.x, pole.at.y} - at, 1, pole.strength);
        }
        Point const field = fieldAt(poles, toPoint(at));
        EXPECT_NEAR(magneticConstant * field.x, expected.x, 1e-12 + 1e-9 * std::abs(expected.x));
        EXPECT_NEAR(magneticConstant * field.y, expected.y, 1e-12 + 1e-9 * std::abs(expected.y));
    }
}

TEST(FieldLines, FollowTheStreamFunctionOfTwoPoles) {
    // Of point poles on the x axis, sum(q cos(angle to the axis)) is constant along a line (axial symmetry).
    std::vector<FieldPole> const poles{{{-0.5, 0}, 2}, {{0.5, 0}, -1}};
    auto const stream = [&](Point p) {
        double sum = 0;
        for (FieldPole const& pole : poles) {
            Point const r = p - pole.at;
            sum += pole.strength * r.x / length(r);
        }
        return sum;
    };
    auto const lines = fieldLines(poles, square(4), {.linesPerPole = 12, .softening = 0, .step = 0.01});
    ASSERT_GE(lines.size(), 12U);
    for (auto const& line : lines) {
        ASSERT_GT(line.size(), 20U);
        double const first = stream(line[3]);
        for (std::size_t i = 3; i + 3 < line.size(); ++i) {
            ASSERT_NEAR(stream(line[i]), first, 2e-4);
        }
    }
}

TEST(FieldLines, RunFromNorthToSouthOrAway) {
    std::vector<FieldPole> const poles{{{-0.5, 0}, 1}, {{0.5, 0}, -1}};
    auto const lines = fieldLines(poles, square(6));
    int arrived = 0;
    for (auto const& line : lines) {
        bool const ends = line.back() == poles[1].at;
        arrived += ends && line.front() == poles[0].at ? 1 : 0;
        for (std::size_t i = 2; i + 2 < line.size(); ++i) { // always along the field
            Point const field = fieldAt(poles, line[i]);
            ASSERT_GT(dot(field, line[i + 1] - line[i]), 0);
        }
    }
    EXPECT_GE(arrived, 10);
}

TEST(FieldLines, OfOnePoleAreStraight) {
    std::vector<FieldPole> const pole{{{1, 2}, 5}};
    auto const lines = fieldLines(pole, square(5), {.linesPerPole = 8});
    ASSERT_EQ(lines.size(), 8U);
    for (auto const& line : lines) {
        Point const along = line.back() - line.front();
        for (Point const at : line) {
            Point const from = at - line.front();
            EXPECT_NEAR(along.x * from.y - along.y * from.x, 0, 1e-9);
        }
        EXPECT_GT(std::max(std::abs(line.back().x), std::abs(line.back().y)), 5 - 1e-9);
    }
}

TEST(FieldLines, ASouthPoleAloneHasLinesThatComeIn) {
    auto const lines = fieldLines(std::vector<FieldPole>{{{0, 0}, -1}}, square(2), {.linesPerPole = 6});
    ASSERT_EQ(lines.size(), 6U);
    for (auto const& line : lines) {
        EXPECT_LT(length(line.back()), 1e-12);
        EXPECT_GT(length(line.front()), 1.9);
    }
}

TEST(FieldLines, ShorterStepsAreMuchMoreExact) {
    std::vector<FieldPole> const poles{{{-0.5, 0}, 1}, {{0.5, 0}, -1}};
    // The height at which the same line crosses the middle, by linear interpolation between dense points.
    auto const height = [&](double step) {
        auto const lines = fieldLines(poles, square(6), {.linesPerPole = 8, .softening = 0.3, .step = step});
        auto const& line = lines[1];
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (line[i - 1].x < 0 && line[i].x >= 0) {
                double const t = -line[i - 1].x / (line[i].x - line[i - 1].x);
                return line[i - 1].y + t * (line[i].y - line[i - 1].y);
            }
        }
        return -1.0;
    };
    double const exact = height(0.0005);
    double const coarse = std::abs(height(0.04) - exact);
    ASSERT_GT(exact, 0);
    EXPECT_LT(coarse, 2e-3);
    EXPECT_LT(std::abs(height(0.01) - exact), 0.3 * coarse + 1e-9);
}

TEST(FieldLines, OnlyMagnetsThatActHavePoles) {
    ExperimentStage stage;
    EXPECT_TRUE(activePoles(stage.world).empty());
    stage.closeSwitch();
    auto const poles = activePoles(stage.world);
    ASSERT_EQ(poles.size(), 1U);
    EXPECT_NEAR(poles[0].at.x, 2.4, 1e-12);
    EXPECT_NEAR(poles[0].at.y, 2.05 - 0.55, 1e-12);
    EXPECT_EQ(poles[0].strength, 1e4);
}

TEST(MagneticOverlay, ArrowsGrowByDecades) {
    EXPECT_EQ(arrowLength(0, 1), 0);
    EXPECT_EQ(arrowLength(std::nan(""), 1), 0);
    double const ten = arrowLength(10, 1);
    EXPECT_NEAR(arrowLength(100, 1) - ten, 1, 1e-3);
    EXPECT_NEAR(arrowLength(1000, 1) - arrowLength(100, 1), 1, 1e-3);
    EXPECT_LT(arrowLength(0.02, 1), arrowLength(0.03, 1));
}

} // namespace
} // namespace trembler::render::test
