// The targets that take bytes for a file: the kept inputs, and changed ones.
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/fuzz/files/corpus.hpp"
#include "tests/fuzz/files/kit.hpp"
#include "tests/fuzz/targets.hpp"

namespace trembler::files {
namespace {

TEST(FuzzedFiles, LevelsHold) {
    fuzzTarget("level", fuzzLevel, 150);
}

TEST(FuzzedFiles, PartsHold) {
    fuzzTarget("part", fuzzPart, 150);
}

TEST(FuzzedFiles, ReplaysHold) {
    fuzzTarget("replay", fuzzReplay, 100);
}

TEST(FuzzedFiles, ModManifestsHold) {
    fuzzTarget("mod_manifest", fuzzModManifest, 150);
}

// Otherwise the fuzzers would only test refusals.
TEST(FuzzedFiles, KeptInputsAreMostlyAccepted) {
    std::size_t levels = 0;
    for (std::string const& bytes : keptInputs("level")) {
        Problems problems;
        static_cast<void>(readLevel(gameData().registry, JsonDocument::parse(bytes, "kept"), problems));
        levels += problems.empty() ? 1U : 0U;
    }
    EXPECT_GE(levels, 3U);
    LevelFile const level = loadLevel(gameData().registry, std::filesystem::path(TREMBLER_SOURCE_DIR) /
                                                               "levels/experiments/2-doorbell.json");
    std::size_t replays = 0;
    for (std::string const& bytes : keptInputs("replay")) {
        write(ownFolder() / "kept.json", bytes);
        try {
            static_cast<void>(
                findOrLoadSolution(gameData().registry, level, (ownFolder() / "kept.json").string()));
            ++replays;
        } catch (InputError const&) {
            continue;
        }
    }
    EXPECT_GE(replays, 2U);
}

} // namespace
} // namespace trembler::files
