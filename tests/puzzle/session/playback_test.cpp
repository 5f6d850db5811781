// Recorded inputs are repeated in their frames, and a repeated run is bit for bit the same.
#include "puzzle/session/playback.hpp"
#include "tests/support/experiment.hpp"

#include <rapidcheck.h>

#include <algorithm>

namespace trembler {
namespace {

class PlaybackTest : public Experiment {
protected:
    static RecordedInput input(std::uint64_t frame, PlayerInput::Kind kind, std::string object,
                               Vec2 at = {}) {
        RecordedInput made;
        made.frame = frame;
        made.kind = kind;
        made.object = std::move(object);
        made.at = at;
        return made;
    }
    using Kind = PlayerInput::Kind;
};

// Compared with a search of the whole list, whose order is kept within a frame.
TEST_F(PlaybackTest, ReturnsTheInputsOfEachFrameInOrder) {
    EXPECT_TRUE(rc::check([](std::vector<std::uint8_t> const& frames) {
        std::vector<RecordedInput> inputs;
        std::vector<RecordedChange> changes;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            inputs.push_back(input(frames[i] % 7U, Kind::move, "", {static_cast<double>(i), 0}));
            changes.emplace_back();
            changes.back().frame = frames[i] % 5U;
            changes.back().value = static_cast<double>(i);
        }
        Playback const playback(inputs, changes);
        for (std::uint64_t frame = 0; frame < 9; ++frame) {
            std::vector<double> expected;
            std::vector<double> found;
            for (RecordedInput const& each : inputs) {
                if (each.frame == frame) {
                    expected.push_back(each.at.x);
                }
            }
            for (RecordedInput const& each : playback.inputsOf(frame)) {
                found.push_back(each.at.x);
            }
            RC_ASSERT(found == expected);
            expected.clear();
            found.clear();
            for (RecordedChange const& each : changes) {
                if (each.frame == frame) {
                    expected.push_back(each.value);
                }
            }
            for (RecordedChange const& each : playback.changesOf(frame)) {
                found.push_back(each.value);
            }
            RC_ASSERT(found == expected);
        }
    }));
    EXPECT_TRUE(Playback().inputsOf(1).empty());
    EXPECT_TRUE(Playback().changesOf(1).empty());
}

TEST_F(PlaybackTest, RepeatsARunBitForBit) {
    LevelFile const level = load("2-doorbell.json");
    Solution const& solution = *level.findSolution("hit the bell with the switch");
    auto inputs = solution.inputs;
    std::reverse(inputs.begin(), inputs.end()); // each is in a different frame
    RecordedChange change;
    change.kind = RecordedChange::Kind::setting;
    change.subject = "solver";
    change.field = "substeps";
    change.value = 2;
    change.frame = 30;
    std::vector<std::uint64_t> hashes;
    Playback playback(inputs, {change});
    for (int times = 0; times < 2; ++times) {
        LevelRun run(gameData().registry, gameData().parts, level, {}, {});
        run.begin();
        while (run.world().frame() < 90) {
            playback.feed(run);
            run.step();
        }
        hashes.push_back(run.world().stateHash());
        EXPECT_EQ(run.inputs().size(), 5U) << "of the first 90 frames";
        EXPECT_EQ(run.changes().size(), 1U);
        playback = Playback({run.inputs().begin(), run.inputs().end()},
                            {run.changes().begin(), run.changes().end()});
    }
    EXPECT_EQ(hashes[1], hashes[0]);
    LevelRun untouched(gameData().registry, gameData().parts, level, {}, {});
    untouched.begin();
    while (untouched.world().frame() < 90) {
        untouched.step();
    }
    EXPECT_NE(untouched.world().stateHash(), hashes[0]);
}

TEST_F(PlaybackTest, LeavesOutInputsForObjectsThatDoNotExist) {
    LevelFile const level = load("2-doorbell.json");
    LevelRun run(gameData().registry, gameData().parts, level, {}, {});
    run.begin();
    RecordedInput cut = input(1, Kind::cut, "switch");
    cut.other = "nobody";
    Playback const playback({input(1, Kind::grab, "wooden wedge 1"), cut, input(1, Kind::grab, "switch"),
                             input(2, Kind::release, "")},
                            {});
    playback.feed(run);
    ASSERT_EQ(run.inputs().size(), 1U);
    EXPECT_EQ(run.inputs()[0].object, "switch");
    run.step();
    playback.feed(run);
    ASSERT_EQ(run.inputs().size(), 2U) << "an input that releases names no object";
    EXPECT_EQ(run.inputs()[1].kind, Kind::release);
    EXPECT_EQ(run.inputs()[1].frame, 2U);
}

} // namespace
} // namespace trembler
