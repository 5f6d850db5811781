#include "runtime/level/build/build_world.hpp"
#include "runtime/level/write/write_level.hpp"
#include "runtime/placement.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

using sample::Cake;
using sample::Weight;

class ReadLevel : public testing::Test {
protected:
    ReadLevel() { sample::fill(registry); }

    std::vector<std::string> problemsWith(std::string const& members) {
        return sample::problemsOf(registry, "{\"version\": 1, \"title\": \"t\",\n" + members + "}");
    }
    std::vector<std::string> problemsWithProperty(std::string const& property) {
        return problemsWith("\"objects\": [{\"name\": \"x\", \"properties\": {" + property + "}}]");
    }
    Registry registry;
};

TEST_F(ReadLevel, CountsOfAToolboxMayBeUnlimited) {
    std::string const text = R"({"version": 2, "title": "t", "objects": [], "toolbox": [
        {"part": "a", "count": "unlimited"}, {"part": "b", "count": 3}, {"wire": "unlimited"}]})";
    LevelFile const level = sample::read(registry, text);
    EXPECT_EQ(level.toolbox.at(0).count, unlimitedCount);
    EXPECT_EQ(level.toolbox.at(1).count, 3);
    EXPECT_EQ(level.wires, unlimitedCount);
    auto const written = writeLevel(level);
    EXPECT_EQ(written["toolbox"], nlohmann::ordered_json::parse(text)["toolbox"]);
    LevelFile const again = sample::read(registry, written.dump());
    EXPECT_EQ(again.wires, unlimitedCount);
    EXPECT_EQ(again.toolbox.at(0).count, unlimitedCount);
}

TEST_F(ReadLevel, OtherWordsAndNumbersAreNoCounts) {
    for (char const* const wrong : {"\"endless\"", "\"Unlimited\"", "\"\"", "0", "-1", "1001", "2147483647",
                                    "1.5", "true", "null", "[]", "{}"}) {
        for (std::string const& entry : {std::string(R"({"part": "a", "count": )") + wrong + "}",
                                         std::string(R"({"wire": )") + wrong + "}"}) {
            auto const problems = problemsWith("\"toolbox\": [" + entry + "]");
            ASSERT_EQ(problems.size(), 1U) << entry;
            EXPECT_NE(problems[0].find("from 1 to 1000"), std::string::npos) << problems[0];
        }
    }
    EXPECT_EQ(problemsWith(R"("toolbox": [{"wire": "unlimited"}, {"wire": 2}])").size(), 1U);
}

