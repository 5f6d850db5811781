// Materials that say something else than the object is.
#include "puzzle/checks/checked_level.hpp"
#include "puzzle/checks/level_checks.hpp"
#include "puzzle/edit/problems/live_problems.hpp"
#include "puzzle/solutions/verify.hpp"
#include "runtime/file/output_file.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler {
namespace {

using nlohmann::json;

json levelOfOne(json const& properties) {
    json level = json::parse(R"({"version": 2, "title": "Matter", "world": {"bounds": [-2, -2, 4, 4]},
        "objects": [{"name": "thing", "at": [0, 0],
                     "properties": {"shape": [{"form": "box", "width": 1, "height": 1}]}}]})");
    level["objects"][0]["properties"].update(properties);
    return level;
}

std::vector<Diagnostic> problemsOf(json const& level) {
    auto const document = JsonDocument::parse(level.dump(1), "level.json");
    LevelCheckup const checkup = checkWholeLevel(edit::editData(), document);
    EXPECT_TRUE(checkup.playable) << "such a level can be played: " << level;
    return checkup.problems;
}

TEST(Matter, OfAnotherKindThanTheObjectIsNamed) {
    for (char const* const solid :
         {"steel", "iron", "copper", "wood", "glass", "rubber", "stone", "plastic", "brick", "gold"}) {
        EXPECT_TRUE(problemsOf(levelOfOne({{"material", solid}})).empty()) << solid;
        auto const found = problemsOf(levelOfOne({{"material", solid}, {"liquid", true}}));
        ASSERT_EQ(found.size(), 1U) << solid;
        EXPECT_EQ(found.front().path, "/objects/0/properties/material");
        EXPECT_NE(found.front().message.find("'thing' is a body of liquid"), std::string::npos);
    }
    EXPECT_TRUE(problemsOf(levelOfOne({{"material", "water"}, {"liquid", true}})).empty());
    EXPECT_TRUE(problemsOf(levelOfOne({{"liquid", true}, {"density", 900}})).empty());
    for (json const& more : {json::object(), json{{"fixed", true}}, json{{"density", 500}}}) {
        json properties = more;
        properties["material"] = "water";
        auto const found = problemsOf(levelOfOne(properties));
        ASSERT_EQ(found.size(), 1U) << properties;
        EXPECT_EQ(found.front().path, "/objects/0/properties/material");
        EXPECT_GT(found.front().line, 0U);
        EXPECT_NE(found.front().message.find("'thing' is a solid body"), std::string::npos);
        EXPECT_NE(found.front().expected.find("\"liquid\""), std::string::npos);
    }
}

TEST(Matter, OfAnObjectWithItsOwnAppearanceIsMeant) {
    json const drawing = json::parse(R"({"body": false, "shapes": [{"form": "circle", "radius": 0.1}]})");
    EXPECT_TRUE(problemsOf(levelOfOne({{"material", "water"}, {"drawing", drawing}})).empty());
}

PartDefinition partFrom(json const& part) {
    return readPart(edit::editData().registry, JsonDocument::parse(part.dump(), "part.json"));
}

// Of a part in the toolbox all that it is made of is looked at, however deep inside.
TEST(Matter, OfPiecesOfPiecesInTheToolboxIsNamed) {
    json const shape = json::parse(R"([{"form": "box", "width": 1, "height": 1}])");
    PartLibrary parts;
    parts.add(partFrom({{"name", "wet"}, {"properties", {{"shape", shape}, {"material", "water"}}}}));
    parts.add(partFrom({{"name", "dry"}, {"properties", {{"shape", shape}, {"material", "wood"}}}}));
    parts.add(partFrom({{"name", "pair"},
                        {"objects",
                         {{{"name", "one"}, {"part", "dry"}, {"at", {0, 0}}},
                          {{"name", "two"}, {"part", "wet"}, {"at", {2, 0}}}}}}));
    parts.add(
        partFrom({{"name", "nest"}, {"objects", {{{"name", "inner"}, {"part", "pair"}, {"at", {0, 0}}}}}}));
    parts.add(partFrom(
        {{"name", "mild"},
         {"objects",
          {{{"name", "one"}, {"part", "wet"}, {"at", {0, 0}}, {"properties", {{"material", "wood"}}}}}}}));
    for (auto const& [part, said] :
         std::vector<std::pair<std::string, std::string>>{{"wet", "'wet' is a solid body"},
                                                          {"pair", "'two' of 'pair' is a solid body"},
                                                          {"nest", "'inner two' of 'nest' is a solid body"},
                                                          {"mild", ""},
                                                          {"dry", ""}}) {
        json level = levelOfOne({{"material", "wood"}});
        level["toolbox"] = json::array({{{"part", part}, {"count", 1}}});
        Registry const& registry = edit::editData().registry;
        LevelFile const read = readLevel(registry, JsonDocument::parse(level.dump(1), "level.json"));
        std::vector<std::string> const doubts =
            doubtsAbout(parts, read, checkPlayable(registry, parts, read));
        ASSERT_EQ(doubts.size(), said.empty() ? 0U : 1U) << part;
        EXPECT_TRUE(said.empty() || doubts.front().find(said) != std::string::npos) << doubts.front();
    }
}

TEST(Matter, IsNamedByProblemsVerifyAndRun) {
    json const level = levelOfOne({{"material", "water"}});
    auto const document = JsonDocument::parse(level.dump(1), "level.json");
    std::string const expected = "'thing' is a solid body, but its material is water";
    LevelFile const read = readLevel(edit::editData().registry, document);
    auto const doubts = doubtsAbout(edit::editData().parts, read,
                                    checkPlayable(edit::editData().registry, edit::editData().parts, read));
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_NE(doubts.front().find(expected), std::string::npos) << doubts.front();
    EXPECT_NE(doubts.front().find("level.json:"), std::string::npos) << doubts.front();

    std::filesystem::path const file = std::filesystem::path(testing::TempDir()) / "matter.json";
    writeFile(file, level.dump(1));
    auto const failures = verifyLevel(edit::editData(), file);
    EXPECT_TRUE(std::any_of(failures.begin(), failures.end(), [&](auto const& failure) {
        return failure.find(expected) != std::string::npos;
    }));
    edit::LevelDocument const opened = edit::LevelDocument::open(edit::editData(), file);
    edit::LiveProblems problems;
    problems.refresh(opened);
    EXPECT_TRUE(problems.playable());
    auto const about =
        std::find_if(problems.all().begin(), problems.all().end(), [&](edit::Problem const& problem) {
            return problem.words().find(expected) != std::string::npos;
        });
    ASSERT_NE(about, problems.all().end());
    EXPECT_EQ(about->about, edit::Problem::About::object);
    EXPECT_EQ(about->name, "thing");
    std::filesystem::remove(file);
}

} // namespace
} // namespace trembler
