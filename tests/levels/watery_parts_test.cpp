// The behaviour of the parts in water and in air, compared with Archimedes' principle.
#include "tests/levels/part_trial.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler {
namespace {

constexpr double surface = 0.42; // m, of the water tank's water above its middle

TEST(WateryParts, FloatExactlyIfTheyAreLighterThanWater) {
    struct Case {
        char const* part;
        bool floats;
    };
    for (Case const c :
         {Case{"cork", true}, Case{"log", true}, Case{"plastic ball", true}, Case{"wooden ball", true},
          Case{"small crate", true}, Case{"beach ball", true}, Case{"wheel", true}, Case{"float", true},
          Case{"stone ball", false}, Case{"glass ball", false}, Case{"copper ball", false},
          Case{"steel ball", false}, Case{"brass weight", false}, Case{"rubber ball", false}}) {
        PartTrial trial;
        trial.put("water tank", "tank", {0, 0}).put(c.part, "it", {0, 1}).seconds(20);
        double const y = trial.at("it").y;
        EXPECT_EQ(y > 0.1, c.floats) << c.part << " is at " << y;
        EXPECT_LT(std::abs(trial.at("it").x), 1.2) << c.part;
    }
}

TEST(WateryParts, AFloatingCrateLiesAsDeepAsItsDensitySays) {
    PartTrial trial;
    trial.put("water tank", "tank", {0, 0}).put("small crate", "crate", {0, 0.5}).seconds(30);
    EXPECT_NEAR(std::abs(std::remainder(trial.degrees("crate"), 90)), 0, 46); // a square floats on edge, too
    // A quarter of its area is under water.
    double const angle = std::abs(std::remainder(trial.degrees("crate"), 90));
    if (angle < 1) {
        EXPECT_NEAR(trial.at("crate").y, surface + 0.35 / 4, 0.01);
    } else {
        EXPECT_GT(trial.at("crate").y, surface);
    }
}

TEST(WateryParts, TheRaftCarriesALoadAndSinksDeeper) {
    PartTrial empty;
    empty.put("water tank", "tank", {0, 0}).put("raft", "raft", {0, 0.7}).seconds(20);
    PartTrial loaded;
    loaded.put("water tank", "tank", {0, 0}).put("raft", "raft", {0, 0.7}).put("wooden ball", "load", {0, 1});
    loaded.put("small crate", "stop", {0.45, 1}).seconds(20);
    double const deeper = empty.at("raft").y - loaded.at("raft").y;
    // Two floats, 0.5 m wide and 0.1 m deep, displace more water by the mass of the load.
    double const load = loaded.mass("load") + loaded.mass("stop");
    EXPECT_NEAR(deeper, load / (1000 * 2 * 0.5 * 0.1), 0.02);
    EXPECT_GT(loaded.at("load").y, loaded.at("raft").y);
}

TEST(WateryParts, BalloonsRiseAndHollowBallsFall) {
    for (char const* part : {"balloon", "foil balloon"}) {
        PartTrial trial;
        trial.put(part, "balloon", {0, 0}).seconds(5);
        double const speed = trial.velocity("balloon").y;
        EXPECT_GT(trial.at("balloon").y, 4) << part;
        EXPECT_EQ(trial.seconds(1).velocity("balloon").y < speed + 0.01, true)
            << "drag ends its acceleration";
        EXPECT_LT(speed, 5) << part;
        EXPECT_NEAR(trial.at("balloon").x, 0, 0.01) << "it rises straight";
    }
    PartTrial ball;
    ball.put("plastic ball", "ball", {0, 0})
        .put("beach ball", "big", {2, 0})
        .put("stone ball", "stone", {4, 0});
    ball.seconds(1.5);
    EXPECT_LT(ball.at("ball").y, -5);
    EXPECT_GT(ball.at("big").y, ball.at("stone").y + 0.5) << "air slows it down";
}

TEST(WateryParts, ABalloonSinksOnAWorldWithoutAir) {
    PartTrial trial(R"("gravity": [0, -1.62], "air": {"density": 0})");
    trial.put("balloon", "balloon", {0, 0}).seconds(2);
    EXPECT_NEAR(trial.velocity("balloon").y, -1.62 * 119 / 60, 0.01);
}

TEST(WateryParts, OnVenusABalloonLiftsAHollowBall) {
    PartTrial trial(R"("gravity": [0, -8.87], "air": {"density": 65})");
    trial.put("plastic ball", "ball", {0, 1}).put("balloon", "balloon", {0, 0}).seconds(3);
    EXPECT_GT(trial.at("ball").y, 1) << "it would sink by itself";
    PartTrial alone(R"("gravity": [0, -8.87], "air": {"density": 65})");
    alone.put("plastic ball", "ball", {0, 1}).seconds(3);
    EXPECT_LT(alone.at("ball").y, 0.5);
}

TEST(WateryParts, AFoilBalloonClosesACircuitUnderTheCeiling) {
    for (char const* part : {"foil balloon", "balloon"}) {
        PartTrial trial;
        trial.put("battery +", "plus", {-3, 2}).put("battery −", "minus", {3, 2}).put("lamp", "lamp", {2, 3});
        trial.put("copper contact", "left", {-0.24, 2}).put("copper contact", "right", {0.24, 2});
        trial.connect("plus", "left").connect("right", "lamp").connect("lamp", "minus");
        trial.put(part, "balloon", {0, 0}).seconds(8);
        EXPECT_EQ(trial.on("lamp"), std::string(part) == "foil balloon") << part;
    }
}

} // namespace
} // namespace trembler