TEST_F(ReadLevel, ReadsEverySection) {
    LevelFile const level = sample::read(registry, R"({
        "version": 1, "title": "All of it", "text": "Do it.",
        "world": {"climate": [3, -1], "bounds": [-10, -5, 20, 10], "detail": {}},
        "objects": [
            {"name": "b", "part": "thing", "at": [1, 2], "angle_deg": 90, "properties": {"weight": 7, "tag": false}},
            {"name": "a", "properties": {"cake": {"eater": "b", "guests": ["a", "k"],
                "toppings": [{"flavour": "bitter", "turn_deg": 180, "spots": [[1, 2], [3, 4]]}]}}}],
        "joints": [{"name": "k", "a": "a", "b": "b", "strength": 5}, {"a": "b"}],
        "connections": [["a", "b"]],
        "placing": [[0, 0, 2, 1], [[5, 5], [6, 5], [5, 6]]],
        "toolbox": [{"part": "thing", "count": 2}, {"part": "other"}],
        "goals": {"anything": 1},
        "hints": ["look", "think"],
        "solutions": [{"name": "s", "placements": [{"part": "thing", "at": [1, 1], "angle_deg": 45}],
            "inputs": [{"frame": 9, "release": true}, {"frame": 5, "grab": "a", "at": [1, 1]},
                       {"frame": 6, "move": [2, 2]}, {"frame": 7, "cut": ["a", "b"]},
                       {"frame": 8, "remove": "thing 1"}], "expect": "unsolved", "frames": 100}]
    })");
    EXPECT_EQ(level.title, "All of it");
    EXPECT_EQ(level.world.find<sample::Climate>()->wind, (Vec2{3, -1}));
    EXPECT_EQ(level.bounds->size, (Vec2{20, 10}));
    ASSERT_EQ(level.objects.size(), 2U);
    EXPECT_EQ(level.objects[0].properties.find<Position>()->value, (Vec2{1, 2}));
    EXPECT_DOUBLE_EQ(level.objects[0].properties.find<Rotation>()->angle, pi / 2);
    EXPECT_TRUE(level.objects[0].properties.states(propertyInfo<sample::Tag>()));
    EXPECT_EQ(level.objects[0].properties.find<sample::Tag>(), nullptr);
    Cake const& cake = *level.objects[1].properties.find<Cake>();
    EXPECT_EQ(level.names.nameOf(cake.eater), "b");
    EXPECT_EQ(level.names.nameOf(cake.guests[1]), "k");
    EXPECT_EQ(cake.note, "plain");
    EXPECT_EQ(cake.toppings[0].flavour, Flavour::bitter);
    EXPECT_DOUBLE_EQ(cake.toppings[0].turn, pi);
    EXPECT_EQ(cake.toppings[0].spots[1], (Vec2{3, 4}));
    ASSERT_EQ(level.joints.size(), 2U);
    EXPECT_EQ(level.joints[1].name, "");
    EXPECT_TRUE((*level.placing)[1].contains({5.2, 5.2}));
    EXPECT_FALSE((*level.placing)[1].contains({5.8, 5.8}));
    EXPECT_EQ(level.toolbox[1].count, 1);
    Solution const& solution = level.solutions.at(0);
    EXPECT_FALSE(solution.solves);
    EXPECT_DOUBLE_EQ(solution.placements[0].angle, pi / 4);
    ASSERT_EQ(solution.inputs.size(), 5U);
    EXPECT_EQ(solution.inputs[0].kind, PlayerInput::Kind::grab);
    EXPECT_EQ(solution.inputs[3].object, "thing 1");
    EXPECT_EQ(solution.inputs[4].frame, 9U);
}

TEST_F(ReadLevel, PrintsPlacePathProblemAndExpectation) {
    EXPECT_EQ(sample::only(problemsWithProperty("\"weigth\": 3")),
              "test.json:2:42: /objects/0/properties/weigth: unknown property 'weigth' (did you mean "
              "'weight'?); expected 'angular_velocity_deg', 'cake', 'joint', 'tag', 'velocity' or "
              "'weight'");
    EXPECT_EQ(sample::only(problemsWithProperty("\"weight\": 0")),
              "test.json:2:52: /objects/0/properties/weight: is 0; expected a number above 0 and at "
              "most 100 (kg)");
    EXPECT_SAYS(sample::only(problemsWithProperty("\"cake\": {\"tilt_deg\": 1}")), "unknown key 'tilt_deg'");
    EXPECT_SAYS(sample::only(problemsWithProperty("\"cake\": {\"flavour\": \"sour\", \"tilt_deg\": 1e5}")),
                "(degrees)");
}

