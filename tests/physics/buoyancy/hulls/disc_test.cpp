// Areas and moments of cut discs, against integrals in strips and in rings.
#include "physics/buoyancy/hulls/disc.hpp"
#include "tests/physics/buoyancy/generators.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace trembler::test {
namespace disc_test {
namespace {

/// An integral over a part of the disc, by the midpoint rule in polar coordinates; `inside` selects the part.
AreaMoments integrated(double radius, std::function<bool(Vec2)> const& inside) {
    constexpr int rings = 80;
    constexpr int rays = 240;
    AreaMoments sum;
    for (int i = 0; i < rings; ++i) {
        double const r = radius * (i + 0.5) / rings;
        for (int j = 0; j < rays; ++j) {
            double const angle = 2 * pi * (j + 0.5) / rays;
            Vec2 const p{r * std::cos(angle), r * std::sin(angle)};
            if (inside(p)) {
                double const area = r * (radius / rings) * (2 * pi / rays);
                sum += {area, area * p, area * p.x * p.x, area * p.x * p.y, area * p.y * p.y};
            }
        }
    }
    return sum;
}

void expectNear(AreaMoments const& found, AreaMoments const& right, double radius, double share) {
    double const area = radius * radius * share;
    RC_ASSERT(std::abs(found.area - right.area) < area);
    RC_ASSERT(length(found.first - right.first) < area * radius);
    RC_ASSERT(std::abs(found.xx - right.xx) < area * radius * radius);
    RC_ASSERT(std::abs(found.xy - right.xy) < area * radius * radius);
    RC_ASSERT(std::abs(found.yy - right.yy) < area * radius * radius);
}

TEST(Disc, SegmentsAgreeWithIntegrals) {
    EXPECT_TRUE(rc::check("the integral over the segment", [] {
        double const radius = *number(0.1, 3);
        double const distance = *number(-1.2, 1.2) * radius;
        Vec2 const normal = rotated({1, 0}, *number(-3, 3));
        Segment const segment = discSegment(radius, distance);
        expectNear(segment.moments(normal),
                   integrated(radius, [&](Vec2 p) { return dot(normal, p) <= distance; }), radius, 0.02);
        double const square = radius * radius - distance * distance;
        RC_ASSERT(std::abs(segment.halfChord - std::sqrt(std::max(square, 0.0))) < 1e-7 * radius);
        // With the segment on the other side it is the whole disc.
        AreaMoments both = segment.moments(normal);
        both += discSegment(radius, -distance).moments(-normal);
        expectNear(both, discMoments(radius), radius, 1e-12);
    }));
    EXPECT_EQ(discSegment(2, -2).area, 0);
    EXPECT_EQ(discSegment(2, -5).moments({0, 1}).area, 0);
    EXPECT_NEAR(discSegment(2, 2).area, 4 * pi, 1e-12);
    EXPECT_NEAR(discSegment(2, 9).offset, 0, 1e-12);
    EXPECT_NEAR(discSegment(1, 0).offset, 4 / (3 * pi), 1e-12) << "the centroid of half a disc";
}

TEST(Disc, WholeDiscsHaveTheMomentsOfTheTextbook) {
    AreaMoments const whole = discMoments(2);
    EXPECT_NEAR(whole.area, 4 * pi, 1e-12);
    EXPECT_EQ(whole.first, (Vec2{}));
    EXPECT_NEAR(whole.xx, pi * 16 / 4, 1e-12); // π r⁴/4
    EXPECT_EQ(whole.xx, whole.yy);
    EXPECT_EQ(whole.xy, 0);
}

TEST(Disc, SectorsTakeTheShorterArc) {
    EXPECT_TRUE(rc::check("the integral over the sector", [] {
        double const radius = *number(0.1, 3);
        double const from = *number(-3.1, 3.1);
        double const turn = *number(-3.1, 3.1);
        Vec2 const p = rotated({*number(0.1, 9), 0}, from);
        Vec2 const q = rotated({*number(0.1, 9), 0}, from + turn);
        AreaMoments const right = integrated(radius, [&](Vec2 point) {
            double const angle = std::atan2(cross(p, point), dot(p, point));
            return turn >= 0 ? angle >= 0 && angle <= turn : angle <= 0 && angle >= turn;
        });
        expectNear(sectorMoments(radius, p, q), (turn >= 0 ? 1 : -1) * right, radius, 0.02);
    }));
}

// The sides of a polygon add up to the intersection of polygon and disc.
TEST(Disc, SidesAddUpToTheIntersectionWithAPolygon) {
    EXPECT_TRUE(rc::check("the integral over the intersection", [] {
        double const radius = *number(0.1, 1.5);
        ShapePiece const polygon = *convexPolygon();
        std::vector<Vec2> corners;
        for (Vec2 const corner : polygon.corners) {
            corners.push_back(polygon.at + rotated(corner, polygon.angle));
        }
        AreaMoments sum;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            Vec2 const from = corners[i];
            Vec2 const to = corners[(i + 1) % corners.size()];
            DiscSide const side = discSide(radius, from, to);
            sum += side.moments;
            if (side.cuts) {
                for (Vec2 const end : side.chord) { // on the side, and inside the disc
                    RC_ASSERT(length(end) <= radius * (1 + 1e-9));
                    RC_ASSERT(std::abs(cross(to - from, end - from)) <=
                              1e-9 * lengthSquared(to - from) + 1e-12);
                }
            }
        }
        AreaMoments const right = integrated(radius, [&](Vec2 p) {
            for (std::size_t i = 0; i < corners.size(); ++i) {
                if (cross(corners[(i + 1) % corners.size()] - corners[i], p - corners[i]) < 0) {
                    return false;
                }
            }
            return true;
        });
        expectNear(sum, right, radius, 0.04);
    }));
}

TEST(Disc, DegenerateSidesAddNothing) {
    EXPECT_EQ(discSide(1, {0.5, 0}, {0.5, 0}).moments.area, 0);
    EXPECT_FALSE(discSide(1, {0.5, 0}, {0.5, 0}).cuts);
    EXPECT_EQ(discSide(1, {0, 0}, {2, 0}).moments.area, 0) << "along a radius";
    EXPECT_FALSE(discSide(1, {3, -1}, {3, 1}).cuts) << "outside";
    EXPECT_NEAR(discSide(1, {3, -3}, {3, 3}).moments.area, pi / 4, 1e-12) << "but it bounds a sector";
}

} // namespace
} // namespace disc_test
} // namespace trembler::test
