// The same bits from every compiler and every optimisation level: hashes that are kept in the repository.
// After a change that is meant to change the simulation, or what the state hash covers:
// TREMBLER_UPDATE_GOLDEN=1 test_determinism, and say why in the commit. Where only the state hash covers
// more, the hashes of the motion stay.
#include "runtime/level/read_level.hpp"
#include "tests/determinism/level_runs.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

namespace trembler::determinism {
namespace {

std::filesystem::path const goldenFile =
    std::filesystem::path(TREMBLER_SOURCE_DIR) / "tests/determinism/golden.json";

TEST(Golden, HashesOfEveryLevelAreThoseOnRecord) {
    nlohmann::ordered_json now;
    for (auto const& path : workshop().levels()) {
        auto& level = now[workshop().shortName(path)];
        for (auto const& [run, hashes] : hashesOf(loadLevel(workshop().registry, path))) {
            level[run] = {{"state", hashes.state}, {"motion", hashes.motion}};
        }
    }
    if (std::getenv("TREMBLER_UPDATE_GOLDEN") != nullptr) {
        std::ofstream(goldenFile) << now.dump(1) << "\n";
        GTEST_SKIP() << "wrote " << goldenFile;
    }
    std::ifstream file(goldenFile);
    ASSERT_TRUE(file) << goldenFile;
    EXPECT_EQ(nlohmann::ordered_json::parse(file), now);
}

} // namespace
} // namespace trembler::determinism
