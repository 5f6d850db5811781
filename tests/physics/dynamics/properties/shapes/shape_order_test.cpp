// The order in which a shape lists its pieces and corners changes nothing.
#include "physics/buoyancy/hulls/exact_hull.hpp"
#include "physics/buoyancy/hulls/particle_hull.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "physics/dynamics/properties/shapes/shape_order.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace trembler::test {
namespace shape_order_test {
namespace {

class ShapeOrder : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(ShapeOrder);

// Four pieces, two of them equally large, two above one another.
Shape spanner() {
    return {{boxPiece(0.7, 0.12, {-0.1, 0}), circlePiece(0.11, {-0.45, 0}),
             polygonPiece({{0, -0.17}, {0.12, -0.17}, {0.12, 0.17}, {-0.07, 0.06}}, {0.25, 0}, 0.1),
             polygonPiece({{0, -0.05}, {0.15, -0.03}, {0.15, 0.04}, {0, 0.05}}, {0.37, 0.12})}};
}

// The motion of a few such shapes that tumble over a floor.
std::vector<double> motionOf(Shape const& shape) {
    Scene scene;
    scene.fixed("floor", Shape{{boxPiece(6, 0.5)}}.pieces[0], {0, -0.5});
    std::vector<double> path;
    std::vector<ObjectId> all;
    for (int i = 0; i < 3; ++i) {
        all.push_back(scene.body("body " + std::to_string(i), shape, {0.2 * i, 0.4 + 0.5 * i}, 0.7 * i));
    }
    for (int frame = 0; frame < 60; ++frame) {
        scene.run(1);
        for (ObjectId const id : all) {
            path.insert(path.end(),
                        {scene.at(id).x, scene.at(id).y, scene.angle(id), scene.spin(id), scene.mass(id)});
        }
    }
    return path;
}

TEST_P(ShapeOrder, OfPiecesChangesNoBitOfTheMotion) {
    Shape const shape = spanner();
    std::vector<double> const expected = motionOf(shape);
    std::vector<std::size_t> order{0, 1, 2, 3};
    do {
        Shape other;
        for (std::size_t const i : order) {
            other.pieces.push_back(shape.pieces[i]);
        }
        ASSERT_EQ(motionOf(other), expected);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST_P(ShapeOrder, OfCornersChangesNoBitOfTheMotion) {
    Shape shape = spanner();
    std::vector<double> const expected = motionOf(shape);
    std::vector<Vec2>& corners = shape.pieces[2].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        ASSERT_EQ(motionOf(shape), expected);
    }
}

ShapePiece randomPiece() {
    auto const number = [](int low, int high) { return *rc::gen::inRange(low, high) * 0.1; };
    Vec2 const at{number(-2, 3), number(-2, 3)};
    switch (*rc::gen::inRange(0, 4)) {
    case 0:
        return circlePiece(number(1, 3), at);
    case 1:
        return boxPiece(number(1, 3), number(1, 3), at, number(0, 3));
    case 2:
        return capsulePiece(number(4, 6), number(1, 3), at, number(0, 3));
    default:
        return polygonPiece({{0, 0}, {number(1, 4), 0}, {number(1, 4), number(1, 4)}, {0, 0.3}}, at,
                            number(0, 3));
    }
}

TEST(ShapeOrder, IsTheSameForEveryOrderOfRandomPieces) {
    EXPECT_TRUE(rc::check([] {
        Shape shape;
        for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
            shape.pieces.push_back(randomPiece());
        }
        Shape shuffled = shape;
        for (std::size_t i = shuffled.pieces.size(); i > 1; --i) {
            std::swap(shuffled.pieces[i - 1],
                      shuffled.pieces[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(i)))]);
        }
        for (ShapePiece& piece : shuffled.pieces) {
            if (!piece.corners.empty()) {
                std::rotate(piece.corners.begin(), piece.corners.begin() + *rc::gen::inRange(0, 4),
                            piece.corners.end());
            }
        }
        RC_ASSERT(inOrder(shape) == inOrder(shuffled));
        RC_ASSERT(isInOrder(inOrder(shape)));
        RC_ASSERT(isInOrder(shape) == (shape == inOrder(shape)));
        // All values computed from it have the same bits as well.
        RC_ASSERT(areaOf(shape) == areaOf(shuffled));
        RC_ASSERT(massPropertiesOf(shape).centre == massPropertiesOf(shuffled).centre);
        RC_ASSERT(massPropertiesOf(shape).inertiaPerMass == massPropertiesOf(shuffled).inertiaPerMass);
        Side const surface{{0, 1}, 0.05};
        for (bool const exact : {true, false}) {
            auto const wet = [&](Shape const& of) {
                return exact ? ExactHull(of).displaced({&surface, 1}, {0, 1}).wet
                             : ParticleHull(of, 40).displaced({&surface, 1}, {0, 1}).wet;
            };
            RC_ASSERT(wet(shape).area == wet(shuffled).area);
            RC_ASSERT(wet(shape).first == wet(shuffled).first);
        }
    }));
}

TEST(ShapeOrder, KeepsTheOrderOfShapesWithNonFiniteNumbers) {
    double const nan = std::numeric_limits<double>::quiet_NaN();
    Shape const shape{{circlePiece(0.1, {nan, 0}), circlePiece(0.2), circlePiece(0.3, {-1, 0})}};
    EXPECT_EQ(inOrder(shape).pieces.size(), 3U);
    EXPECT_EQ(inOrder(shape).pieces[1].radius, 0.2);
}

} // namespace
} // namespace shape_order_test
} // namespace trembler::test
