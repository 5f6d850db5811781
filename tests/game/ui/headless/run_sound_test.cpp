// trembler run --sound: the sound of the levels as files.
#include "game/ui/headless/run_sound.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/audio/device/wav.hpp"
#include "tests/audio/synth/spectrum.hpp"
#include "tests/support/game_data.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <unistd.h>

namespace trembler::ui::test {
namespace {

namespace fs = std::filesystem;
using trembler::test::toneIn;
using trembler::test::Wav;

class RunSoundTest : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) / ("run sound " + std::to_string(getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    Wav hear(LevelFile level, std::string const& solution, std::uint64_t frames,
             std::uint64_t* hash = nullptr, std::vector<fs::path> const& recordings = {},
             std::vector<std::string>* reports = nullptr) {
        Session session(gameData().registry, gameData().parts, std::move(level));
        if (!solution.empty()) {
            Solution const* const recorded = session.level().findSolution(solution);
            EXPECT_NE(recorded, nullptr) << solution;
            session.load(*recorded);
        }
        RunOptions options;
        options.frames = frames;
        fs::path const file = folder / "heard.wav";
        {
            LoudspeakerOptions how;
            how.sampleFolders = recordings;
            RunSound sound(
                file, how,
                [&](std::string const& what) {
                    if (reports != nullptr) {
                        reports->push_back(what);
                    }
                },
                options);
            RunReport const report = run(session, "a level", options);
            sound.finish();
            if (hash != nullptr) {
                *hash = report.stateHash;
            }
        }
        return Wav(file);
    }
    static LevelFile doorbell() {
        return loadLevel(gameData().registry, gameData().home / "levels/experiments/2-doorbell.json");
    }

    fs::path folder;
};

// The power within a relative distance of a frequency, on either side.
double powerAround(std::span<float const> samples, double frequency, double share) {
    std::vector<double> const power = trembler::test::powerSpectrum(samples);
    double const step = 48000.0 / (2 * static_cast<double>(power.size()));
    double sum = 0;
    for (auto k = static_cast<std::size_t>(frequency * (1 - share) / step);
         static_cast<double>(k) * step <= frequency * (1 + share) && k < power.size(); ++k) {
        sum += power[k];
    }
    return sum;
}

TEST_F(RunSoundTest, TheDoorbellRingsWithThePartialsOfABell) {
    Wav const heard = hear(doorbell(), "", 600);
    ASSERT_EQ(heard.left.size(), 600 * 800U);
    std::span<float const> const ringing = std::span(heard.left).last(5 * 48000);
    // Hum, prime, tierce, quint and nominal of a bell whose prime is at 880 Hz, and little between them.
    for (double const ratio : {0.5, 1.0, 1.2, 1.5, 2.0}) {
        double const at = powerAround(ringing, 880 * ratio, 0.02);
        double const beside =
            powerAround(ringing, 880 * ratio * 0.93, 0.02) + powerAround(ringing, 880 * ratio * 1.07, 0.02);
        EXPECT_GT(at, 10 * beside) << 880 * ratio << " Hz";
    }
}

TEST_F(RunSoundTest, AWoodenClipOnTheContactLeavesTheBellSilent) {
    auto const prime = [](Wav const& wav) {
        return powerAround(std::span(wav.left).last(5 * 48000), 880, 0.02);
    };
    double const bell = prime(hear(doorbell(), "", 600));
    double const clip = prime(hear(doorbell(), "a wooden clip on the contact", 600));
    EXPECT_LT(clip, 1e-4 * bell);
}

// The same bell, struck by the same ball.
TEST_F(RunSoundTest, ABellStruckHarderIsLouderAndBrighter) {
    double power = 0;
    double brightness = 0;
    for (double const speed : {0.5, 2.0, 8.0}) {
        std::string const text = fmt::format(R"({{
            "version": 2, "title": "A bell", "text": "It is struck.",
            "world": {{"gravity": [0, 0], "bounds": [-2, -1, 4, 2]}},
            "objects": [
                {{"name": "bell", "part": "bell", "at": [0, 0]}},
                {{"name": "ball", "part": "steel ball", "at": [-0.6, -0.05],
                  "properties": {{"velocity": [{}, 0]}}}}
            ]
        }})",
                                             speed);
        Wav const heard =
            hear(readLevel(gameData().registry, JsonDocument::parse(text, "bell.json")), "", 120);
        auto const begin = std::find_if(heard.left.begin(), heard.left.end(), [](float s) { return s != 0; });
        ASSERT_GT(heard.left.end() - begin, 24000) << speed;
        auto const sound = std::span(&*begin, 24000);
        EXPECT_GT(trembler::test::meanSquareIn(sound), 1.5 * power) << speed;
        EXPECT_GT(trembler::test::centroid(sound, 48000), brightness) << speed;
        power = trembler::test::meanSquareIn(sound);
        brightness = trembler::test::centroid(sound, 48000);
    }
}

