// Mass properties compared with sums over a fine grid of points.
#include "physics/dynamics/properties/shapes/mass_properties.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

bool inside(ShapePiece const& piece, Vec2 point) {
    Vec2 const p = rotated(point - piece.at, -piece.angle);
    switch (piece.form) {
    case ShapeForm::circle:
        return length(p) <= piece.radius;
    case ShapeForm::box:
        return std::abs(p.x) <= piece.width / 2 && std::abs(p.y) <= piece.height / 2;
    case ShapeForm::capsule: {
        double const half = piece.width / 2 - piece.radius;
        return length(p - Vec2{std::min(std::max(p.x, -half), half), 0}) <= piece.radius;
    }
    case ShapeForm::polygon:
        for (std::size_t i = 0; i < piece.corners.size(); ++i) {
            Vec2 const a = piece.corners[i];
            if (cross(piece.corners[(i + 1) % piece.corners.size()] - a, p - a) < 0) {
                return false;
            }
        }
        return true;
    }
    return false;
}

MassProperties byGrid(Shape const& shape, double extent, int cells) {
    double const step = 2 * extent / cells;
    MassProperties sum;
    double second = 0;
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            Vec2 const p{-extent + (i + 0.5) * step, -extent + (j + 0.5) * step};
            for (ShapePiece const& piece : shape.pieces) { // overlaps count twice
                if (inside(piece, p)) {
                    sum.area += step * step;
                    sum.centre += step * step * p;
                    second += step * step * lengthSquared(p);
                }
            }
        }
    }
    sum.centre *= 1 / sum.area;
    sum.inertiaPerMass = second / sum.area - lengthSquared(sum.centre);
    return sum;
}

TEST(MassProperties, AgreeWithSumsOverAGrid) {
    std::vector<Shape> const shapes{
        {{circlePiece(0.7)}},
        {{boxPiece(1.2, 0.4)}},
        {{capsulePiece(1.6, 0.3)}},
        {{capsulePiece(0.6, 0.3, {0.2, -0.3}, 1)}},
        {{polygonPiece({{0, 0}, {1, 0.2}, {0.8, 0.9}, {0.1, 0.7}})}},
        {{polygonPiece({{-0.4, -0.3}, {0.5, -0.2}, {0, 0.6}}, {0.3, -0.2}, 2)}},
        {{boxPiece(0.2, 1, {-0.5, 0}, 0.3), circlePiece(0.4, {0.5, 0.5}),
          capsulePiece(1, 0.1, {0, -0.6}, -0.4)}},
        {{boxPiece(1, 1), circlePiece(0.5, {0.5, 0})}},
    };
    for (Shape const& shape : shapes) {
        MassProperties const exact = massPropertiesOf(shape);
        MassProperties const grid = byGrid(shape, 1.5, 1500);
        EXPECT_NEAR(exact.area, grid.area, 2e-3 * grid.area);
        EXPECT_NEAR(exact.area, areaOf(shape), 1e-12);
        EXPECT_NEAR(length(exact.centre - grid.centre), 0, 1e-3);
        EXPECT_NEAR(exact.inertiaPerMass, grid.inertiaPerMass, 4e-3 * grid.inertiaPerMass);
    }
}

TEST(MassProperties, ACentredPieceIsCentredExactly) {
    EXPECT_EQ(centreOfMass({{circlePiece(0.3)}}), (Vec2{}));
    EXPECT_EQ(centreOfMass({{capsulePiece(0.3, 0.1)}}), (Vec2{}));
}

} // namespace
} // namespace trembler::test
