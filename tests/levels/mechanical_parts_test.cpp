// The behaviour of the mechanical parts, compared with the laws of mechanics.
#include "tests/levels/part_trial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trembler {
namespace {

constexpr double gravity = 9.81;

TEST(MechanicalParts, CogsTurnOneAnotherByTheRatioOfTheirTeeth) {
    struct Pair {
        char const* driver;
        char const* driven;
        double ratio; // of their teeth
    };
    // Placed exactly, 2 cm too far, 2 cm too close, and turned by 2 degrees.
    struct Slip {
        double away;
        double degrees;
    };
    for (Pair const pair : {Pair{"small cog", "large cog", 0.5}, Pair{"large cog", "small wooden cog", 2},
                            Pair{"small wooden cog", "large wooden cog", 0.5}}) {
        for (Slip const slip : {Slip{0, 0}, Slip{0.02, 0}, Slip{-0.02, 0}, Slip{0, 2}}) {
            PartTrial trial;
            trial.put(pair.driver, "driver", {0, 0})
                .put(pair.driven, "driven", {0.9 + slip.away, 0}, slip.degrees);
            trial.drive("driver", {0, 0}, 90).seconds(60);
            EXPECT_NEAR(trial.degrees("driver"), 5400, 10) << pair.driver << ' ' << slip.away;
            EXPECT_NEAR(trial.degrees("driven"), slip.degrees - 5400 * pair.ratio, 15)
                << pair.driver << ' ' << pair.driven << ' ' << slip.away;
        }
    }
}

TEST(MechanicalParts, CogsMeshInEveryDirectionAndInAChain) {
    PartTrial trial;
    trial.put("large cog", "hub", {0, 0});
    trial.put("small cog", "right", {0.9, 0}).put("small cog", "left", {-0.9, 0});
    trial.put("small cog", "above", {0, 0.9}).put("small wooden cog", "below", {0, -0.9});
    trial.put("small wooden cog", "next", {1.5, 0}, 15); // of equal cogs one is turned by half a tooth
    trial.drive("hub", {0, 0}, -45).seconds(40);
    for (char const* cog : {"right", "left", "above", "below"}) {
        EXPECT_NEAR(trial.degrees(cog), 3600, 20) << cog;
    }
    EXPECT_NEAR(trial.degrees("next"), 15 - 3600, 30);
}

TEST(MechanicalParts, CurrentFlowsThroughATrainOfCogsIfAllAreMetal) {
    for (double const speed : {0.0, 60.0}) {
        for (double const away : {-0.02, 0.0, 0.02}) {
            for (bool const metal : {true, false}) {
                PartTrial trial;
                trial.put("battery +", "plus", {-3, 2})
                    .put("battery −", "minus", {3, 2})
                    .put("lamp", "lamp", {1.5, 2});
                trial.put("large cog", "first", {0, 0}).put("small cog", "last", {1.5 + away, 0}, 15);
                trial.put(metal ? "small cog" : "small wooden cog", "middle", {0.9 + away, 0});
                trial.connect("plus", "first").connect("last", "lamp").connect("lamp", "minus");
                trial.drive("first", {0, 0}, speed).seconds(2);
                for (int frame = 0; frame < 300; ++frame) {
                    trial.run(1);
                    ASSERT_EQ(trial.on("lamp"), metal) << speed << ' ' << away << " frame " << frame;
                }
            }
        }
    }
}

TEST(MechanicalParts, ThePulleyIsAtwoodsMachine) {
    PartTrial trial;
    trial.put("pulley", "pulley", {0, 0});
    trial.put("iron weight", "left", {-0.45, -1.315}).put("brass weight", "right", {0.45, -1.315}).run(10);
    double const before = trial.velocity("right").y;
    trial.run(20);
    double const left = trial.mass("left") + trial.mass("pulley left hook");
    double const right = trial.mass("right") + trial.mass("pulley right hook");
    EXPECT_NEAR((trial.velocity("right").y - before) * 3, gravity * (left - right) / (left + right), 0.02);
}

TEST(MechanicalParts, TheSeesawTipsToTheGreaterMoment) {
    struct Case {
        double arm; // m, of the weight on the right; the other one's is 1 m
        int side;
    };
    for (Case const c : {Case{1, 0}, Case{1.08, -1}, Case{0.92, 1}}) {
        PartTrial trial;
        trial.floor().put("seesaw", "seesaw", {0, 0.3});
        trial.put("iron weight", "left", {-1, 0.76}).put("iron weight", "right", {c.arm, 0.76}).seconds(3);
        double const angle = trial.degrees("seesaw beam");
        EXPECT_NEAR(angle, c.side * 22, 1) << c.arm;
    }
}

TEST(MechanicalParts, TheSpringGivesWayByHookesLaw) {
    PartTrial trial;
    trial.put("spring", "spring", {0, 0}).put("brass weight", "load", {0, 0.35}).seconds(60);
    double const load = trial.mass("load") + trial.mass("spring plate");
    EXPECT_NEAR(0.22 - trial.at("spring plate").y, load * gravity / 5000, 0.002);
    EXPECT_NEAR(trial.velocity("load").y, 0, 0.005);
    PartTrial empty;
    empty.put("spring", "spring", {0, 0}).seconds(2);
    EXPECT_NEAR(empty.at("spring plate").y, 0.22, 0.01) << "it carries its own plate";
}

TEST(MechanicalParts, TheTrampolineThrowsEverythingBack) {
    for (char const* ball : {"steel ball", "wooden ball", "rubber ball", "glass ball"}) {
        PartTrial trial;
        trial.put("trampoline", "trampoline", {0, 0}).put(ball, "ball", {0, 1.5});
        trial.seconds(0.6);
        double highest = -1;
        for (int frame = 0; frame < 60; ++frame) {
            highest = std::max(highest, trial.run(1).at("ball").y);
        }
        EXPECT_GT(highest, 0.3 + 0.7 * 1.2) << ball;
        EXPECT_LT(highest, 1.5) << ball;
    }
}

TEST(MechanicalParts, RopeAndChainHoldWhatHangsOnTheirHooks) {
    struct Line {
        char const* part;
        double hook; // m, of the hook's eye
    };
    for (Line const line : {Line{"rope", -1.36}, Line{"chain", -1.31}}) {
        for (char const* load : {"iron weight", "brass weight", "bucket"}) {
            double const grip = std::string(load) == "bucket" ? 0.52 : 0.2;
            PartTrial trial;
            trial.put(line.part, "line", {0, 0}).put(load, "load", {0.02, line.hook - 0.205 - grip});
            trial.seconds(20);
            EXPECT_NEAR(trial.at("line hook").y, line.hook, 0.02) << line.part << ' ' << load;
            EXPECT_NEAR(trial.at("load").y, line.hook - 0.2 - grip, 0.03) << line.part << ' ' << load;
        }
    }
}

TEST(MechanicalParts, TheChainConductsFromItsBracketToItsHookAndTheRopeDoesNot) {
    PartTrial trial;
    trial.put("battery +", "plus", {-3, 2}).put("battery −", "minus", {3, 2}).put("lamp", "lamp", {1.5, 2});
    trial.put("chain", "chain", {0, 0}).connect("plus", "chain");
    trial.put("brass weight", "load", {0, -1.715}).connect("load", "lamp").connect("lamp", "minus");
    trial.seconds(5);
    EXPECT_TRUE(trial.on("lamp"));
}

TEST(MechanicalParts, TheBeltTurnsTheSmallWheelTwiceAsFast) {
    PartTrial trial;
    trial.put("belt", "belt", {0, 0}).drive("belt", {-0.6, 0}, 90).seconds(60);
    EXPECT_NEAR(trial.degrees("belt"), 5400, 5);
    EXPECT_NEAR(trial.degrees("belt small wheel"), 10800, 10);
}

TEST(MechanicalParts, ThePendulumHasThePeriodOfItsMomentOfInertia) {
    PartTrial trial;
    trial.put("pendulum", "pendulum", {0, 0}, 10);
    std::vector<double> zeros; // s, when it passes downwards from the right
    double before = 10;
    for (int frame = 1; frame <= 1200; ++frame) {
        double const now = trial.run(1).degrees("pendulum bob");
        if (before > 0 && now <= 0) {
            zeros.push_back((frame - now / (now - before)) / 60);
        }
        before = now;
    }
    // A disc of 0.16 m at 1 m and a rod, 0.8 m by 0.03 m, whose middle is at 0.45 m.
    double const disc = std::numbers::pi * 0.16 * 0.16;
    double const rod = 0.8 * 0.03;
    double const inertia =
        disc * (0.16 * 0.16 / 2 + 1) + rod * ((0.8 * 0.8 + 0.03 * 0.03) / 12 + 0.45 * 0.45);
    double const moment = disc * 1 + rod * 0.45;
    double const wide = 1 + 0.0019; // for 10 degrees
    ASSERT_GE(zeros.size(), 5U);
    EXPECT_NEAR((zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1),
                wide * 2 * std::numbers::pi * std::sqrt(inertia / (gravity * moment)), 0.01);
}

TEST(MechanicalParts, CartAndTruckRollOnTheirWheels) {
    PartTrial trial;
    trial.floor()
        .put("cart", "cart", {-5, 0.26}, 0, R"("velocity": [2, 0])")
        .put("steel ball", "load", {-5, 0.5}, 0, R"("velocity": [2, 0])");
    trial.put("truck", "truck", {5, 0.41}).put("crate", "crate", {9, 0.3});
    trial.seconds(1.5);
    EXPECT_GT(trial.at("cart").x, -3.5);
    EXPECT_NEAR(trial.at("load").x, trial.at("cart").x, 0.5) << "it stays on the cart";
    EXPECT_GT(trial.at("load").y, 0.4);
    double const start = trial.at("truck").x;
    trial.seconds(1);
    // 400 degrees a second at a radius of 0.2 m.
    EXPECT_NEAR(trial.at("truck").x - start, 400 * std::numbers::pi / 180 * 0.2, 0.05);
    trial.seconds(5);
    EXPECT_GT(trial.at("crate").x, 10) << "the truck pushes it";
    EXPECT_NEAR(trial.degrees("truck"), 0, 3);
}

TEST(MechanicalParts, TheBucketHoldsBalls) {
    PartTrial trial;
    trial.floor().put("bucket", "bucket", {0, 0.31});
    for (int i = 0; i < 3; ++i) {
        trial.put("wooden ball", "ball " + std::to_string(i), {i == 1 ? -0.18 : 0.18, 1 + 0.4 * i});
    }
    trial.seconds(8);
    for (int i = 0; i < 3; ++i) {
        EXPECT_LT(std::abs(trial.at("ball " + std::to_string(i)).x - trial.at("bucket").x), 0.3) << i;
    }
    EXPECT_NEAR(trial.degrees("bucket"), 0, 5);
}

TEST(MechanicalParts, TheFlapIsAFloorFromAboveAndOpensFromBelow) {
    PartTrial above;
    above.put("flap", "flap", {0, 0}).put("steel ball", "ball", {0.6, 0.6}).seconds(3);
    EXPECT_NEAR(above.degrees("flap flap"), 0, 1);
    EXPECT_GT(above.at("ball").y, 0.2);
    PartTrial below;
    below.put("flap", "flap", {0, 0}).put("wooden ball", "ball", {0.8, -0.7}, 0, R"("velocity": [0, 6])");
    EXPECT_GT(below.seconds(0.4).degrees("flap flap"), 20);
}

TEST(MechanicalParts, TheSwingDoorOpensAndTheSlidingDoorDoesNot) {
    PartTrial swing;
    swing.floor()
        .put("door", "door", {0, 0.75})
        .put("steel ball", "ball", {-1, 0.16}, 0, R"("velocity": [3, 0])");
    EXPECT_GT(swing.seconds(3).at("ball").x, 1);
    PartTrial slide;
    slide.floor()
        .put("sliding door", "door", {0, 0})
        .put("steel ball", "ball", {-1, 0.16}, 0, R"("velocity": [3, 0])");
    EXPECT_LT(slide.seconds(3).at("ball").x, 0);
}

TEST(MechanicalParts, DominoesPassThePushOn) {
    PartTrial trial;
    trial.floor();
    for (int i = 0; i < 8; ++i) {
        trial.put("domino", "domino " + std::to_string(i), {0.3 * i, 0.25});
    }
    trial.put("wooden ball", "ball", {-1, 0.35}, 0, R"("velocity": [2.5, 0])").seconds(6);
    for (int i = 0; i < 8; ++i) {
        EXPECT_LT(trial.degrees("domino " + std::to_string(i)), -45) << i;
    }
    PartTrial still;
    still.floor().put("domino", "domino", {0, 0.25}).seconds(20);
    EXPECT_NEAR(still.degrees("domino"), 0, 0.5);
}

} // namespace
} // namespace trembler
