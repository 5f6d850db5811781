// Shapes that no engine could compute are refused with a message that names the wrong number.
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "tests/physics/dynamics/ngon.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string_view>
#include <vector>

namespace trembler::test {
namespace shape_rules_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

TEST(ShapeRules, ReportErrors) {
    struct Case {
        ShapePiece piece;
        std::string_view says;
    };
    std::vector<Case> const cases{
        {circlePiece(0), "radius is 0 m"},
        {circlePiece(nan), "radius is nan m"},
        {circlePiece(-1), "expected 0.005 to 1000"},
        {boxPiece(0, 1), "width is 0 m"},
        {boxPiece(1, inf), "height is inf m"},
        {boxPiece(1, 1, {nan, 0}), "lies at [nan, 0]"},
        {boxPiece(1, 1, {}, inf), "turned by inf"},
        {capsulePiece(0.3, 0.2), "at least as long as both ends, 0.4 m"},
        {polygonPiece({{0, 0}, {1, 0}}), "has 2 corners"},
        {polygonPiece(ngon(9, 1)), "has 9 corners; expected 3 to 8"},
        {polygonPiece(ngon(5, 1, true)), "clockwise"},
        {polygonPiece({{0, 0}, {1, 0}, {2, 0}}), "on the line"},
        {polygonPiece({{0, 0}, {1, 0}, {2, 0}, {1, 1}}), "corner 2 of its polygon, [1, 0], lies on the line"},
        {polygonPiece({{0, 0}, {2, 0}, {1, 0.3}, {1, 2}}), "not convex"},
        {polygonPiece({{0, 1}, {-0.6, -0.8}, {0.9, 0.3}, {-0.9, 0.3}, {0.6, -0.8}}),
         "not convex"}, // pentagram
        {polygonPiece({{0, 0}, {1, 0}, {1, 0.001}, {0, 1}}), "are 0.001 m apart"},
        {polygonPiece({{0, 0}, {1, 0}, {0.5, 0.004}}), "thin"},
        {polygonPiece({{0, 0}, {1, nan}, {0.5, 1}}), "[1, nan]"},
    };
    for (Case const& c : cases) {
        auto const fault = faultIn(Shape{{c.piece}});
        ASSERT_TRUE(fault) << c.says;
        EXPECT_NE(fault->find(c.says), std::string::npos) << *fault;
    }
    EXPECT_TRUE(faultIn(Shape{}));
    EXPECT_TRUE(faultIn(Shape{std::vector<ShapePiece>(257, circlePiece(1))}));
    for (ShapePiece const& valid : {circlePiece(0.005), boxPiece(0.01, 0.01), capsulePiece(0.4, 0.2),
                                    polygonPiece(ngon(8, 0.5)), polygonPiece(ngon(3, 0.02))}) {
        EXPECT_FALSE(faultIn(Shape{{valid}})) << *faultIn(Shape{{valid}});
    }
}

} // namespace
} // namespace shape_rules_test
} // namespace trembler::test