TEST_F(ReadLevel, RefusesEveryWrongFieldWithItsPath) {
    struct Case {
        char const* property;
        char const* path;
        char const* words;
    };
    for (Case const& c : {
             Case{"\"weight\": \"2\"", "/weight:", "is \"2\""},
             Case{"\"weight\": -0.0", "/weight:", "above 0"},
             Case{"\"weight\": 101", "/weight:", "at most 100"},
             Case{"\"weight\": [1]", "/weight:", "is a list of 1"},
             Case{"\"weight\": null", "/weight:", "is null"},
             Case{"\"tag\": 1", "/tag:", "expected true"},
             Case{"\"tag\": {}", "/tag:", "expected true"},
             Case{"\"cake\": 3", "/cake:", "expected an object"},
             Case{"\"cake\": {\"burnt\": 1}", "/cake/burnt:", "true or false"},
             Case{"\"cake\": {\"note\": 1}", "/cake/note:", "expected text"},
             Case{"\"cake\": {\"middle\": 1}", "/cake/middle:", "[x, y]"},
             Case{"\"cake\": {\"middle\": [1, 2, 3]}", "/cake/middle:", "[x, y]"},
             Case{"\"cake\": {\"middle\": [1, 11]}", "/cake/middle/1:", "from -10 to 10"},
             Case{"\"cake\": {\"middle\": [null, 1]}", "/cake/middle/0:", "is null"},
             Case{"\"cake\": {\"flavour\": \"sweat\"}", "/cake/flavour:", "did you mean 'sweet'"},
             Case{"\"cake\": {\"flavour\": 1}", "/cake/flavour:", "'sweet', 'sour' or 'bitter'"},
             Case{"\"cake\": {\"eater\": 5}", "/cake/eater:", "name of an object"},
             Case{"\"cake\": {\"guests\": [5]}", "/cake/guests/0:", "name of an object"},
             Case{"\"cake\": {\"toppings\": {}}", "/cake/toppings:", "expected a list"},
             Case{"\"cake\": {\"toppings\": [3]}", "/cake/toppings/0:", "expected an object"},
             Case{"\"cake\": {\"toppings\": [{}]}", "/cake/toppings/0:", "'flavour' is missing"},
             Case{"\"cake\": {\"toppings\": [{\"flavour\": \"sour\", \"count\": 2.5}]}",
                  "/cake/toppings/0/count:", "whole number from 0 to 10"},
             Case{"\"cake\": {\"toppings\": [{\"flavour\": \"sour\", \"count\": 1e300}]}",
                  "/cake/toppings/0/count:", "whole number"},
             Case{"\"cake\": {\"toppings\": [{\"flavour\": \"sour\", \"spots\": [[1, 6]]}]}",
                  "/cake/toppings/0/spots/0/1:", "from -5 to 5"},
             Case{"\"cake\": {\"toppings\": [{\"flavour\": \"sour\", \"colour\": 1}]}",
                  "/cake/toppings/0/colour:", "unknown key"},
             Case{"\"joint\": true", "/joint:", "'a' must be stated"},
             Case{"\"links\": true", "/links:", "only while the world runs"},
             Case{"\"climate\": [0, 0]", "/climate:", "\"world\""},
             Case{"\"at\": [0, 0]", "/at:", "object's entry"},
         }) {
        auto const problems = problemsWithProperty(c.property);
        ASSERT_EQ(problems.size(), 1U) << c.property;
        EXPECT_SAYS(problems[0], std::string("/objects/0/properties") + c.path) << c.property;
        EXPECT_SAYS(problems[0], c.words) << c.property;
    }
}

