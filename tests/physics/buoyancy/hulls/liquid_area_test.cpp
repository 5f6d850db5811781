// Liquids as convex pieces with straight sides, compared with the shapes that they approximate.
#include "physics/buoyancy/hulls/liquid_area.hpp"
#include "tests/physics/buoyancy/generators.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::test {
namespace liquid_area_test {
namespace {

/// The distance of a point from a piece, negative inside; exact for round pieces and boxes.
double distanceTo(ShapePiece const& piece, Vec2 point) {
    Vec2 const p = rotated(point - piece.at, -piece.angle);
    switch (piece.form) {
    case ShapeForm::circle:
        return length(p) - piece.radius;
    case ShapeForm::capsule: {
        double const half = piece.width / 2 - piece.radius;
        return length(p - Vec2{std::clamp(p.x, -half, half), 0}) - piece.radius;
    }
    case ShapeForm::box: {
        Vec2 const q{std::abs(p.x) - piece.width / 2, std::abs(p.y) - piece.height / 2};
        double const outside = length({std::max(q.x, 0.0), std::max(q.y, 0.0)});
        return outside + std::min(std::max(q.x, q.y), 0.0);
    }
    case ShapeForm::polygon:
        break;
    }
    double most = -1e9;
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
        Vec2 const side = piece.corners[(i + 1) % piece.corners.size()] - piece.corners[i];
        most = std::max(most, cross(p - piece.corners[i], side) / length(side));
    }
    return most;
}

TEST(LiquidArea, AStraightenedPieceHasTheAreaOfThePieceAndItsPlace) {
    EXPECT_TRUE(rc::check("area and centroid stay", [] {
        ShapePiece const one = *piece();
        std::vector<Vec2> const corners = straightened(one);
        RC_ASSERT(corners.size() >= 3 && corners.size() <= mostSides);
        AreaMoments const moments = polygonMoments(corners);
        RC_ASSERT(std::abs(moments.area - areaOf(one)) <=
                  2e-3 * areaOf(one)); // exact except for a capsule's sides
        if (one.form == ShapeForm::circle) {
            RC_ASSERT(std::abs(moments.area - areaOf(one)) <= 1e-12 * areaOf(one));
        }
        if (one.form != ShapeForm::polygon) {
            RC_ASSERT(length(moments.centroid() - one.at) < 1e-9);
        }
        for (std::size_t i = 0; i < corners.size(); ++i) { // convex, anticlockwise, without duplicate corners
            Vec2 const a = corners[(i + 1) % corners.size()] - corners[i];
            Vec2 const b = corners[(i + 2) % corners.size()] - corners[(i + 1) % corners.size()];
            RC_ASSERT(length(a) > 1e-9);
            RC_ASSERT(cross(a, b) > -1e-9 * length(a) * length(b));
        }
    }));
    // A capsule without any straight part is a disc.
    EXPECT_EQ(straightened(capsulePiece(1, 0.5)).size(), roundSides);
}

TEST(LiquidArea, InsideAllSidesIsInsideThePiece) {
    EXPECT_TRUE(rc::check("points near and far", [] {
        Shape shape;
        for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
            shape.pieces.push_back(*piece());
        }
        Vec2 const at = *point(5);
        double const angle = *number(-3, 3);
        auto const pieces = liquidPieces(shape, Pose(at, angle));
        Bounds const bounds = areaBounds(shape, Pose(at, angle));
        RC_ASSERT(pieces.size() == shape.pieces.size());
        for (int i = 0; i < 60; ++i) {
            Vec2 const local = *point(2.5);
            Vec2 const world = at + rotated(local, angle);
            for (std::size_t n = 0; n < pieces.size(); ++n) {
                bool inside = true;
                for (Side const& side : pieces[n].sides) {
                    RC_ASSERT(std::abs(length(side.normal) - 1) < 1e-12);
                    inside = inside && dot(side.normal, world) <= side.offset;
                }
                double const distance = distanceTo(shape.pieces[n], local);
                double const slack = 2e-3; // the error of straight sides for a radius of 1 m
                RC_ASSERT(!inside || distance < slack);
                RC_ASSERT(inside || distance > -slack);
                RC_ASSERT(!inside || (world.x >= bounds.lower.x - 1e-9 && world.x <= bounds.upper.x + 1e-9 &&
                                      world.y >= bounds.lower.y - 1e-9 && world.y <= bounds.upper.y + 1e-9));
            }
        }
    }));
}

// Only the sides that meet the circle around a body are needed, also in the body's frame.
TEST(LiquidArea, CuttingSidesGiveTheResultOfAllSides) {
    EXPECT_TRUE(rc::check("for every point of the body", [] {
        auto const pieces = liquidPieces(Shape{{*piece()}}, Pose(*point(1), *number(-3, 3)));
        double const radius = *number(0.05, 1);
        Pose const body(*point(3), *number(-3, 3));
        CuttingSides cutting;
        findCuttingSides(pieces[0], body, radius, cutting);
        for (int i = 0; i < 40; ++i) {
            Vec2 const own = *number(0, 1) * radius * rotated({1, 0}, *number(-3.2, 3.2));
            Vec2 const world = body.toWorld(own);
            bool expected = true;
            double nearest = 1;
            for (Side const& side : pieces[0].sides) {
                double const outside = dot(side.normal, world) - side.offset;
                expected = expected && outside <= 0;
                nearest = std::min(nearest, std::abs(outside));
            }
            if (nearest < 1e-9) {
                continue; // on a side: both results are valid
            }
            bool found = !cutting.dry;
            for (std::size_t n = 0; n < cutting.count && !cutting.dry; ++n) {
                found = found && dot(cutting.sides[n].normal, own) <= cutting.sides[n].offset;
            }
            RC_ASSERT(found == expected);
        }
    }));
    auto const pool = liquidPieces(Shape{{boxPiece(10, 10)}}, Pose({}, 0));
    CuttingSides cutting;
    findCuttingSides(pool[0], Pose({}, 1), 1, cutting);
    EXPECT_FALSE(cutting.dry);
    EXPECT_EQ(cutting.count, 0U) << "far inside no side cuts";
    findCuttingSides(pool[0], Pose({0, 6}, 1), 0.9, cutting);
    EXPECT_TRUE(cutting.dry);
}

} // namespace
} // namespace liquid_area_test
} // namespace trembler::test
