#include "physics/dynamics/properties/shapes/placed_shape.hpp"
#include "runtime/placement.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(PlacedShape, IsWhereTheObjectIs) {
    Store store;
    ObjectId const object = store.create("thing");
    EXPECT_FALSE(placedShapeOf(store, object)) << "it has neither";
    store.column<Shape>().set(object, {{circlePiece(0.5)}});
    EXPECT_FALSE(placedShapeOf(store, object)) << "it is nowhere";
    store.column<Position>().set(object, {{1, 2}});
    auto const upright = placedShapeOf(store, object);
    ASSERT_TRUE(upright);
    EXPECT_EQ(upright->at, (Vec2{1, 2}));
    EXPECT_EQ(upright->angle, 0);
    EXPECT_EQ(upright->shape.pieces.size(), 1U);
    store.column<Rotation>().set(object, {0.25});
    EXPECT_EQ(placedShapeOf(store, object)->angle, 0.25);
    EXPECT_FALSE(placedShapeOf(store, ObjectId{}));
    store.column<Shape>().set(object, {});
    EXPECT_FALSE(placedShapeOf(store, object)) << "a shape without pieces is nowhere";
}

} // namespace
} // namespace trembler
