#include "runtime/level/build/build_world.hpp"
#include "runtime/placement.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>

namespace trembler {
namespace build_world_test {
namespace {

using sample::Tag;
using sample::Weight;

constexpr char const* thing = R"({"name": "thing", "properties": {"weight": 5, "tag": true}})";
constexpr char const* heavy = R"({"name": "heavy", "properties": {"weight": 13}})";

class BuildWorld : public testing::Test {
protected:
    BuildWorld() {
        sample::fill(registry);
        library = sample::parts(registry, {thing, heavy});
    }
    std::unique_ptr<World> build(std::string const& members, std::vector<Placement> const& placements = {}) {
        LevelFile const level = sample::read(registry, "{\"version\": 1, \"title\": \"t\", " + members + "}");
        return buildWorld(registry, level, library, placements);
    }
    std::string problemOf(std::string const& members, std::vector<Placement> const& placements = {}) {
        try {
            (void)build(members, placements);
            return "";
        } catch (InputError const& error) {
            return error.what();
        }
    }
    Registry registry;
    PartLibrary library;
};

TEST_F(BuildWorld, CreatesObjectsInCanonicalOrderWithTheirEffectiveProperties) {
    auto const world = build(R"("world": {"climate": [1, 0]}, "toolbox": [{"part": "thing", "count": 3}],
        "objects": [{"name": "b", "part": "thing", "properties": {"weight": 7, "tag": false}},
                    {"name": "a", "part": "thing", "at": [3, 4]}],
        "joints": [{"a": "b", "strength": 2}, {"name": "j", "a": "a", "b": "b"}, {"a": "a"}])",
                             {{"thing", {2, 0}, 0, ""}, {"thing", {1, 0}, 0.5, ""}});
    Store const& store = world->store();
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < store.objects().indexBound(); ++i) {
        names.push_back(store.nameOf(store.objects().at(i)));
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"world", "a", "b", "j", "joint 1", "joint 2", "thing 1", "thing 2"}));
    EXPECT_EQ(world->find<sample::Climate>(store.find("world"))->wind, (Vec2{1, 0}));
    EXPECT_EQ(world->find<Weight>(store.find("a"))->value, 5);
    EXPECT_EQ(world->find<Weight>(store.find("b"))->value, 7);
    EXPECT_EQ(world->find<Tag>(store.find("b")), nullptr);
    EXPECT_EQ(world->find<sample::Knot>(store.find("j"))->b, store.find("b"));
    EXPECT_EQ(world->find<Position>(store.find("thing 1"))->value, (Vec2{1, 0}));
    EXPECT_EQ(world->find<Rotation>(store.find("thing 1"))->angle, 0.5);
    EXPECT_NE(store.prototypes().numberOf("heavy"), PrototypeLibrary::unknown);
    world->step();
    EXPECT_EQ(build(R"("world": {"climate": false})")->find<sample::Climate>(ObjectId{0, 0}), nullptr);
}

TEST_F(BuildWorld, PlacesProblemsWhereThePropertyIsStated) {
    EXPECT_SAYS(problemOf(R"("objects": [{"name": "a", "part": "thng"}])"),
                "/objects/0/part: there is no part 'thng', did you mean 'thing'?");
    EXPECT_SAYS(problemOf(R"("toolbox": [{"part": "thng"}])"), "/toolbox/0/part: there is no part");
    EXPECT_SAYS(problemOf(R"("objects": [{"name": "abc", "properties": {"cake": {"eater": "abd"}}}])"),
                "/objects/0/properties/cake/eater: there is no object 'abd', did you mean 'abc'?");
    EXPECT_SAYS(problemOf(R"("objects": [{"name": "a", "properties": {"cake": {"guests": ["a", "q"]}}}])"),
                "/objects/0/properties/cake/guests/1: there is no object 'q'");
    EXPECT_SAYS(problemOf(R"("joints": [{"a": "q"}])"), "/joints/0/a: there is no object 'q'");
    EXPECT_SAYS(problemOf(R"("objects": [{"name": "a", "properties": {"weight": 13}}])"),
                "test.json:1:81: /objects/0/properties/weight: a: the weight is 13");
    EXPECT_SAYS(problemOf(R"("objects": [{"name": "a", "part": "heavy"}])"),
                "part.json:1:44: /properties/weight: a: the weight is 13");
    EXPECT_EQ(problemOf(R"("objects": [{"name": "a", "part": "heavy", "properties": {"weight": 12}}])"), "");
    EXPECT_SAYS(problemOf(R"("objects": [{"name": "a"}, {"name": "b"}], "connections": [["a", "b"]])"),
                "/connections/0: only what has a tag");
}

// Weights must differ; told of all but the first of equals.
int timesCompared = 0;
std::vector<ObjectFault> compareWeights(Store const& store) {
    ++timesCompared;
    std::vector<ObjectFault> faults;
    std::map<double, ObjectId> first;
    for (ObjectId const id : store.findColumn<Weight>()->owners()) {
        auto const [at, isNew] = first.emplace((*store.findColumn<Weight>())[id].value, id);
        if (!isNew) {
            faults.push_back({id, "as heavy as '" + store.nameOf(at->second) + "'"});
        }
    }
    return faults;
}

