// Reverberation compared with Sabine's formula.
#include "audio/synth/room.hpp"
#include "tests/audio/effect/listening_room.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler {
namespace {

using test::ListeningRoom;

/// Inside of 6 m by 4 m, the corner at the origin.
RoomAcoustics boxOf(Material material, bool ceiling = true, bool rightWall = true, Vec2 at = {2, 1.5}) {
    ListeningRoom world;
    world.fixed("floor", material, boxPiece(7, 0.5), {3, -0.25});
    world.fixed("left wall", material, boxPiece(0.5, 5), {-0.25, 2});
    if (ceiling) {
        world.fixed("ceiling", material, boxPiece(7, 0.5), {3, 4.25});
    }
    if (rightWall) {
        world.fixed("right wall", material, boxPiece(0.5, 5), {6.25, 2});
    }
    world.body("crate", Material::wood, boxPiece(0.6, 0.6), {3, 0.3}); // movable, so it is not a wall
    return roomAround(world.world->store(), at);
}

TEST(Room, AClosedBoxFollowsSabinesFormula) {
    double const area = 24;
    double const depth = std::sqrt(area);
    double const surface = 20 * depth + 2 * area;
    double const volume = area * depth;
    RoomAcoustics const stone = boxOf(Material::stone);
    EXPECT_NEAR(stone.area, area, 0.01 * area);
    EXPECT_NEAR(stone.volume, volume, 0.02 * volume);
    EXPECT_NEAR(stone.surface, surface, 0.01 * surface);
    EXPECT_NEAR(stone.absorption, 0.02, 1e-9);
    double const expected = 0.161 * volume / (0.02 * surface + 0.012 * volume);
    EXPECT_NEAR(stone.reverberation, expected, 0.02 * expected);
    EXPECT_NEAR(boxOf(Material::stone, true, true, {5, 3}).reverberation, expected, 0.03 * expected)
        << "for a listener at any place";
    EXPECT_GT(stone.reverberation, 2 * boxOf(Material::wood).reverberation);
    EXPECT_GT(boxOf(Material::wood).reverberation, boxOf(Material::rubber).reverberation);
    EXPECT_GT(stone.echo, boxOf(Material::wood).echo);
}

TEST(Room, OpeningsAbsorbSound) {
    double const closed = boxOf(Material::stone).reverberation;
    double const roofless = boxOf(Material::stone, false).reverberation;
    double const yard = boxOf(Material::stone, false, false).reverberation;
    EXPECT_LT(roofless, 0.5 * closed);
    EXPECT_LT(boxOf(Material::stone, false, false).echo, 0.1 * boxOf(Material::stone).echo);
    EXPECT_GT(yard, 0);
    RoomAcoustics const field = roomAround({}, {}, {0, 0});
    EXPECT_EQ(field.absorption, 1);
    EXPECT_EQ(field.echo, 0);
}

TEST(Room, AListenerInsideAWallIsNotInAClosedRoom) {
    RoomAcoustics const inFloor = boxOf(Material::stone, true, true, {3, -0.1});
    EXPECT_GT(inFloor.area, 20);
}

} // namespace
} // namespace trembler
