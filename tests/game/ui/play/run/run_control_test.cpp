// A level's run without a window: the effects of the buttons on the session, and the reported state.
#include "tests/game/ui/play/run/controlled_run.hpp"

namespace trembler::ui::test {
namespace {

TEST(RunControl, RunsPausesAndStops) {
    Controlled level;
    EXPECT_TRUE(level.run.building());
    level.pictures(3);
    EXPECT_EQ(level.frame(), 0U);
    EXPECT_FALSE(level.run.stepped());
    level.run.pauseOrGo();
    EXPECT_TRUE(level.run.building()) << "nothing to pause";
    level.run.runOrStop();
    EXPECT_TRUE(level.run.running());
    level.pictures(2);
    EXPECT_EQ(level.frame(), 2U);
    EXPECT_TRUE(level.run.stepped());
    EXPECT_EQ(level.callbacks, "nbaba");
    level.run.pauseOrGo();
    EXPECT_TRUE(level.run.paused());
    level.pictures(5);
    EXPECT_EQ(level.frame(), 2U);
    level.run.pauseOrGo();
    level.pictures(1);
    EXPECT_EQ(level.frame(), 3U);
    level.callbacks.clear();
    level.run.runOrStop();
    EXPECT_TRUE(level.run.building());
    EXPECT_EQ(level.frame(), 0U);
    EXPECT_EQ(level.callbacks, "sn");
}

TEST(RunControl, SingleFramesStartTheRunAndPauseIt) {
    Controlled level;
    level.run.step();
    EXPECT_TRUE(level.run.paused());
    EXPECT_EQ(level.frame(), 1U);
    level.run.step();
    EXPECT_EQ(level.frame(), 2U);
    level.run.pauseOrGo();
    level.run.step();
    EXPECT_TRUE(level.run.paused());
    EXPECT_EQ(level.frame(), 3U);
    EXPECT_EQ(level.run.alpha(), 1) << "a paused world is drawn at its current positions";
}

TEST(RunControl, TellsOfSlowFrames) {
    Controlled level;
    double now = 0; // between two readings 1.5 s pass
    level.run.measureWith(FrameTimer(2, [&] { return now += 1.5; }));
    level.run.step();
    EXPECT_TRUE(level.slowFrames.empty());
    level.run.measureWith(FrameTimer(1, [&] { return now += 1.5; }));
    level.run.step();
    ASSERT_EQ(level.slowFrames.size(), 1U);
    EXPECT_EQ(level.slowFrames.front().frame, 2U);
    EXPECT_EQ(level.slowFrames.front().seconds, 1.5);
    level.run.runOrStop();
    level.run.runOrStop();
    level.pictures(2);
    EXPECT_EQ(level.slowFrames.size(), 3U);
}

TEST(RunControl, FastIsFourTimesAsFastByKeyAndBySwitch) {
    Controlled level;
    level.run.runOrStop();
    level.pictures(4, 1.0 / 60, false, true);
    EXPECT_NEAR(static_cast<double>(level.frame()), 16, 1);
    auto const before = level.frame();
    level.run.speed().switchFast();
    level.pictures(4);
    EXPECT_NEAR(static_cast<double>(level.frame() - before), 16, 1);
    level.run.speed().switchFast();
    EXPECT_EQ(level.run.speed().now(), 1);
}

TEST(RunControl, EverySpeedComputesTheSameWorld) {
    std::uint64_t hash = 0;
    for (double const wanted : speeds) {
        Controlled level;
        while (level.run.speed().now() > wanted) {
            level.run.speed().slower();
        }
        while (level.run.speed().now() < wanted) {
            level.run.speed().faster();
        }
        level.run.runOrStop();
        level.pictures(static_cast<int>(96 / wanted));
        EXPECT_EQ(level.frame(), 96U) << wanted;
        EXPECT_TRUE(hash == 0 || hash == level.session.world().stateHash()) << wanted;
        hash = level.session.world().stateHash();
        level.run.stop();
        EXPECT_EQ(level.run.speed().now(), wanted) << "a player who tries again need not choose again";
    }
}

TEST(RunControl, AFilmHasEveryFrameOnce) {
    Controlled level;
    level.run.runOrStop();
    level.pictures(5, 0.5, true, true);
    EXPECT_EQ(level.frame(), 5U) << "however long a picture takes";
    EXPECT_EQ(level.run.alpha(), 1);
}

TEST(RunControl, ComputesTheSameAsTheSessionAlone) {
    Controlled level;
    level.run.runOrStop();
    level.pictures(90);
    Session alone(gameData().registry, gameData().parts, level.session.level());
    for (int i = 0; i < 90; ++i) {
        alone.step();
    }
    EXPECT_EQ(level.session.world().stateHash(), alone.world().stateHash());
}

TEST(RunControl, AReplayHasTheSameBits) {
    Controlled level;
    level.run.runOrStop();
    level.pictures(120);
    ObjectId const lever = level.session.world().store().find("switch");
    ASSERT_TRUE(lever.valid());
    level.session.feed({PlayerInput::Kind::grab, lever, {}, {0, 1}});
    level.pictures(20);
    level.session.feed({PlayerInput::Kind::release, lever, {}, {0, 1}});
    level.pictures(20);
    auto const hash = level.session.world().stateHash();
    auto const frame = level.frame();
    EXPECT_FALSE(level.run.watching());
    level.run.watchAgain();
    EXPECT_TRUE(level.run.watching());
    EXPECT_EQ(level.frame(), 0U);
    level.pictures(static_cast<int>(frame));
    EXPECT_EQ(level.session.world().stateHash(), hash);
    level.run.stop();
    EXPECT_FALSE(level.run.watching());
}

} // namespace
} // namespace trembler::ui::test
