// The same bits from every compiler and every optimisation level: compares with hashes in the repository.
// After an intended change of the simulation, or of the data that the state hash covers, run
// TREMBLER_UPDATE_GOLDEN=1 test_determinism, and give the reason in the commit. If only the state hash covers
// more, the hashes of the motion must not change.
#include "runtime/level/read/read_level.hpp"
#include "tests/determinism/level_runs.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>

namespace trembler::determinism {
namespace {

// A name as a part of a JSON pointer (RFC 6901).
std::string escaped(std::string const& name) {
    std::string all;
    for (char const c : name) {
        all += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    }
    return all;
}

std::filesystem::path const goldenFile =
    std::filesystem::path(TREMBLER_SOURCE_DIR) / "tests/determinism/golden.json";

TEST(Golden, HashesOfEveryLevelAreThoseOfTheGoldenFile) {
    nlohmann::ordered_json now;
    for (auto const& path : gameData().levels()) {
        auto& level = now[gameData().shortName(path)];
        for (auto const& [run, hashes] : hashesOf(loadLevel(gameData().registry, path))) {
            level[run] = {{"state", hashes.state}, {"motion", hashes.motion}};
        }
    }
    if (std::getenv("TREMBLER_UPDATE_GOLDEN") != nullptr) {
        std::ofstream(goldenFile) << now.dump(1) << "\n";
        GTEST_SKIP() << "wrote " << goldenFile;
    }
    std::ifstream file(goldenFile);
    ASSERT_TRUE(file) << goldenFile;
    auto const golden = nlohmann::ordered_json::parse(file);
    // A line for each difference: the file is long.
    for (auto const* const all : {&golden, &std::as_const(now)}) {
        for (auto const& [level, ofLevel] : all->items()) {
            for (auto const& [run, hashes] : ofLevel.items()) {
                for (char const* const what : {"state", "motion"}) {
                    auto const at =
                        nlohmann::json::json_pointer("/" + escaped(level) + "/" + escaped(run) + "/" + what);
                    if (all == &golden) {
                        EXPECT_TRUE(now.contains(at) && now.at(at) == golden.at(at))
                            << "the " << what << " of " << level << ", " << run;
                    } else {
                        EXPECT_TRUE(golden.contains(at)) << level << ", " << run << " has no recorded hash";
                    }
                }
            }
        }
    }
}

} // namespace
} // namespace trembler::determinism
