// The ladders, with tiny scenes: every ladder is complete, and levels are exact where they must be. Times are
// not tested.
#include "measure/accuracy/ladder.hpp"
#include "measure/accuracy/report.hpp"
#include "puzzle/data/game_data.hpp"
#include "tests/measure/accuracy/three_rungs.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace trembler::accuracy {
namespace ladders_test {
namespace {

std::vector<Ladder> const& ladders() {
    static std::vector<Ladder> const all = climb(gameData(), {}, {.brief = true, .runs = 1});
    return all;
}

Ladder const& ladder(std::string const& effect, std::string const& words) {
    for (Ladder const& one : ladders()) {
        if (one.effect == effect && one.scene.find(words) != std::string::npos) {
            return one;
        }
    }
    throw std::logic_error("no such ladder: " + words);
}

double errorOf(Ladder const& in, std::string const& level) {
    auto const found = std::find_if(in.rungs.begin(), in.rungs.end(),
                                    [&](Rung const& rung) { return rung.level.starts_with(level); });
    return found == in.rungs.end() ? std::numeric_limits<double>::quiet_NaN() : found->error;
}

TEST(Accuracy, EveryLadderIsComplete) {
    std::set<std::string> effects;
    std::set<std::string> names;
    for (Ladder const& one : ladders()) {
        SCOPED_TRACE(one.effect + ": " + one.scene);
        effects.insert(one.effect);
        EXPECT_TRUE(names.insert(slugOf(one)).second) << "two plots with the same name";
        EXPECT_FALSE(one.unit.empty());
        EXPECT_FALSE(one.error.empty());
        EXPECT_FALSE(one.reference.empty());
        EXPECT_GE(one.rungs.size(), 2U);
        std::set<std::string> levels;
        bool front = false;
        for (Rung const& rung : one.rungs) {
            SCOPED_TRACE(rung.level);
            EXPECT_TRUE(levels.insert(rung.level).second);
            EXPECT_FALSE(rung.cannotRepresent.empty())
                << "every level has something that it cannot represent";
            EXPECT_TRUE(std::isfinite(rung.error) && rung.error >= 0) << rung.error;
            EXPECT_TRUE(std::isfinite(rung.microseconds) && rung.microseconds > 0) << "its time was measured";
            EXPECT_EQ(rung.onFront, one.rivals && rung.beatenBy.empty());
            front = front || rung.onFront;
        }
        EXPECT_EQ(front, one.rivals);
    }
    EXPECT_EQ(effects, (std::set<std::string>{"dynamics", "gravity", "electricity", "magnetism", "buoyancy",
                                              "sound", "co-simulation"}));
}

TEST(Accuracy, ErrorsAreTheSameEveryTime) {
    auto const again = climb(gameData(), {"gravity", "dynamics", "electricity"}, {.brief = true, .runs = 1});
    for (Ladder const& one : again) {
        Ladder const& first = ladder(one.effect, one.scene);
        for (std::size_t i = 0; i < one.rungs.size(); ++i) {
            EXPECT_EQ(one.rungs[i].error, first.rungs[i].error) << one.scene << ", " << one.rungs[i].level;
        }
    }
}

// Semi-implicit Euler errs by g t h / 2 in a fall: first order in the substep h, and known in metres.
TEST(Accuracy, AThrownBallsErrorIsThatOfEulersSteps) {
    Ladder const& ball = ladder("dynamics", "ball");
    for (int const substeps : {1, 2, 4, 8}) {
        double const fallen = 29.0 / 60;
        double const expected = 9.81 * fallen / 2 / 60 / substeps;
        EXPECT_NEAR(errorOf(ball, std::to_string(substeps) + " substep"), expected, 0.02 * expected);
    }
    for (std::string const scene : {"pendulum", "swings down"}) {
        Ladder const& one = ladder("dynamics", scene);
        for (std::size_t i = 1; i < one.rungs.size(); ++i) {
            if (one.rungs[i].level == "automatic substeps") { // an ordinary scene gets four
                EXPECT_EQ(one.rungs[i].error, errorOf(one, "4 substeps")) << scene;
            } else {
                EXPECT_LT(one.rungs[i].error, 0.7 * one.rungs[i - 1].error) << scene;
            }
        }
    }
}

// A force that is held for a frame but integrated in n substeps lags by (1 - 1/n)/2 of a frame. An
// oscillation's energy grows at ω² times the lag; ω² is 9.81 / 0.1 m for a box with half of its 0.2 m under
// water.
TEST(Accuracy, GravitysAndMagnetismsLadders) {
    for (Ladder const* const one : {&ladder("gravity", "stars"), &ladder("magnetism", "bar magnets"),
                                    &ladder("magnetism", "north poles")}) {
        double before = 1;
        for (std::string const angle : {"0.7", "0.5", "0.35", "0.25", "0.15"}) {
            double const now = errorOf(*one, "tree, opening angle " + angle);
            EXPECT_LE(now, 1.1 * before) << one->scene << " " << angle;
            before = now;
        }
        EXPECT_LT(before, 2e-3) << one->scene;
        EXPECT_LT(one->rungs.back().error, 1e-13) << "all pairs, in double precision";
    }
    EXPECT_EQ(errorOf(ladder("gravity", "stars"), "linear"), 1) << "there is no external field";
    double const ground = errorOf(ladder("gravity", "on Earth"), "linear");
    EXPECT_GT(ground, 1e-7);
    EXPECT_LT(ground, 2 * 50 / 6.371e6 + 1e-6) << "weight falls by 2 h / R";
    Ladder const& bars = ladder("magnetism", "bar magnets");
    EXPECT_GT(errorOf(bars, "grid, cutoff 1 m"), errorOf(bars, "grid, cutoff 8 m"));
    Ladder const& dipoles = ladder("magnetism", "two bars");
    for (double const lengths : {5.0, 10.0}) { // 5/3 (l/r)² and 7/3 (l/r)⁴, reduced by the softening
        double const series = 5.0 / 3 / std::pow(lengths, 2) + 7.0 / 3 / std::pow(lengths, 4);
        double const found = errorOf(dipoles, "two poles, " + std::to_string(static_cast<int>(lengths)));
        EXPECT_NEAR(found, series, 10 * 0.0025 / std::pow(0.2 * lengths, 2)) << lengths;
    }
    // Poles alone: (r/l)²/6 of the dipoles' force, reduced by the softening.
    EXPECT_NEAR(errorOf(dipoles, "one pole, 5 lengths"), 25.0 / 6 - 1, 0.02);
}

TEST(Accuracy, BuoyancysAndSoundsLadders) {
    Ladder const& cuts = ladder("buoyancy", "one float");
    EXPECT_LT(errorOf(cuts, "exact"), 1e-14) << "the level 'exact' has no error";
    EXPECT_GT(errorOf(cuts, "4 particles"), 5 * errorOf(cuts, "256 particles"));
    EXPECT_EQ(errorOf(ladder("buoyancy", "now and then"), "every frame"), 0);
    EXPECT_GT(errorOf(ladder("buoyancy", "now and then"), "every 3 frames"), 0);
    Ladder const& sound = ladder("sound", "fall");
    ASSERT_EQ(sound.rungs.size(), 5U);
    EXPECT_EQ(sound.rungs.back().error, 0);
    EXPECT_GT(errorOf(sound, "1-mode"), errorOf(sound, "16-modes"));
    EXPECT_GT(errorOf(sound, "1-mode"), 1) << "something was heard";
}

// Registered levels are included automatically, without a list.
TEST(Accuracy, ElectricitysLevelsAreThoseOfTheRegistry) {
    std::set<std::string> registered;
    for (Registration const& one : gameData().registry.components()) {
        if (one.info->text.effect == "electricity" && one.info->kind == ComponentKind::dps &&
            !one.info->text.level.empty()) {
            registered.emplace(one.info->text.level);
        }
    }
    std::set<std::string> measured;
    for (Rung const& rung : ladder("electricity", "schoolbook").rungs) {
        measured.insert(rung.level);
    }
    EXPECT_EQ(measured, registered);
    for (std::string const scene : {"schoolbook", "random"}) {
        Ladder const& one = ladder("electricity", scene);
        EXPECT_GT(errorOf(one, "two-wire"), 0.05) << "it cannot represent a balanced bridge";
        EXPECT_GT(errorOf(one, "single-cable"), errorOf(one, "two-wire"));
        if (registered.contains("nodal")) {
            EXPECT_EQ(errorOf(one, "nodal"), 0);
        }
    }
}

// Currents compared with ngspice if it is installed, else with elimination.
TEST(Accuracy, OnlyNodalComputesAmperes) {
    for (std::string const scene : {"schoolbook circuits, how much", "random, how much"}) {
        Ladder const& one = ladder("electricity", scene);
        EXPECT_EQ(one.unit, "A");
        EXPECT_LT(errorOf(one, "nodal"), 1e-8) << one.reference;
        for (std::string const level : {"two-wire", "single-cable", "flow"}) {
            EXPECT_GT(errorOf(one, level), 0.05) << level << ", " << scene;
        }
        EXPECT_LE(errorOf(one, "two-wire"), errorOf(one, "single-cable")) << scene;
    }
}

TEST(AccuracyFront, ContainsTheLevelsThatNoOtherBeats) {
    Ladder one = threeRungs();
    markFront(one);
    EXPECT_EQ(one.rungs[0].beatenBy, "");
    EXPECT_EQ(one.rungs[1].beatenBy, "cheap");
    EXPECT_EQ(one.rungs[2].beatenBy, "");
    EXPECT_EQ(one.rungs[3].beatenBy, "") << "two percent count as equal";
    EXPECT_EQ(one.rungs[4].beatenBy, "cheap");
    one.rivals = false;
    markFront(one);
    for (Rung const& rung : one.rungs) {
        EXPECT_FALSE(rung.onFront);
    }
}

TEST(Accuracy, AnUnknownEffectIsRefusedWithTheKnownOnes) {
    try {
        static_cast<void>(climb(gameData(), {"gravitty"}, {.brief = true, .runs = 1}));
        FAIL();
    } catch (std::invalid_argument const& error) {
        EXPECT_EQ(std::string(error.what()), "no ladder for the effect \"gravitty\"; the effects with "
                                             "ladders are: dynamics, gravity, electricity, "
                                             "magnetism, buoyancy, sound, co-simulation");
    }
}

} // namespace
} // namespace ladders_test
} // namespace trembler::accuracy