TEST_F(ReadLevel, RefusesWrongStructureWithItsPath) {
    struct Case {
        char const* members;
        char const* path;
        char const* words;
    };
    for (Case const& c : {
             Case{"\"tilte\": 1", "/tilte:", "did you mean 'title'"},
             Case{"\"world\": {\"wind\": 1}", "/world/wind:", "unknown key"},
             Case{"\"world\": {\"bounds\": [0, 0, 0, 1]}", "/world/bounds/2:", "number from 0.001"},
             Case{"\"world\": {\"detail\": {\"magic\": \"high\"}}",
                  "/world/detail/magic:", "no effect 'magic'"},
             Case{"\"objects\": {}", "/objects:", "a list of objects"},
             Case{"\"objects\": [{}]", "/objects/0:", "'name' is missing"},
             Case{"\"objects\": [{\"name\": \"\"}]", "/objects/0/name:", "a name of 1 to 100"},
             Case{"\"objects\": [{\"name\": \"world\"}]", "/objects/0/name:", "is taken"},
             Case{"\"objects\": [{\"name\": \"a\"}, {\"name\": \"a\"}]",
                  "/objects/1/name:", "'a' is taken by /objects/0/name"},
             Case{"\"objects\": [{\"name\": \"a\", \"weight\": 1}]",
                  "/objects/0/weight:", "under \"properties\""},
             Case{"\"joints\": [{\"b\": \"x\"}]", "/joints/0:", "'a' is missing"},
             Case{"\"connections\": [[\"a\"]]", "/connections/0:", "a pair"},
             Case{"\"connections\": [[\"a\", \"b\"]], \"objects\": [{\"name\": \"b\"}]",
                  "/connections/0/0:", "no object 'a'"},
             Case{"\"objects\": [{\"name\": \"b\"}], \"connections\": [[\"b\", \"b\"]]",
                  "/connections/0:", "with itself"},
             Case{"\"placing\": [[1, 2, 3]]", "/placing/0:", "a box"},
             Case{"\"placing\": [[[1, 2], [1, 3]]]", "/placing/0:", "polygon"},
             Case{"\"toolbox\": [{\"part\": \"a\", \"count\": 0}]", "/toolbox/0/count:", "from 1 to"},
             Case{"\"toolbox\": [{\"part\": \"a\"}, {\"part\": \"a\"}]", "/toolbox/1:", "already"},
             Case{"\"goals\": []", "/goals:", "a condition"},
             Case{"\"hints\": [1]", "/hints/0:", "text"},
             Case{"\"solutions\": [{}]", "/solutions/0:", "'name' is missing"},
             Case{"\"solutions\": [{\"name\": \"s\"}, {\"name\": \"s\"}]", "/solutions/1:", "already"},
             Case{"\"solutions\": [{\"name\": \"s\", \"inputs\": [{\"frame\": 0, \"release\": true}]}]",
                  "/solutions/0/inputs/0/frame:", "from 1"},
             Case{"\"solutions\": [{\"name\": \"s\", \"inputs\": [{\"frame\": 1}]}]",
                  "/solutions/0/inputs/0:", "states no input"},
             Case{"\"solutions\": [{\"name\": \"s\", \"inputs\": [{\"frame\": 1, \"remove\": \"q\"}]}]",
                  "/solutions/0/inputs/0:", "no object 'q'"},
             Case{"\"solutions\": [{\"name\": \"s\", \"expect\": \"solvd\"}]",
                  "/solutions/0/expect:", "did you mean 'solved'"},
         }) {
        auto const problems = problemsWith(c.members);
        ASSERT_EQ(problems.size(), 1U) << c.members;
        EXPECT_SAYS(problems[0], std::string(" ") + c.path) << c.members;
        EXPECT_SAYS(problems[0], c.words) << c.members;
    }
}

TEST_F(ReadLevel, ReportsAllProblemsAtOnceInTheOrderOfTheFile) {
    auto const problems = problemsWith("\"objects\": [{\"name\": \"a\", \"at\": [1]},\n {\"properties\": "
                                       "{\"weight\": -1}}],\n \"hints\": 3");
    ASSERT_EQ(problems.size(), 4U);
    EXPECT_SAYS(problems[0], ":2:");
    EXPECT_SAYS(problems[1], ":3:2");
    EXPECT_SAYS(problems[2], "/weight");
    EXPECT_SAYS(problems[3], ":4:");
}

TEST_F(ReadLevel, CountsTheProblemsBeyondTheLimit) {
    std::string hints = "1";
    for (int i = 1; i < 500; ++i) {
        hints += ", 1";
    }
    auto const problems = problemsWith("\"hints\": [" + hints + "]");
    ASSERT_EQ(problems.size(), Problems::most + 1);
    EXPECT_SAYS(problems.back(), "and 400 more");
}

TEST_F(ReadLevel, ReadsOlderVersionsAndRefusesNewerOnes) {
    LevelFile const level = sample::read(registry, R"({"version": 0, "title": "draft",
        "toolbox": {"thing": 2, "other": 1}})");
    ASSERT_EQ(level.toolbox.size(), 2U);
    EXPECT_EQ(level.toolbox[1].part, "thing");
    EXPECT_EQ(level.toolbox[1].count, 2);
    EXPECT_SAYS(sample::only(sample::problemsOf(registry, R"({"version": 3, "title": "t"})")),
                "newer program");
    EXPECT_SAYS(sample::only(sample::problemsOf(registry, R"({"title": "t"})")), "'version' is missing");
    EXPECT_SAYS(sample::only(
                    sample::problemsOf(registry, R"({"version": 0, "title": "d", "toolbox": {"thing": 0}})")),
                "test.json:1:");
}

} // namespace
} // namespace trembler
