#include "puzzle/data/published_schema.hpp"
#include "puzzle/goals/judging/object_finder.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/levels/level_kit.hpp"
#include "tests/levels/schema_validator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>

namespace trembler {
namespace {

std::string contentOf(std::filesystem::path const& path) {
    std::ifstream in(path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

TEST(Schema, IsThePublishedFile) {
    EXPECT_EQ(contentOf(sourceFolder() / "levels/level.schema.json"), publishedSchema().dump(2) + "\n")
        << "stale: run `trembler schema > levels/level.schema.json`";
}

TEST(Schema, AcceptsEveryLevelAndPart) {
    nlohmann::json const levels = publishedSchema();
    for (auto const& file : levelFiles()) {
        EXPECT_EQ(validate(levels, nlohmann::json::parse(contentOf(file))), std::vector<std::string>())
            << file;
    }
    EXPECT_EQ(validate(levels, nlohmann::json::parse(sampleLevel())), std::vector<std::string>());
    nlohmann::json const parts = publishedSchema(AuthoredFile::part);
    for (PartDefinition const* part : levelKit().parts.all()) {
        EXPECT_EQ(validate(parts, part->document->root()), std::vector<std::string>()) << part->name;
    }
}

TEST(Schema, KnowsWhatLevelsStateAboutScripts) {
    nlohmann::json const schema = publishedSchema();
    nlohmann::json level =
        nlohmann::json::parse(R"({"version": 2, "title": "wind", "mods": ["wind"], "objects": [
        {"name": "fan", "at": [0, 0], "properties": {"scripts": [{"script": "Dynamics <- Wind",
          "set": [{"param": "speed", "number": 3}, {"param": "along", "vector": [1, 0]}]}]}}]})");
    EXPECT_EQ(validate(schema, level), std::vector<std::string>());
    for (auto const& [pointer, value] : std::vector<std::pair<char const*, char const*>>{
             {"/mods", "\"wind\""},
             {"/mods/0", "\"\""},
             {"/objects/0/properties/scripts/0/script", "1"},
             {"/objects/0/properties/scripts/0/set/0/number", "\"3\""},
             {"/objects/0/properties/scripts/0/set/0/value", "3"},
         }) {
        nlohmann::json wrong = level;
        wrong[nlohmann::json::json_pointer(pointer)] = nlohmann::json::parse(value);
        EXPECT_FALSE(validate(schema, wrong).empty()) << pointer;
    }
}

TEST(Schema, RefusesWhatTheReaderRefuses) {
    nlohmann::json const schema = levelSchema(levelKit().registry);
    struct Case {
        char const* pointer;
        char const* value;
    };
    for (Case const& c : {
             Case{"/version", "3"},
             Case{"/title", "\"\""},
             Case{"/surprise", "1"},
             Case{"/world/gravity", "[0]"},
             Case{"/world/detail/gravity", "\"moon\""},
             Case{"/objects/0/properties/fixed", "1"},
             Case{"/objects/0/properties/friction", "-1"},
             Case{"/objects/0/properties/shape/0/form", "\"boxx\""},
             Case{"/objects/0/properties/shape/0/width", "0"},
             Case{"/objects/0/properties/shape/0/colour", "1"},
             Case{"/objects/0/properties/look", "{\"colour\": 1}"},
             Case{"/objects/3/properties/collision/mask", "1.5"},
             Case{"/joints/0/lower_deg", "\"a\""},
             Case{"/joints/0/a", "3"},
             Case{"/connections/0", "[\"plus\"]"},
             Case{"/placing/0", "[1, 2, 3]"},
             Case{"/toolbox/0/count", "0"},
             Case{"/goals/all/0/on", "{}"},
             Case{"/goals/all/0/off", "\"lamp\""},
             Case{"/goals/all/0/for", "-1"},
             Case{"/goals/all", "[]"},
             Case{"/goals/all/2/count/exactly", "1"},
             Case{"/solutions/0/expect", "\"maybe\""},
             Case{"/solutions/0/inputs/2/release", "false"},
             Case{"/solutions/0/inputs/0/at", "null"},
             Case{"/solutions/0/changes/0/frame", "0"},
             Case{"/solutions/0/changes/0/detail", "{}"},
             Case{"/solutions/0/changes/1/period/Dynamics Resolver", "1.5"},
             Case{"/solutions/0/changes/2/setting/solver", "2"},
         }) {
        nlohmann::json level = nlohmann::json::parse(sampleLevel());
        level[nlohmann::json::json_pointer(c.pointer)] = nlohmann::json::parse(c.value);
        EXPECT_FALSE(validate(schema, level).empty()) << c.pointer;
    }
}

/// Whether the schema accepts the sample level with this value, and whether the reader does.
std::pair<bool, bool> acceptedWith(char const* pointer, nlohmann::json const& value) {
    nlohmann::json level = nlohmann::json::parse(sampleLevel());
    level[nlohmann::json::json_pointer(pointer)] = value;
    bool read = true;
    try {
        (void)buildLevel(levelKit().registry,
                         readLevel(levelKit().registry, JsonDocument::parse(level.dump(), "f.json")),
                         levelKit().parts);
    } catch (InputError const&) {
        read = false;
    }
    return {validate(levelSchema(levelKit().registry), level).empty(), read};
}

// Limits of the total over several lists.
TEST(Schema, SaysHowMuchThereMayBeInAll) {
    nlohmann::json const schema = levelSchema(levelKit().registry);
    auto const says = [&](char const* pointer, std::size_t limit) {
        auto const text = schema.at(nlohmann::json::json_pointer(pointer)).get<std::string>();
        return text.find("at most " + std::to_string(limit)) != std::string::npos;
    };
    EXPECT_TRUE(says("/description", limits::fileSize));
    EXPECT_TRUE(says("/properties/objects/description", limits::made));
    EXPECT_TRUE(says("/properties/objects/description", limits::pieces));
    EXPECT_TRUE(says("/properties/objects/description", limits::partDepth));
    EXPECT_TRUE(says("/$defs/condition/description", limits::conditions));
    EXPECT_TRUE(says("/$defs/condition/description", ObjectFinder::most));
}

// The limits that rules state in words, counted by writing as many entries.
TEST(Schema, StatesAsManyEntriesOfListsAsAreRead) {
    nlohmann::json const piece = {{"form", "circle"}};
    nlohmann::json const corner = {0.5, 0};
    auto const polygon = [](std::size_t corners) {
        nlohmann::json all = nlohmann::json::array();
        for (std::size_t i = 0; i < corners; ++i) {
            double const angle =
                2 * pi * static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, corners));
            all.push_back({std::cos(angle), std::sin(angle)});
        }
        return nlohmann::json::array({{{"form", "polygon"}, {"corners", all}}});
    };
    auto const drawn = [](nlohmann::json const& shapes) { return nlohmann::json{{"shapes", shapes}}; };
    auto const line = [&](std::size_t points) {
        return drawn(nlohmann::json::array(
            {{{"form", "line"}, {"points", std::vector<nlohmann::json>(points, corner)}}}));
    };
    struct Case {
        char const* pointer;
        std::size_t least;
        std::size_t most;
        std::function<nlohmann::json(std::size_t)> make;
    };
    char const* const shape = "/objects/0/properties/shape";
    char const* const drawing = "/objects/0/properties/drawing";
    for (Case const& c : std::vector<Case>{
             {shape, 1, 256, [&](std::size_t n) { return std::vector<nlohmann::json>(n, piece); }},
             {shape, 3, 8, polygon},
             {drawing, 1, 200, [&](std::size_t n) { return drawn(std::vector<nlohmann::json>(n, piece)); }},
             {drawing, 3, 64, [&](std::size_t n) { return drawn(polygon(n)); }},
             {drawing, 2, 64, line},
         }) {
        std::pair const good(true, true);
        std::pair const bad(false, false);
        EXPECT_EQ(acceptedWith(c.pointer, c.make(c.least)), good) << c.pointer << " " << c.least;
        EXPECT_EQ(acceptedWith(c.pointer, c.make(c.most)), good) << c.pointer << " " << c.most;
        EXPECT_EQ(acceptedWith(c.pointer, c.make(c.least - 1)), bad) << c.pointer << " " << c.least - 1;
        EXPECT_EQ(acceptedWith(c.pointer, c.make(c.most + 1)), bad) << c.pointer << " " << c.most + 1;
    }
}

} // namespace
} // namespace trembler
