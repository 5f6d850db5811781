// Conversion of files of older versions into those of the present one.
#include "runtime/level/model/level.hpp"
#include "runtime/level/read/migrations.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace migrations_test {
namespace {

TEST(Migrations, AChainWithoutAGapLeadsToThePresentVersion) {
    int next = 0;
    for (LevelMigration const& migration : levelMigrations()) {
        EXPECT_EQ(migration.from, next++);
    }
    EXPECT_EQ(next, levelVersion);
}

TEST(Migrations, TheDraftsGravityAndToolboxAreMoved) {
    nlohmann::json old{{"version", 0}, {"gravity", {0, -3.7}}};
    migrate(old, 0);
    EXPECT_EQ(old["world"]["gravity"][1], -3.7);
    EXPECT_FALSE(old.contains("gravity"));
    nlohmann::json toolbox{{"version", 0}, {"toolbox", {{"thing", 2}, {"other", 1}}}};
    migrate(toolbox, 0);
    EXPECT_EQ(toolbox["toolbox"], nlohmann::json::parse(R"([{"part": "other", "count": 1},
        {"part": "thing", "count": 2}])"));
    // Properties that the world already states are not replaced.
    nlohmann::json both{{"gravity", 1}, {"world", {{"gravity", 2}}}};
    migrate(both, 0);
    EXPECT_EQ(both, nlohmann::json::parse(R"({"world": {"gravity": 2}})"));
}

TEST(Migrations, TheMaterialOfALookBecomesThatOfTheObject) {
    // The material was part of the look, and determined only the sound.
    nlohmann::json looks = nlohmann::json::parse(R"({"version": 1, "objects": [
        {"name": "own", "properties": {"look": {"material": "steel", "label": "x"}, "friction": 0.2}},
        {"name": "wall", "properties": {"look": {"material": "brick"}, "fixed": true}},
        {"name": "part", "part": "crate", "properties": {"look": {"material": "glass"}}}, 7]})");
    migrate(looks, 1);
    EXPECT_EQ(looks["objects"][0]["properties"], nlohmann::json::parse(R"({"material": "steel",
        "look": {"label": "x"}, "friction": 0.2, "restitution": 0, "density": 1000, "conductor": false,
        "magnetic_strength": false})"));
    EXPECT_EQ(looks["objects"][1]["properties"], nlohmann::json::parse(R"({"material": "brick",
        "fixed": true, "friction": 0.5, "restitution": 0, "conductor": false, "magnetic_strength": false})"));
    EXPECT_EQ(looks["objects"][2]["properties"], nlohmann::json::parse(R"({"look": {"pattern": "glass"}})"));
    // A liquid had a density even if it was fixed; an object with a stated mass needs none.
    nlohmann::json water = nlohmann::json::parse(R"({"objects": [
        {"properties": {"look": {"material": "water"}, "fixed": true, "liquid": true}},
        {"properties": {"look": {"material": "oak"}, "mass": 3}}]})");
    migrate(water, 1);
    EXPECT_EQ(water["objects"][0]["properties"]["density"], 1000);
    EXPECT_FALSE(water["objects"][1]["properties"].contains("density"));
}

// Values that a step does not understand are left to the reader, which reports them.
TEST(Migrations, KeepUnknownAndNewValues) {
    for (char const* const text :
         {R"({"objects": 3})", R"({"objects": [{"properties": []}, {"properties": {"look": "red"}}]})",
          R"({"toolbox": 7})", R"({"toolbox": [{"part": "a", "count": 1}]})", R"({"world": 5})", R"({})"}) {
        nlohmann::json const before = nlohmann::json::parse(text);
        nlohmann::json after = before;
        migrate(after, 0);
        EXPECT_EQ(after, before) << text;
    }
    nlohmann::json const strange = nlohmann::json::parse(R"({"gravity": 1, "world": 5})");
    nlohmann::json kept = strange;
    migrate(kept, 0);
    EXPECT_EQ(kept["world"], 5) << "no place for the gravity";
    nlohmann::json const present =
        nlohmann::json::parse(R"({"objects": [{"properties": {"look": {"material": "steel"}}}]})");
    nlohmann::json same = present;
    migrate(same, levelVersion);
    EXPECT_EQ(same, present);
}

} // namespace
} // namespace migrations_test
} // namespace trembler