// A recording beside the level: a tone that no mode of a rubber ball has.
TEST_F(RunSoundTest, ALevelsOwnRecordingIsHeard) {
    constexpr int length = 24000;
    std::ofstream wav(folder / "tone.wav", std::ios::binary);
    auto const number = [&](auto value) { wav.write(reinterpret_cast<char const*>(&value), sizeof value); };
    wav << "RIFF";
    number(std::uint32_t{36 + 2 * length});
    wav << "WAVEfmt ";
    for (std::uint32_t const n : {16U, 0x10001U, 48000U, 96000U, 0x100002U}) { // mono, 16 bits
        number(n);
    }
    wav << "data";
    number(std::uint32_t{2 * length});
    for (int n = 0; n < length; ++n) {
        number(static_cast<std::int16_t>(10000 * std::sin(2 * pi * 3137.0 * n / 48000)));
    }
    wav.close();
    std::string const text = R"({
        "version": 2, "title": "A recording", "text": "It is played where the ball lands.",
        "world": {"gravity": [0, -9.81], "bounds": [-2, -1, 4, 2]},
        "objects": [
            {"name": "floor", "at": [0, -0.5], "properties": {"fixed": true, "material": "stone",
                "shape": [{"form": "box", "width": 4, "height": 0.2}]}},
            {"name": "ball", "part": "rubber ball", "at": [0, 0.2],
             "properties": {"sample": {"file": "tone.wav", "cue": "struck", "full_impulse": 0.001,
                                       "duration": 0.5}}}
        ]
    })";
    auto const level = [&] {
        return readLevel(gameData().registry, JsonDocument::parse(text, "level.json"));
    };
    auto const tone = [](Wav const& heard) {
        return std::abs(toneIn(std::span(heard.left).subspan(24000, 12000), 48000, 3137));
    };
    std::vector<std::string> warnings;
    double const played = tone(hear(level(), "", 60, nullptr, {folder}, &warnings));
    EXPECT_TRUE(warnings.empty());
    double const missing = tone(hear(level(), "", 60, nullptr, {}, &warnings));
    EXPECT_EQ(warnings.size(), 1U) << "a missing recording is reported once";
    EXPECT_GT(played, 10 * missing);
}

TEST_F(RunSoundTest, ListeningIsTheSameEveryTimeAndChangesNothing) {
    std::uint64_t hash = 0;
    Wav const once = hear(doorbell(), "", 120, &hash);
    Wav const again = hear(doorbell(), "", 120);
    EXPECT_EQ(once.bytes, again.bytes);
    Session deaf(gameData().registry, gameData().parts, doorbell());
    RunOptions options;
    options.frames = 120;
    EXPECT_EQ(run(deaf, "a level", options).stateHash, hash);
}

TEST_F(RunSoundTest, ALevelInWhichNothingMovesIsSilent) {
    LevelFile const level = readLevel(gameData().registry, JsonDocument::parse(R"({
        "version": 2, "title": "Still", "text": "Nothing happens.",
        "world": {"gravity": [0, -9.81]},
        "objects": [{"name": "bell", "part": "bell", "at": [0, 1]}]
    })",
                                                                               "still.json"));
    Wav const heard = hear(level, "", 60);
    ASSERT_EQ(heard.left.size(), 60 * 800U);
    EXPECT_EQ(trembler::test::meanSquareIn(heard.left), 0);
    EXPECT_EQ(trembler::test::meanSquareIn(heard.right), 0);
}

} // namespace
} // namespace trembler::ui::test
