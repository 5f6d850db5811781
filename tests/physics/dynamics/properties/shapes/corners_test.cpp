#include "physics/dynamics/properties/shapes/corners.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

/// By the shoelace formula: positive if the corners run anticlockwise.
double shoelaceArea(std::vector<Vec2> const& corners) {
    double twice = 0;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        twice += corners[j].x * corners[i].y - corners[i].x * corners[j].y;
    }
    return twice / 2;
}

TEST(StraightCorners, GoRoundABoxAndAPolygonAnticlockwise) {
    EXPECT_DOUBLE_EQ(shoelaceArea(straightCornersOf(boxPiece(3, 0.5, {7, 8}, 1))), 1.5);
    std::vector<Vec2> const triangle{{0, 0}, {2, 0}, {0, 1}};
    EXPECT_EQ(straightCornersOf(polygonPiece(triangle, {7, 8}, 1)), triangle);
    EXPECT_DOUBLE_EQ(shoelaceArea(straightCornersOf(polygonPiece(triangle))), 1);
}

TEST(StraightCorners, AreNoneOfRoundPieces) {
    EXPECT_TRUE(straightCornersOf(circlePiece(1)).empty());
    EXPECT_TRUE(straightCornersOf(capsulePiece(3, 0.5)).empty());
}

} // namespace
} // namespace trembler
