// The circle inside a body and the one around it, against points tried all over the body.
#include "physics/dynamics/engines/body_core.hpp"
#include "tests/physics/buoyancy/generators.hpp"
#include "tests/physics/dynamics/brute_gap.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace trembler::test {
namespace body_core_test {
namespace {

BodySpec specOf(Shape const& shape) {
    BodySpec spec;
    spec.shape = &shape;
    spec.spread = massPropertiesOf(shape);
    return spec;
}

TEST(BodyCore, LiesInsideTheBodyAndTheBodyWithinItsExtent) {
    EXPECT_TRUE(rc::check("the core is inside, the extent outside", [] {
        Shape shape;
        for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
            shape.pieces.push_back(*piece());
        }
        BodySpec const spec = specOf(shape);
        BodyCore const core = coreOf(spec);
        RC_ASSERT(core.radius > 0);
        RC_ASSERT(core.reach() <= core.radius);
        // The depth of a point in a shape is the distance to the nearest side: the core's circle fits if its
        // centre is at least its radius deep in one piece.
        double deepest = 0;
        Vec2 const centre = core.at + spec.spread.centre;
        Shape const dot{{circlePiece(1e-9)}};
        for (ShapePiece const& one : shape.pieces) {
            Shape const alone{{one}};
            deepest = std::max(deepest, -bruteGap({alone, {}, 0}, {dot, centre, 0}));
        }
        RC_ASSERT(deepest >= core.radius);
        if (shape.pieces.size() == 1) { // and it is not much smaller than the largest circle at this place
            RC_ASSERT(deepest <= core.radius / 0.85);
        }
        double const extent = extentOf(spec);
        double farthest = 0; // sampled in many directions
        for (int i = 0; i < 72; ++i) {
            Vec2 const direction = rotated({1, 0}, i * pi / 36);
            Shape const wall{{boxPiece(2e-3, 400)}};
            double const gap =
                bruteGap({shape, {}, 0}, {wall, spec.spread.centre + 100.0 * direction, i * pi / 36});
            farthest = std::max(farthest, 100 - 1e-3 - gap);
        }
        RC_ASSERT(extent >= farthest - 1e-6);
        RC_ASSERT(extent <= 3 * farthest + 1e-6); // a piece off its own origin needs a little more
    }));
}

TEST(BodyCore, OfSinglePiecesIsNineTenthsOfTheirInscribedCircle) {
    Shape const disc{{circlePiece(2)}};
    EXPECT_DOUBLE_EQ(coreOf(specOf(disc)).radius, 1.8);
    EXPECT_DOUBLE_EQ(extentOf(specOf(disc)), 2);
    Shape const plank{{boxPiece(4, 0.5)}};
    EXPECT_DOUBLE_EQ(coreOf(specOf(plank)).radius, 0.225);
    EXPECT_DOUBLE_EQ(extentOf(specOf(plank)), std::hypot(4, 0.5) / 2);
    Shape const capsule{{capsulePiece(3, 0.25)}};
    EXPECT_DOUBLE_EQ(coreOf(specOf(capsule)).radius, 0.225);
    EXPECT_DOUBLE_EQ(extentOf(specOf(capsule)), 1.5);
    // Of several pieces, the largest of their circles, relative to the centre of mass of all.
    Shape const hammer{{boxPiece(0.2, 4), boxPiece(1, 1, {0, 2})}};
    BodyCore const head = coreOf(specOf(hammer));
    EXPECT_DOUBLE_EQ(head.radius, 0.45);
    EXPECT_NEAR(head.at.y, 2 - 1 * 2 / (1 + 0.8), 1e-12);
}

} // namespace
} // namespace body_core_test
} // namespace trembler::test
