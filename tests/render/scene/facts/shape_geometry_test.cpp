// Distances, extents, cuts and compounds against brute force.
#include "render/scene/objects/compound.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numbers>

namespace trembler::render::test {
namespace shape_geometry_test {
namespace {

double between(double lower, double upper) {
    return lower + (upper - lower) * *rc::gen::inRange(0, 1000001) / 1e6;
}

ShapePiece anyPiece() {
    Vec2 const at{between(-0.5, 0.5), between(-0.5, 0.5)};
    double const angle = between(-3, 3);
    switch (*rc::gen::inRange(0, 4)) {
    case 0:
        return circlePiece(between(0.05, 0.6), at);
    case 1:
        return boxPiece(between(0.1, 1), between(0.1, 1), at, angle);
    case 2: {
        double const radius = between(0.05, 0.3);
        return capsulePiece(2 * radius + between(0.01, 1), radius, at, angle);
    }
    default: {
        // Points of a squeezed circle in ascending order are a convex polygon.
        std::vector<Vec2> corners;
        double turn = between(0, 0.5);
        for (int i = 0; i < 5; ++i) {
            corners.push_back({0.6 * std::cos(turn), 0.3 * std::sin(turn)});
            turn += between(0.4, 1.2);
        }
        return polygonPiece(corners, at, angle);
    }
    }
}

// Whether a point lies in an outline, by the even-odd rule; shares no code with the drawing.
bool insideOutline(std::vector<Point> const& outline, Point p) {
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        Point const a = outline[i];
        Point const b = outline[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) {
            inside = !inside;
        }
    }
    return inside;
}

double distanceToOutline(std::vector<Point> const& outline, Point p) {
    double least = 1e9;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        Point const edge = outline[(i + 1) % outline.size()] - outline[i];
        double const along = dot(p - outline[i], edge) / std::max(dot(edge, edge), 1e-30);
        least = std::min(least, length(p - outline[i] - std::clamp(along, 0.0, 1.0) * edge));
    }
    return least;
}

double area(std::vector<Point> const& corners) {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Point const a = corners[i];
        Point const b = corners[(i + 1) % corners.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

TEST(SceneGeometry, DistanceAgreesWithSamples) {
    EXPECT_TRUE(rc::check([] {
        ShapePiece const piece = anyPiece();
        Point const p{between(-1.5, 1.5), between(-1.5, 1.5)};
        std::vector<Point> const outline = outlineOf(piece, 62);
        double const expected = distanceToOutline(outline, p);
        double const distance = distanceTo(piece, p);
        // A circle of 62 corners is flatter than the true one by up to 0.13 % of its radius.
        RC_ASSERT(std::abs(std::abs(distance) - expected) < 0.012);
        if (expected > 0.002) {
            RC_ASSERT((distance < 0) == insideOutline(outline, p));
        }
    }));
}

TEST(SceneGeometry, OutlinesRunAnticlockwiseAndEncloseTheArea) {
    EXPECT_TRUE(rc::check([] {
        ShapePiece const piece = anyPiece();
        double const enclosed = area(outlineOf(piece, 62));
        RC_ASSERT(enclosed > 0);
        RC_ASSERT(std::abs(enclosed - trembler::areaOf(piece)) < 0.004 * trembler::areaOf(piece) + 1e-12);
    }));
}

TEST(SceneGeometry, ExtentIsTheTightestRectangle) {
    EXPECT_TRUE(rc::check([] {
        ShapePiece const piece = anyPiece();
        Pose const pose{{between(-5, 5), between(-5, 5)}, between(-4, 4)};
        Extent sampled;
        for (Point const corner : outlineOf(piece, 62)) {
            sampled.add(toWorld(pose, corner));
        }
        Extent const extent = extentOf(piece, pose);
        RC_ASSERT(extent.lower.x <= sampled.lower.x + 1e-9 && extent.upper.y >= sampled.upper.y - 1e-9);
        RC_ASSERT(length(extent.lower - sampled.lower) < 0.002);
        RC_ASSERT(length(extent.upper - sampled.upper) < 0.002);
    }));
}

TEST(SceneGeometry, TwoHalvesMakeTheWhole) {
    EXPECT_TRUE(rc::check([] {
        std::vector<Point> const outline = outlineOf(anyPiece());
        Point const at{between(-0.5, 0.5), between(-0.5, 0.5)};
        double const angle = between(-3, 3);
        Point const normal{std::cos(angle), std::sin(angle)};
        std::vector<Point> const one = clipHalf(outline, at, normal);
        std::vector<Point> const other = clipHalf(outline, at, -1.0 * normal);
        RC_ASSERT(std::abs(area(one) + area(other) - area(outline)) < 1e-9);
        for (Point const corner : one) {
            RC_ASSERT(dot(corner - at, normal) > -1e-9);
        }
        // Where a line crosses the outline, both its ends lie on the cut of the two halves.
        if (auto const chord = clipLine(outline, at, {-normal.y, normal.x})) {
            for (Point const end : *chord) {
                RC_ASSERT(std::abs(dot(end - at, normal)) < 1e-9);
                RC_ASSERT(distanceToOutline(outline, end) < 0.01);
            }
        } else {
            RC_ASSERT(area(one) < 1e-9 || area(other) < 1e-9);
        }
    }));
}

TEST(SceneGeometry, InsetLiesInsideByTheDistance) {
    EXPECT_TRUE(rc::check([] {
        std::vector<Point> const outline = outlineOf(anyPiece());
        double const distance = between(0.001, 0.1);
        for (Point const corner : insetOutline(outline, distance)) {
            for (std::size_t i = 0; i < outline.size(); ++i) {
                Point const side = outline[(i + 1) % outline.size()] - outline[i];
                double const depth =
                    (side.x * (corner.y - outline[i].y) - side.y * (corner.x - outline[i].x)) / length(side);
                RC_ASSERT(depth > distance - 1e-9);
            }
        }
    }));
}

TEST(SceneGeometry, CompoundEdgeOfTwoAdjacentBoxesHasSeams) {
    // An L of two boxes, 1 by 0.2 and 0.2 by 0.6, that share a side of 0.2.
    Shape const shape{{boxPiece(1, 0.2, {0.5, 0.1}), boxPiece(0.2, 0.6, {0.1, 0.5})}};
    CompoundEdges const edges = edgesOf(shape, 0.01);
    double outer = 0;
    for (Segment const& edge : edges.outer) {
        outer += length(edge[1] - edge[0]);
    }
    EXPECT_NEAR(outer, 2 * (1 + 0.8), 1e-6);
    ASSERT_EQ(edges.seams.size(), 2U); // one seam from each side
    for (Segment const& seam : edges.seams) {
        EXPECT_NEAR(length(seam[1] - seam[0]), 0.2, 1e-6);
        EXPECT_NEAR(seam[0].y, 0.2, 1e-9);
    }
}

TEST(SceneGeometry, CompoundEdgeOfBoxesThatOverlapHasNoSeam) {
    Shape const cross{{boxPiece(1, 0.2), boxPiece(0.2, 1)}};
    CompoundEdges const edges = edgesOf(cross, 0.01);
    double outer = 0;
    for (Segment const& edge : edges.outer) {
        outer += length(edge[1] - edge[0]);
    }
    EXPECT_NEAR(outer, 4.0, 1e-6);
    EXPECT_TRUE(edges.seams.empty());
}

TEST(SceneGeometry, PartsWithoutOverlapsCoverEverythingOnce) {
    EXPECT_TRUE(rc::check([] {
        Shape shape;
        for (int i = 0; i < 3; ++i) {
            shape.pieces.push_back(anyPiece());
        }
        std::vector<std::vector<Point>> outlines;
        for (ShapePiece const& piece : shape.pieces) {
            outlines.push_back(outlineOf(piece));
        }
        auto const parts = withoutOverlaps(shape);
        for (int i = 0; i < 50; ++i) {
            Point const p{between(-1, 1), between(-1, 1)};
            bool nearEdge = false;
            int pieces = 0;
            for (auto const& outline : outlines) {
                nearEdge = nearEdge || distanceToOutline(outline, p) < 0.006;
                pieces += insideOutline(outline, p) ? 1 : 0;
            }
            int covering = 0;
            for (auto const& part : parts) {
                nearEdge = nearEdge || distanceToOutline(part, p) < 0.006;
                covering += insideOutline(part, p) ? 1 : 0;
            }
            if (!nearEdge) {
                RC_ASSERT(covering == (pieces > 0 ? 1 : 0));
            }
        }
    }));
}

} // namespace
} // namespace shape_geometry_test
} // namespace trembler::render::test
