#include "runtime/level/write/write_level.hpp"
#include "tests/levels/level_kit.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

std::uint64_t hashOf(LevelFile const& level, std::vector<Placement> const& placements) {
    return buildWorld(levelKit().registry, level, levelKit().parts, placements)->stateHash();
}

void expectSurvives(LevelFile const& level) {
    std::string const text = levelText(level);
    LevelFile const again = readLevel(levelKit().registry, JsonDocument::parse(text, "written.json"));
    EXPECT_EQ(levelText(again), text); // a second reading and writing loses nothing
    EXPECT_EQ(hashOf(again, {}), hashOf(level, {}));
    ASSERT_EQ(again.solutions.size(), level.solutions.size());
    for (std::size_t i = 0; i < level.solutions.size(); ++i) {
        EXPECT_EQ(hashOf(again, again.solutions[i].placements), hashOf(level, level.solutions[i].placements));
        EXPECT_EQ(again.solutions[i].inputs.size(), level.solutions[i].inputs.size());
        EXPECT_EQ(again.solutions[i].changes.size(), level.solutions[i].changes.size());
        EXPECT_EQ(again.solutions[i].solves, level.solutions[i].solves);
    }
    EXPECT_EQ(again.goals, level.goals);
    EXPECT_EQ(again.hints, level.hints);
    EXPECT_EQ(again.demonstration, level.demonstration);
}

TEST(WriteLevel, KeepsEveryBitOfEveryLevel) {
    expectSurvives(readLevel(levelKit().registry, JsonDocument::parse(sampleLevel(), "sample.json")));
    for (auto const& file : levelFiles()) {
        SCOPED_TRACE(file);
        expectSurvives(loadLevel(levelKit().registry, file));
    }
}

TEST(WriteLevel, WritesALevelMadeByAnEditor) {
    LevelFile level;
    level.title = "new";
    level.placing.emplace();
    LevelObject object;
    object.name = "a";
    object.part = "crate";
    level.objects.push_back(object);
    level.connections.push_back({"a", "b", ""});
    EXPECT_EQ(
        writeLevel(level).dump(),
        R"({"version":2,"title":"new","objects":[{"name":"a","part":"crate"}],"connections":[["a","b"]],"placing":[]})");
    EXPECT_THROW((void)buildWorld(levelKit().registry, level, levelKit().parts),
                 InputError); // b does not exist
}

} // namespace
} // namespace trembler
