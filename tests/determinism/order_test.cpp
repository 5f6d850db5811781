// The order of entries in a level file, and the order in which a player places parts, never matter.
#include "runtime/level/read/read_level.hpp"
#include "tests/determinism/level_runs.hpp"
#include "tests/support/attempts.hpp"
#include "tests/support/sanitizer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace trembler::determinism {
namespace {

// std::shuffle differs between standard libraries; this algorithm does not.
void shuffle(nlohmann::json& list, std::mt19937& random) {
    for (std::size_t i = list.size(); i > 1; --i) {
        std::swap(list[i - 1], list[random() % i]);
    }
}

TEST(Order, OfEntriesInAFileNeverMatters) {
    // Once: every other level shuffled, the others reversed. TREMBLER_FUZZ=12 is the long version.
    unsigned const attempts = test::underSanitizer ? 1 : test::attempts(1);
    std::mt19937 random(20120601);
    bool reverses = false;
    for (auto const& path : gameData().levels()) {
        reverses = !reverses;
        auto const document = JsonDocument::load(path);
        auto const expected = hashesOf(readLevel(gameData().registry, document));
        for (unsigned attempt = 0; attempt < attempts; ++attempt) {
            nlohmann::json shuffled = document->root();
            for (char const* const list : {"objects", "joints", "connections", "toolbox", "placing"}) {
                if (shuffled.contains(list)) {
                    if (attempt == 0 && reverses) {
                        std::reverse(shuffled[list].begin(), shuffled[list].end());
                    } else {
                        shuffle(shuffled[list], random);
                    }
                }
            }
            for (auto& solution : shuffled["solutions"]) {
                if (solution.contains("placements")) {
                    shuffle(solution["placements"], random);
                }
            }
            auto const level =
                readLevel(gameData().registry, JsonDocument::parse(shuffled.dump(), path.string()));
            ASSERT_EQ(expected, hashesOf(level)) << path << ", attempt " << attempt;
        }
    }
}

TEST(Order, OfPlacingNeverMatters) {
    for (auto const& path : gameData().levels()) {
        LevelFile const level = loadLevel(gameData().registry, path);
        for (Solution const& solution : level.solutions) {
            std::vector<Placement> placements = solution.placements;
            if (placements.size() < 2) {
                continue;
            }
            std::vector<std::uint64_t> hashes;
            for (int way = 0; way < 2; ++way) {
                Session session(gameData().registry, gameData().parts, level);
                for (Placement const& placement : placements) {
                    ASSERT_TRUE(session.place(placement))
                        << path << ", " << solution.name << ": " << session.check(placement).why;
                }
                for (std::uint64_t frame = 0; frame < 120; ++frame) {
                    session.step();
                }
                hashes.push_back(session.world().stateHash());
                std::reverse(placements.begin(), placements.end());
            }
            EXPECT_EQ(hashes[0], hashes[1]) << path << ", " << solution.name;
        }
    }
}

} // namespace
} // namespace trembler::determinism
