#include "insight/run/level_runs.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "puzzle/run/runner.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <map>
#include <thread>

namespace trembler::insight {
namespace {

LevelFile levelOf(std::string const& name) {
    return loadLevel(gameData().registry, gameData().home / "levels" / (name + ".json"));
}

constexpr char const* firstContactFile = "first/1-first-contact";
constexpr char const* experiment1 = "experiments/1-switched-electromagnet";

TEST(LevelRuns, EndAsTheSessionsRunsDo) {
    LevelFile const level = levelOf(firstContactFile);
    LevelRuns const runs(gameData(), level);
    for (Solution const& solution : level.solutions) {
        RunResult const result = runs.run({solution}, {.frames = 200, .stopWhenSolved = false});
        ASSERT_FALSE(result.fault) << *result.fault;
        WorldOptions options;
        options.detail = level.detail;
        Session session(gameData().registry, gameData().parts, level, options);
        session.load(solution);
        RunOptions asUsual;
        asUsual.frames = 200;
        RunReport const report = trembler::run(session, "", asUsual);
        EXPECT_EQ(result.stateHash, report.stateHash) << solution.name;
        EXPECT_EQ(result.solvedFrame, report.solvedFrame) << solution.name;
    }
}

TEST(LevelRuns, AreTheSameInSeveralThreadsAtOnce) {
    LevelFile const level = levelOf(experiment1);
    LevelRuns const runs(gameData(), level);
    Variation const variation{{}, {withoutEffect("magnetism")}};
    std::vector<std::uint64_t> hashes(4);
    std::vector<std::thread> threads;
    for (std::uint64_t& hash : hashes) {
        threads.emplace_back([&] { hash = runs.run(variation, {.frames = 120}).stateHash; });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(hashes, std::vector<std::uint64_t>(4, hashes.front()));
}

TEST(LevelRuns, WithoutAPlacementTheLevelIsNotSolved) {
    LevelFile const level = levelOf(firstContactFile);
    LevelRuns const runs(gameData(), level);
    Solution const& solution = *level.findSolution("the spanner");
    EXPECT_TRUE(runs.run({solution}, {}).solved);
    EXPECT_FALSE(runs.run({solution, {withoutPlacement(0)}}, {.frames = 600}).solved);
}

TEST(LevelRuns, AContactThatIsLeftOutNeverBegins) {
    LevelRuns const runs(gameData(), levelOf(experiment1));
    bool touched = false;
    RunObserver observer;
    observer.frame = [&](LevelRun const& run) {
        Store const& store = run.world().store();
        ObjectId const a = store.find("switch");
        ObjectId const b = store.find("object 1");
        Contacts const* const contacts = run.world().find<Contacts>();
        for (auto const* const list : {&contacts->current, &contacts->brief}) {
            for (TouchingPair const& pair : *list) {
                touched = touched || (pair.a == std::min(a, b) && pair.b == std::max(a, b));
            }
        }
        return true;
    };
    RunResult const usual = runs.run({}, {.frames = 200}, observer);
    EXPECT_TRUE(usual.solved);
    EXPECT_TRUE(touched);
    touched = false;
    RunResult const varied =
        runs.run({{}, {withoutContact("switch", "object 1")}}, {.frames = 200}, observer);
    EXPECT_FALSE(varied.solved);
    EXPECT_FALSE(touched);
}

TEST(LevelRuns, ADipThatIsLeftOutLiftsNothing) {
    LevelRuns const runs(gameData(), levelOf("experiments/4-raft"));
    std::map<std::string, double> lift; // N, by object
    RunObserver observer;
    observer.end = [&](LevelRun const& run) {
        for (BuoyancyForce::Entry const& entry : run.world().find<BuoyancyForce>()->forces) {
            lift[run.world().store().nameOf(entry.object)] = entry.force.y;
        }
    };
    (void)runs.run({}, {.frames = 60}, observer);
    EXPECT_GT(lift["flotation device A"], 50);
    EXPECT_GT(lift["flotation device B"], 50);
    lift.clear();
    LeftOut const dip = withoutDip("flotation device A", "water body", 20);
    (void)runs.run({{}, {dip}}, {.frames = 60}, observer);
    EXPECT_EQ(lift.count("flotation device A"), 0U);
    EXPECT_GT(lift["flotation device B"], 50);
    // Before that frame nothing is different.
    EXPECT_EQ(runs.run({}, {.frames = 19}).stateHash, runs.run({{}, {dip}}, {.frames = 19}).stateHash);
}

TEST(LevelRuns, OtherContactsStayAsTheyAre) {
    LevelRuns const runs(gameData(), levelOf(experiment1));
    // The two never touch.
    RunResult const usual = runs.run({}, {.frames = 200});
    RunResult const varied = runs.run({{}, {withoutContact("switch", "ceiling")}}, {.frames = 200});
    EXPECT_EQ(usual.solvedFrame, varied.solvedFrame);
}

TEST(LevelRuns, FromALaterFrameTheContactEnds) {
    LevelRuns const runs(gameData(), levelOf(experiment1));
    RunResult const early = runs.run({{}, {withoutContact("object 1", "switch", 50)}}, {.frames = 300});
    EXPECT_FALSE(early.solved);
    RunResult const late = runs.run({{}, {withoutContact("object 1", "switch", 100)}}, {.frames = 300});
    EXPECT_TRUE(late.solved);
}

TEST(LevelRuns, WithoutAnEffectItDoesNothing) {
    LevelRuns const runs(gameData(), levelOf(experiment1));
    EXPECT_FALSE(runs.run({{}, {withoutEffect("magnetism")}}, {.frames = 200}).solved);
    EXPECT_FALSE(runs.run({{}, {withoutEffect("electricity")}}, {.frames = 200}).solved);
    EXPECT_TRUE(runs.run({{}, {withoutEffect("buoyancy")}}, {.frames = 200}).solved);
}

TEST(LevelRuns, WhatCannotBeLeftOutIsAFaultInWords) {
    LevelRuns const runs(gameData(), levelOf(experiment1));
    for (LeftOut const& one :
         {withoutPlacement(0), withoutWire(99), withoutInput(3), withoutEffect("dynamics")}) {
        RunResult const result = runs.run({{}, {one}}, {.frames = 10});
        ASSERT_TRUE(result.fault);
        EXPECT_FALSE(result.fault->empty());
        EXPECT_EQ(result.frames, 0U);
    }
}

} // namespace
} // namespace trembler::insight
