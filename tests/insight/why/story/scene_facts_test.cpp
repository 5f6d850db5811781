#include "insight/why/story/scene_facts.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace trembler::insight {
namespace {

/// `n` boxes in a row, each hinged to the next one, a fixed post that the last one is hinged to, and a box
/// hinged to the other side of the post.
SceneFacts factsOfChain(int n) {
    GameData const& data = gameData();
    nlohmann::json level = {{"version", 2}, {"title", "chain"}};
    auto const box = [&](std::string const& name, double x, bool fixed) {
        nlohmann::json properties = {{"material", "wood"},
                                     {"shape", {{{"form", "box"}, {"width", 0.1}, {"height", 0.1}}}}};
        if (fixed) {
            properties["fixed"] = true;
        }
        level["objects"].push_back({{"name", name}, {"at", {x, 0}}, {"properties", properties}});
    };
    auto const hinge = [&](std::string const& a, std::string const& b, double x) {
        level["joints"].push_back({{"form", "hinge"}, {"a", a}, {"b", b}, {"at", {x, 0}}});
    };
    for (int i = 0; i < n; ++i) {
        box(fmt::format("link {}", i), i, false);
        if (i > 0) {
            hinge(fmt::format("link {}", i - 1), fmt::format("link {}", i), i - 0.5);
        }
    }
    box("post", n, true);
    hinge(fmt::format("link {}", n - 1), "post", n - 0.5);
    box("beyond", n + 1, false);
    hinge("beyond", "post", n + 0.5);
    LevelFile const file = readLevel(data.registry, JsonDocument::parse(level.dump(1), "chain.json"));
    return factsOf(LevelRun(data.registry, data.parts, file, {}, {}));
}

TEST(SceneFacts, TieWhatJointsConnectThroughOthersButNotThroughFixedObjects) {
    SceneFacts const facts = factsOfChain(5);
    ASSERT_EQ(facts.tied.size(), 5U) << "neither the post nor what hangs on it alone";
    for (auto const& [name, group] : facts.tied) {
        EXPECT_EQ(group, facts.tied.at("link 0")) << name;
    }
    EXPECT_TRUE(facts.fixed.contains("post"));
}

TEST(SceneFacts, TieAThousandLinksWithOneNumberEach) {
    EXPECT_EQ(factsOfChain(1000).tied.size(), 1000U);
}

// Spokes of two kinds on an axle, and floats of one kind on a raft that no hinge holds.
TEST(SceneFacts, GiveTheSpokesOfAWheelRoles) {
    GameData const& data = gameData();
    auto const rolesOf = [&](char const* name) {
        LevelFile const file = loadLevel(data.registry, data.home / "levels/experiments" / name);
        return factsOf(LevelRun(data.registry, data.parts, file, {}, {})).roles;
    };
    auto const motor = rolesOf("3-electric-motor.json");
    ASSERT_EQ(motor.size(), 8U);
    for (int i = 1; i <= 8; ++i) {
        EXPECT_EQ(motor.at(fmt::format("spoke {}", i)), motor.at(i <= 4 ? "spoke 1" : "spoke 5")) << i;
    }
    EXPECT_NE(motor.at("spoke 1"), motor.at("spoke 5"));
    EXPECT_TRUE(rolesOf("4-raft.json").empty());
}

} // namespace
} // namespace trembler::insight
