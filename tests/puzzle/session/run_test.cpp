// One run: the object made for each placement, and the log of inputs, which repeats the run.
#include "puzzle/session/run.hpp"
#include "runtime/level/model/world_change.hpp"
#include "runtime/placement.hpp"
#include "tests/support/experiment.hpp"

#include <set>

namespace trembler {
namespace {

class RunTest : public Experiment {
protected:
    static LevelRun runOf(LevelFile const& level, std::vector<Placement> const& placements = {}) {
        return {gameData().registry, gameData().parts, level, placements, {}};
    }
    static RecordedChange detail(std::string effect, std::string level) {
        RecordedChange change;
        change.kind = RecordedChange::Kind::detail;
        change.subject = std::move(effect);
        change.level = std::move(level);
        return change;
    }
};

TEST_F(RunTest, MapsPlacementsToObjects) {
    LevelFile const level = load("4-raft.json");
    std::vector<Placement> const placements{{"iron ball", {3, 1.5}, 0, ""},
                                            {"cargo box", {1, 1.5}, 0.25, ""},
                                            {"wooden ball", {2, 1.5}, 0, ""},
                                            {"cargo box", {-1, 1.5}, 0, ""},
                                            {"cargo box", {1, 1.5}, 0.25, ""}}; // equal to the second
    LevelRun run = runOf(level, placements);
    std::set<ObjectId> different;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        ObjectId const object = run.objectOf(i);
        different.insert(object);
        EXPECT_EQ(run.world().find<Position>(object)->value, placements[i].at);
        EXPECT_EQ(run.world().find<Rotation>(object)->angle, placements[i].angle);
        EXPECT_EQ(run.world().store().prototypeOf(object)->name, placements[i].part);
        EXPECT_EQ(run.placementOf(object), i);
    }
    EXPECT_EQ(different.size(), placements.size());
    for (char const* const other : {"world", "cargo 1", "raft body"}) {
        EXPECT_FALSE(run.placementOf(run.world().store().find(other))) << other;
    }
    run.begin();
    run.feed({PlayerInput::Kind::remove, run.objectOf(1), {}, {}});
    for (int i = 0; i < 4; ++i) {
        run.step();
    }
    EXPECT_FALSE(run.world().store().alive(run.objectOf(1)));
    EXPECT_FALSE(run.placementOf(run.objectOf(1)));
    EXPECT_EQ(run.placementOf(run.objectOf(4)), 4U) << "the equal placement became another object";
}

TEST_F(RunTest, LogsInputsAndChangesFromItsBeginning) {
    LevelFile const level = load("4-raft.json");
    LevelRun run = runOf(level);
    ObjectId const cargo = run.world().store().find("cargo 1");
    run.feed({PlayerInput::Kind::grab, cargo, {}, {0, 0}});
    run.change(detail("buoyancy", "particles"));
    EXPECT_TRUE(run.inputs().empty());
    EXPECT_TRUE(run.changes().empty());
    EXPECT_FALSE(run.begun());
    run.begin();
    EXPECT_EQ(run.begunWith().detail.at("buoyancy"), "particles");
    run.step();
    run.step();
    run.feed({PlayerInput::Kind::grab, cargo, {}, {0.5, 0.25}});
    run.change(detail("buoyancy", ""));
    EXPECT_EQ(run.begunWith().detail.at("buoyancy"), "particles") << "the run began with the same level";
    ASSERT_EQ(run.inputs().size(), 1U);
    EXPECT_EQ(run.inputs()[0].frame, 3U);
    EXPECT_EQ(run.inputs()[0].object, "cargo 1");
    EXPECT_EQ(run.inputs()[0].other, "");
    EXPECT_EQ(run.inputs()[0].at, (Vec2{0.5, 0.25}));
    ASSERT_EQ(run.changes().size(), 1U);
    EXPECT_EQ(run.changes()[0].frame, 3U);

    Solution recorded = run.record();
    EXPECT_TRUE(recorded.inputs.empty()) << "it belongs to no computed frame yet";
    ASSERT_EQ(recorded.changes.size(), 1U);
    EXPECT_EQ(inWords(recorded.changes[0]), "buoyancy: particles") << "the initial detail level of the run";
    EXPECT_EQ(recorded.frames, 2);
    run.step();
    recorded = run.record();
    EXPECT_EQ(recorded.inputs.size(), 1U);
    EXPECT_EQ(recorded.changes.size(), 2U);
    EXPECT_EQ(recorded.frames, 3);
    EXPECT_FALSE(run.whyNotRecorded());
}

TEST_F(RunTest, CountsAsNoSolutionOnceItWasAltered) {
    LevelFile const level = load("4-raft.json");
    LevelRun run = runOf(level);
    run.begin();
    run.step();
    EXPECT_FALSE(run.altered());
    EXPECT_FALSE(run.whyNotRecorded());
    std::uint64_t const before = run.world().stateHash();
    run.alter("first", {});
    EXPECT_EQ(run.world().stateHash(), before) << "the mark is not part of the world";
    ObjectId const cargo = run.world().store().find("cargo 1");
    run.alter("second", [&](World& world) { world.store().column<Velocity>().set(cargo, {{1, 0}}); });
    EXPECT_NE(run.world().stateHash(), before);
    EXPECT_EQ(run.altered(), "first");
    EXPECT_EQ(run.whyNotRecorded(), "first");
    EXPECT_FALSE(run.record().solves);
}

TEST_F(RunTest, TakesOverTheInitialSettingsOfAnotherRun) {
    LevelFile const level = load("4-raft.json");
    LevelRun first = runOf(level);
    first.change(detail("buoyancy", "particles"));
    RecordedChange period;
    period.kind = RecordedChange::Kind::period;
    period.subject = "Buoyancy Resolver";
    period.value = 5;
    first.change(period);
    first.begin();
    LevelRun second = runOf(level);
    EXPECT_NE(second.world().stateHash(), first.world().stateHash());
    second.takeOver(first.begunWith());
    second.begin();
    EXPECT_EQ(second.begunWith().detail, first.begunWith().detail);
    EXPECT_EQ(second.begunWith().periods, first.begunWith().periods);
    for (int i = 0; i < 30; ++i) {
        first.step();
        second.step();
    }
    EXPECT_EQ(second.world().stateHash(), first.world().stateHash());
    EXPECT_TRUE(second.changes().empty());
}

TEST_F(RunTest, TheJudgeSeesEveryFrame) {
    LevelFile const level = load("1-switched-electromagnet.json"); // solves itself
    LevelRun run = runOf(level);
    run.begin();
    while (!run.judge().solved() && run.world().frame() < 300) {
        run.step();
    }
    EXPECT_TRUE(run.judge().solved());
    EXPECT_EQ(run.judge().solvedFrame(), run.world().frame());
    EXPECT_TRUE(run.record().solves);
    EXPECT_FALSE(runOf(level).record().solves);
    EXPECT_FALSE(runOf(level).record().frames) << "no frame was computed";
}

} // namespace
} // namespace trembler
