// No level and no random world pops: true peaks and steps of the mix. sweep_peaks measures whole runs.
#include "puzzle/goals/level_schema.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/json_document.hpp"
#include "tests/levels/level_kit.hpp"
#include "tests/peaks/mix.hpp"
#include "tests/support/game_data.hpp"
#include "tests/worlds/random_level.hpp"

#include <gtest/gtest.h>

namespace trembler::peaks {
namespace {

// A world whose parts are at odds at the start pops in its first frames; sounds begin a frame after impacts.
constexpr std::uint64_t firstFrames = 8;

TEST(Peaks, NoLevelBeginsWithAPop) {
    int runs = 0;
    for (auto const& path : gameData().levels()) {
        LevelFile const level = loadLevel(gameData().registry, path);
        std::string const solution = level.solutions.empty() ? "" : level.solutions.front().name;
        Mix const mix = mixOf(gameData().registry, gameData().parts, level, solution, firstFrames);
        EXPECT_EQ(faultOf(mix), "") << gameData().shortName(path);
        ++runs;
    }
    EXPECT_GT(runs, 30);
}

// Two rings of copper overlap, and nothing moves: at full scale before impulses were bounded by energy.
TEST(Peaks, TurnAndCurrentBeginsQuietly) {
    LevelFile const level =
        loadLevel(gameData().registry, gameData().home / "levels/first/7-turn-and-current.json");
    Mix const mix = mixOf(gameData().registry, gameData().parts, level, "the metal cog", 24);
    EXPECT_LT(mix.truePeak, -15);
    EXPECT_LT(mix.step, 0.1);
}

// The loudest moments of the levels: the limiter holds them, and does no more.
TEST(Peaks, TheLoudestLevelsStayBelowFullScale) {
    struct Loud {
        char const* level;
        char const* solution;
        std::uint64_t frames;
    };
    for (Loud const& loud : {Loud{"levels/5-everything/5-two-yes-one-no.json", "the relay says no", 150},
                             Loud{"levels/sound/1-loud-enough.json", "rubber rings no bell", 150}}) {
        LevelFile const level = loadLevel(gameData().registry, gameData().home / loud.level);
        Mix const mix = mixOf(gameData().registry, gameData().parts, level, loud.solution, loud.frames);
        EXPECT_EQ(faultOf(mix), "") << loud.level;
        EXPECT_GT(mix.truePeak, -6) << loud.level;
    }
}

TEST(Peaks, NoRandomWorldPops) {
    RandomMixes mixes;
    for (int i = 0; i < 12; ++i) {
        auto const [seed, mix] = mixes.next(6);
        EXPECT_EQ(faultOf(mix), "") << seed;
    }
}

} // namespace
} // namespace trembler::peaks
