// Areas of shapes, against strips.
#include "physics/dynamics/properties/shape.hpp"
#include "tests/physics/buoyancy/generators.hpp"
#include "tests/physics/buoyancy/oracle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace trembler::test {
namespace shape_test {
namespace {

TEST(Shape, AreasOfPiecesAreThoseOfStripsAcrossThem) {
    EXPECT_TRUE(rc::check("the midpoint rule", [] {
        ShapePiece const one = *piece();
        Slab const slab(one, {3, 4}, *number(-3, 3));
        double const area = common(slab, slab).area;
        RC_ASSERT(std::abs(areaOf(one) - area) < 2e-3 * area);
    }));
    EXPECT_DOUBLE_EQ(areaOf(boxPiece(2, 3)), 6);
    EXPECT_DOUBLE_EQ(areaOf(circlePiece(2)), 4 * pi);
    EXPECT_DOUBLE_EQ(areaOf(capsulePiece(5, 1)), 6 + pi);
    EXPECT_DOUBLE_EQ(areaOf(polygonPiece({{0, 0}, {4, 0}, {0, 3}})), 6);
}

// A shape in a level file may list its pieces in any order, and must weigh the same to the bit.
TEST(Shape, AreaDoesNotDependOnTheOrderOfPieces) {
    EXPECT_TRUE(rc::check("the same bits", [] {
        Shape shape;
        double sum = 0;
        for (int i = *rc::gen::inRange(1, 8); i > 0; --i) {
            shape.pieces.push_back(*piece());
            sum += areaOf(shape.pieces.back());
        }
        double const area = areaOf(shape);
        RC_ASSERT(std::abs(area - sum) < 1e-12 * sum); // overlaps count twice
        std::reverse(shape.pieces.begin(), shape.pieces.end());
        RC_ASSERT(areaOf(shape) == area);
        std::rotate(shape.pieces.begin(), shape.pieces.begin() + 1, shape.pieces.end());
        RC_ASSERT(areaOf(shape) == area);
    }));
    EXPECT_EQ(areaOf(Shape{}), 0);
}

} // namespace
} // namespace shape_test
} // namespace trembler::test
