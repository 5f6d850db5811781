// A recorded run shows every frame as it was: compared by the hashes of all columns and by every recorded
// value.
#include "insight/timeline/again.hpp"
#include "insight/timeline/recording.hpp"
#include "insight/timeline/stage.hpp"
#include "tests/support/experiment.hpp"

#include <filesystem>
#include <map>

namespace trembler::insight {
namespace {

class RecordingTest : public Experiment {
protected:
    /// The state of all objects and their properties, and of all slots.
    static std::pair<std::uint64_t, Words> stateOf(World const& world) {
        Words words;
        WordWriter out(words);
        for (RecordedSlot const& slot : recordedSlots()) {
            slot.write(world.store(), out);
        }
        return {world.store().hash(), words};
    }
    [[nodiscard]] Stage stage() {
        return Stage([this] { return buildAgain(gameData().registry, session()); });
    }
    /// Runs the open session and records it; returns the state in each frame.
    std::map<std::uint64_t, std::pair<std::uint64_t, Words>> record(Recording& recording,
                                                                    std::uint64_t frames) {
        auto const run = buildAgain(gameData().registry, session());
        run->begin();
        Playback const playback = playback_;
        recording.begin(run->world(), run->judge());
        std::map<std::uint64_t, std::pair<std::uint64_t, Words>> states;
        states[0] = stateOf(run->world());
        while (run->world().frame() < frames) {
            playback.feed(*run);
            run->step();
            recording.add(run->world(), run->judge());
            states[run->world().frame()] = stateOf(run->world());
        }
        return states;
    }
    void openWith(LevelFile level, std::string const& solution) {
        Solution const* const found = level.findSolution(solution);
        playback_ = found == nullptr ? Playback() : Playback(found->inputs, found->changes);
        open(std::move(level), solution);
    }

    Playback playback_;
};

// Every level of the pack, in an order of frames that goes back and forth.
TEST_F(RecordingTest, ShowsEveryFrameOfEveryLevelBitForBit) {
    std::size_t levels = 0;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(TREMBLER_SOURCE_DIR "/levels")) {
        std::string const path = entry.path().string();
        if (entry.path().extension() != ".json" || path.find("schema") != std::string::npos ||
            path.find("chapter") != std::string::npos || path.find("mods") != std::string::npos) {
            continue;
        }
        LevelFile level;
        try {
            level = loadLevel(gameData().registry, path);
        } catch (std::exception const&) {
            continue; // of a mod, or not a level
        }
        SCOPED_TRACE(path);
        openWith(level, level.solutions.empty() ? "" : level.solutions.front().name);
        Recording recording;
        auto const states = record(recording, 150);
        ASSERT_EQ(recording.last(), 150U);
        ASSERT_EQ(recording.frames(), 151U);
        Stage shown = stage();
        for (std::uint64_t const frame : {150U, 3U, 64U, 63U, 127U, 128U, 1U, 0U, 149U, 0U, 150U}) {
            shown.show(recording, frame);
            ASSERT_EQ(shown.frame(), frame);
            auto const [hash, words] = stateOf(shown.world());
            ASSERT_EQ(hash, states.at(frame).first) << "columns in frame " << frame;
            Words expected = states.at(frame).second;
            ASSERT_EQ(words, expected) << "slots in frame " << frame;
        }
        ++levels;
    }
    EXPECT_GT(levels, 20U);
}

TEST_F(RecordingTest, KeepsWithinItsMemoryAndThinsTheOldestFirst) {
    openWith(load("2-doorbell.json"), "hit the bell with the switch");
    Recording all;
    auto const states = record(all, 4000);
    std::size_t const most = all.bytes() * 3 / 4;
    Recording recording(most);
    record(recording, 4000);
    EXPECT_LE(recording.bytes(), most);
    EXPECT_LT(recording.frames(), all.frames());
    EXPECT_EQ(recording.last(), 4000U);
    // The remaining frames are still exact, and the gaps grow towards the beginning.
    Stage shown = stage();
    std::uint64_t early = 0;
    std::uint64_t late = 0;
    for (auto frame = std::optional<std::uint64_t>(0); frame; frame = recording.after(*frame)) {
        (*frame <= 2000 ? early : late) += 1;
        shown.show(recording, *frame);
        ASSERT_EQ(stateOf(shown.world()).first, states.at(*frame).first) << *frame;
    }
    EXPECT_LT(early, late);
    EXPECT_EQ(early + late, recording.frames());
    // Backwards it is the same list.
    std::size_t back = 1;
    for (auto frame = recording.before(4000); frame; frame = recording.before(*frame)) {
        ++back;
    }
    EXPECT_EQ(back, recording.frames());
}

TEST_F(RecordingTest, GoesOnAfterFramesWereForgotten) {
    openWith(load("2-doorbell.json"), "hit the bell with the switch");
    for (std::uint64_t const cut : {200U, 100U, 64U, 63U, 10U, 0U}) {
        Recording recording;
        auto const states = record(recording, 300);
        recording.forgetAfter(cut);
        ASSERT_EQ(recording.last(), cut);
        auto const run = buildAgain(gameData().registry, session());
        run->begin();
        while (run->world().frame() < 300) {
            playback_.feed(*run);
            run->step();
            recording.add(run->world(), run->judge());
        }
        ASSERT_EQ(recording.frames(), 301U);
        Stage shown = stage();
        for (std::uint64_t frame = 0; frame <= 300; frame += 7) {
            shown.show(recording, frame);
            ASSERT_EQ(stateOf(shown.world()).first, states.at(frame).first) << cut << ": " << frame;
        }
    }
}

// Frames of a very large world are packed at once: 128 of them, as they are, could take gigabytes.
TEST_F(RecordingTest, KeepsFewFramesAsTheyAreWhereTheyAreLarge) {
    openWith(load("2-doorbell.json"), "hit the bell with the switch");
    auto const run = buildAgain(gameData().registry, session());
    run->begin();
    Playback const playback = playback_;
    Recording usual;
    usual.begin(run->world(), run->judge());
    std::size_t largest = 0;
    std::map<std::uint64_t, std::uint64_t> hashes;
    constexpr std::size_t most = 40'000;
    Recording small(most);
    small.begin(run->world(), run->judge());
    while (run->world().frame() < 200) {
        playback.feed(*run);
        run->step();
        usual.add(run->world(), run->judge());
        small.add(run->world(), run->judge());
        hashes[run->world().frame()] = run->world().store().hash();
        largest = std::max(largest, usual.bytes());
        ASSERT_LE(small.bytes(), 2 * most) << run->world().frame();
    }
    EXPECT_GT(largest, 4 * most) << "otherwise the world is too small to show anything";
    EXPECT_EQ(small.last(), 200U);
    EXPECT_GT(small.frames(), 3U);
    Stage shown = stage();
    std::size_t frames = 0;
    for (auto frame = small.after(0); frame; frame = small.after(*frame)) {
        shown.show(small, *frame);
        ASSERT_EQ(shown.world().store().hash(), hashes.at(*frame)) << *frame;
        ++frames;
    }
    EXPECT_GE(frames + 1, small.frames());
}

} // namespace
} // namespace trembler::insight
