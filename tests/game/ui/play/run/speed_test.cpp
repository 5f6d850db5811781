// The speed of a run: as the player chooses it, and on a slow computer.
#include "game/ui/play/run/speed.hpp"

#include <gtest/gtest.h>

namespace trembler::ui::test {
namespace {

TEST(Speed, GoesFromAQuarterToEightTimes) {
    Speed speed;
    EXPECT_EQ(speed.now(), 1);
    for (int i = 0; i < 9; ++i) {
        speed.slower();
    }
    EXPECT_EQ(speed.now(), 0.25);
    EXPECT_FALSE(speed.canSlow());
    for (int i = 0; i < 9; ++i) {
        speed.faster();
    }
    EXPECT_EQ(speed.now(), 8);
    EXPECT_FALSE(speed.canHurry());
    speed.setNormal();
    EXPECT_EQ(speed.now(), 1);
    speed.holdFast(true);
    EXPECT_EQ(speed.now(), 4);
    speed.holdFast(false);
    EXPECT_EQ(speed.now(), 1);
}

TEST(Speed, SlowMotionShowsTheTimeBetweenFrames) {
    Speed speed;
    speed.slower();
    EXPECT_EQ(speed.due(1.0 / 60), 0);
    EXPECT_NEAR(speed.alpha(), 0.5, 1e-9);
    EXPECT_EQ(speed.due(1.0 / 60), 1);
}

TEST(Speed, ASlowComputerAnswersAndIsToldOf) {
    Speed speed;
    for (int i = 0; i < 3; ++i) {
        speed.faster();
    }
    constexpr double perFrame = 0.02; // s, that this computer needs for a frame
    double picture = 1.0 / 60;
    double longest = 0;
    double passed = 0;
    for (int i = 0; i < 200; ++i) {
        int const frames = speed.due(picture);
        EXPECT_GT(frames, 0);
        passed += picture;
        picture = 0.01 + perFrame * frames;
        longest = passed > 3 ? std::max(longest, picture) : 0;
    }
    EXPECT_LT(longest, 0.25) << "the picture stands still";
    ASSERT_TRUE(speed.onlyReached());
    EXPECT_NEAR(*speed.onlyReached(), 0.7, 0.2);
    speed.reset();
    EXPECT_FALSE(speed.onlyReached());
}

TEST(Speed, OneLongPauseIsNoSlowness) {
    Speed speed;
    for (int i = 0; i < 300; ++i) {
        (void)speed.due(i == 100 ? 3.0 : 1.0 / 60);
        EXPECT_FALSE(speed.onlyReached());
    }
}

} // namespace
} // namespace trembler::ui::test
