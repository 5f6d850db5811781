#include "audio/effect/core/contact_pulse.hpp"
#include "audio/effect/core/sound_columns.hpp"
#include "tests/audio/effect/listening_room.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace sound_columns_test {
namespace {

SoundColumns columnsOf(Store& store) {
    return {store.column<Shape>(),   store.column<MadeOf>(),   store.column<Acoustics>(),
            store.column<Sample>(),  store.column<Mass>(),     store.column<Fixed>(),
            store.column<Liquid>(),  store.column<Position>(), store.column<Rotation>(),
            store.column<Velocity>()};
}

// The law itself is compared with its formula in sounding_body_test.cpp; here, the numbers that it receives
// are tested.
TEST(SoundColumns, AnImpactLastsAsLongAsItsTwoObjectsMakeIt) {
    test::ListeningRoom room;
    ObjectId const ball = room.body("ball", Material::steel, circlePiece(0.1), {0, 1});
    ObjectId const block = room.body("block", Material::wood, boxPiece(1, 1), {3, 1});
    ObjectId const floor = room.fixed("floor", Material::stone, boxPiece(9, 1), {0, -1});
    ObjectId const wall = room.fixed("wall", Material::stone, boxPiece(1, 9), {9, 0});
    ObjectId const ghost = room.world->store().create("ghost");
    room.give(ball, Mass{2});
    room.give(block, Mass{6});
    SoundColumns const columns = columnsOf(room.world->store());
    double const impulse = 3; // N s
    EXPECT_DOUBLE_EQ(columns.contactTimeOf(ball, floor, impulse),
                     contactTime(Material::steel, Material::stone, 0.1, 0, 2, 1.5));
    EXPECT_DOUBLE_EQ(columns.contactTimeOf(ball, block, impulse),
                     contactTime(Material::steel, Material::wood, 0.1, 0, 1.5, 2));
    EXPECT_EQ(columns.contactTimeOf(block, ball, impulse), columns.contactTimeOf(ball, block, impulse))
        << "the same bits for both";
    EXPECT_DOUBLE_EQ(columns.contactTimeOf(ball, ghost, impulse),
                     contactTime(Material::steel, Material::plastic, 0.1, 0, 2, 1.5));
    EXPECT_EQ(columns.contactTimeOf(floor, wall, impulse), 0.05) << "neither can move: the longest";
}

} // namespace
} // namespace sound_columns_test
} // namespace trembler