TEST_F(BuildWorld, ComparesAllObjectsOnceAndPlacesWhatItFinds) {
    registry.rule({.property = &propertyInfo<Weight>(), .checkAll = compareWeights});
    timesCompared = 0;
    EXPECT_EQ(problemOf(R"("objects": [{"name": "a"}])"), "") << "there is nothing to compare";
    EXPECT_EQ(timesCompared, 0);
    std::string const problems = problemOf(R"("objects": [{"name": "c", "properties": {"weight": 13}},
                                 {"name": "a", "properties": {"weight": 13}},
                                 {"name": "d", "properties": {"weight": 2}},
                                 {"name": "b", "properties": {"weight": 1}},
                                 {"name": "e", "part": "thing"}, {"name": "f", "part": "thing"}])");
    EXPECT_EQ(timesCompared, 1);
    EXPECT_SAYS(problems, "/objects/0/properties/weight: c: as heavy as 'a'");
    EXPECT_SAYS(problems, "/properties/weight: f: as heavy as 'e'");
    EXPECT_LT(problems.find("c: the weight is 13"), problems.find("c: as heavy")) << "in order of rules";
    EXPECT_EQ(problems.find("b: "), std::string::npos);
}

TEST_F(BuildWorld, RefusesPlacementsThatTheLevelDoesNotAllow) {
    std::string const level = R"("toolbox": [{"part": "thing"}], "placing": [[0, 0, 2, 2]])";
    EXPECT_EQ(problemOf(level, {{"thing", {1, 1}, 0, ""}}), "");
    EXPECT_SAYS(problemOf(level, {{"thing", {3, 1}, 0, ""}}), "Nothing can be placed there");
    EXPECT_SAYS(problemOf(level, {{"thing", {1, 1}, 0, ""}, {"thing", {1, 0}, 0, ""}}), "only one");
    EXPECT_SAYS(problemOf(level, {{"heavy", {1, 1}, 0, ""}}), "has no 'heavy'");
    EXPECT_SAYS(problemOf(level, {{"thing", {1, 1}, std::nan(""), ""}}), "no place at all");
    EXPECT_SAYS(problemOf(R"("toolbox": [{"part": "thing"}], "world": {"bounds": [0, 0, 1, 1]})",
                          {{"thing", {3, 1}, 0, ""}}),
                "outside the level");
    LevelFile const read = sample::read(registry, "{\"version\": 1, \"title\": \"t\", " + level + "}");
    auto const everything = [](Store const&, ObjectId, ObjectId) { return true; };
    std::vector<Placement> const one{{"thing", {1, 1}, 0, ""}};
    EXPECT_THROW((void)buildWorld(registry, read, library, one, {}, everything), InputError);
}

TEST_F(BuildWorld, AvoidsNamesThatAreTaken) {
    auto const world = build(R"("toolbox": [{"part": "thing", "count": 2}],
        "objects": [{"name": "thing 1"}, {"name": "joint 1"}], "joints": [{"a": "thing 1"}])",
                             {{"thing", {0, 0}, 0, ""}, {"thing", {1, 0}, 0, ""}});
    EXPECT_TRUE(world->store().find("joint 2").valid());
    EXPECT_TRUE(world->store().find("thing 3").valid());
    EXPECT_EQ(world->find<Position>(world->store().find("thing 2"))->value, (Vec2{0, 0}));
}

TEST_F(BuildWorld, DoesNotCareAboutTheOrderOfEntries) {
    auto const shuffled = [](std::vector<std::string> list) {
        for (std::size_t i = list.size(); i > 1; --i) {
            std::swap(list[i - 1], list[*rc::gen::inRange<std::size_t>(0, i)]);
        }
        std::string joined;
        for (std::string const& entry : list) {
            joined += (joined.empty() ? "" : ", ") + entry;
        }
        return joined;
    };
    std::vector<std::string> const objects{
        R"({"name": "a", "part": "thing", "at": [1, 2]})", R"({"name": "b", "part": "thing"})",
        R"({"name": "c", "part": "thing", "properties": {"cake": {"eater": "joint 2", "guests": ["b", "a"]}}})",
        R"({"name": "d", "part": "thing", "properties": {"weight": 3}})"};
    std::vector<std::string> const joints{R"({"a": "a", "b": "b"})", R"({"a": "b"})", R"({"a": "b"})",
                                          R"({"name": "k", "a": "c"})"};
    std::vector<std::string> const connections{R"(["a", "b"])", R"(["a", "c"])", R"(["d", "c"])",
                                               R"(["a", "d"])"};
    std::vector<Placement> const placements{{"thing", {1, 0}, 0, ""},
                                            {"thing", {0, 0}, 0, ""},
                                            {"thing", {0, 0}, 1, ""},
                                            {"thing", {-0.0, 2}, 0, ""}};
    auto const hashOf = [&](bool shuffle) {
        auto const list = [&](std::vector<std::string> const& all) {
            std::string text;
            for (std::string const& entry : all) {
                text += (text.empty() ? "" : ", ") + entry;
            }
            return shuffle ? shuffled(all) : text;
        };
        std::vector<Placement> placed = placements;
        for (std::size_t i = placed.size(); shuffle && i > 1; --i) {
            std::swap(placed[i - 1], placed[*rc::gen::inRange<std::size_t>(0, i)]);
        }
        return build("\"toolbox\": [{\"part\": \"thing\", \"count\": 4}], \"objects\": [" + list(objects) +
                         "], \"joints\": [" + list(joints) + "], \"connections\": [" + list(connections) +
                         "]",
                     placed)
            ->stateHash();
    };
    std::uint64_t const expected = hashOf(false);
    EXPECT_TRUE(
        rc::check("any order of entries gives the same world", [&] { RC_ASSERT(hashOf(true) == expected); }));
}

} // namespace
} // namespace build_world_test
} // namespace trembler
