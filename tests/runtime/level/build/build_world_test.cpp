#include "runtime/level/build/build_world.hpp"
#include "runtime/placement.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <set>

namespace trembler {
namespace build_world_test {
namespace {

using sample::Tag;
using sample::Weight;

constexpr char const* thing = R"({"name": "thing", "properties": {"weight": 5, "tag": true}})";
constexpr char const* other = R"({"name": "other", "properties": {"weight": 6}})";
constexpr char const* heavy = R"({"name": "heavy", "properties": {"weight": 13}})";

class BuildWorld : public testing::Test {
protected:
    BuildWorld() {
        sample::fill(registry);
        library = sample::parts(registry, {thing, heavy, other});
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
                "/objects/0/part: there is no part 'thng' (did you mean 'thing'?)");
    EXPECT_SAYS(problemOf(R"("toolbox": [{"part": "thng"}])"), "/toolbox/0/part: there is no part");
    EXPECT_SAYS(problemOf(R"("objects": [{"name": "abc", "properties": {"cake": {"eater": "abd"}}}])"),
                "/objects/0/properties/cake/eater: there is no object 'abd' (did you mean 'abc'?)");
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

// Weights must differ; reported for all but the first of equal ones.
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

TEST_F(BuildWorld, ComparesAllObjectsOnceAndReportsPlaces) {
    registry.rule({.property = &propertyInfo<Weight>(), .checkAll = compareWeights});
    timesCompared = 0;
    EXPECT_EQ(problemOf(R"("objects": [{"name": "a"}])"), "") << "a single object is not compared";
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
}

TEST_F(BuildWorld, AvoidsNamesThatAreTaken) {
    auto const world = build(R"("toolbox": [{"part": "thing", "count": 2}],
        "objects": [{"name": "thing 1"}, {"name": "joint 1"}], "joints": [{"a": "thing 1"}])",
                             {{"thing", {0, 0}, 0, ""}, {"thing", {1, 0}, 0, ""}});
    EXPECT_TRUE(world->store().find("joint 2").valid());
    EXPECT_TRUE(world->store().find("thing 3").valid());
    EXPECT_EQ(world->find<Position>(world->store().find("thing 2"))->value, (Vec2{0, 0}));
}

// For any order of the lists, each entry leads to the object that was built from it, and back. Every object
// has a different weight, which identifies its entry.
TEST_F(BuildWorld, MapsEntriesToObjects) {
    EXPECT_TRUE(rc::check([&] {
        auto const shuffledTo = [](std::size_t count) {
            std::vector<std::size_t> order(count);
            for (std::size_t i = 0; i < count; ++i) {
                order[i] = i;
                std::swap(order[i], order[*rc::gen::inRange<std::size_t>(0, i + 1)]);
            }
            return order;
        };
        std::string objects;
        std::vector<double> weights;
        for (std::size_t const i : shuffledTo(5)) {
            weights.push_back(static_cast<double>(i + 1));
            objects += (objects.empty() ? "" : ", ") +
                       fmt::format(R"({{"name": "o{0}", {1} "properties": {{"weight": {2}}}}})", i,
                                   i % 2 == 0 ? R"("part": "thing",)" : "", i + 1);
        }
        std::string joints;
        std::vector<double> strengths;
        for (std::size_t const i : shuffledTo(4)) {
            strengths.push_back(static_cast<double>(i + 10));
            joints +=
                (joints.empty() ? "" : ", ") + fmt::format(R"({{{0} "a": "o1", "strength": {1}}})",
                                                           i == 2 ? R"("name": "thing 7",)" : "", i + 10);
        }
        std::vector<Placement> placements;
        for (std::size_t const i : shuffledTo(6)) { // two of them equal
            placements.push_back({i % 2 == 0 ? "thing" : "other",
                                  {static_cast<double>(std::min<std::size_t>(i, 3)), 0},
                                  0.5,
                                  ""});
        }
        LevelFile const level = sample::read(
            registry,
            R"({"version": 1, "title": "t", "toolbox": [{"part": "thing", "count": 9}, {"part": "other", "count": 9}],
                "objects": [)" +
                objects + R"(], "joints": [)" + joints + "]}");
        BuiltLevel const built = buildLevel(registry, level, library, placements);
        World const& world = *built.world;
        std::set<ObjectId> all;
        auto const check = [&](Origin::Kind kind, std::vector<ObjectId> const& ids, std::size_t i,
                               std::string const& part) {
            RC_ASSERT(world.store().alive(ids.at(i)));
            all.insert(ids[i]);
            Origin const origin = world.store().originOf(ids[i]);
            RC_ASSERT(origin.kind == kind);
            RC_ASSERT(origin.number == i);
            RC_ASSERT(!origin.maker.valid());
            Prototype const* const prototype = world.store().prototypeOf(ids[i]);
            RC_ASSERT((prototype == nullptr ? "" : prototype->name) == part);
        };
        RC_ASSERT(built.objects.size() == level.objects.size());
        for (std::size_t i = 0; i < level.objects.size(); ++i) {
            check(Origin::Kind::object, built.objects, i, level.objects[i].part);
            RC_ASSERT(world.store().nameOf(built.objects[i]) == level.objects[i].name);
            RC_ASSERT(world.find<Weight>(built.objects[i])->value == weights[i]);
        }
        RC_ASSERT(built.joints.size() == level.joints.size());
        for (std::size_t i = 0; i < level.joints.size(); ++i) {
            check(Origin::Kind::joint, built.joints, i, "");
            RC_ASSERT(world.find<sample::Knot>(built.joints[i])->strength == strengths[i]);
        }
        RC_ASSERT(built.placements.size() == placements.size());
        for (std::size_t i = 0; i < placements.size(); ++i) {
            check(Origin::Kind::placement, built.placements, i, placements[i].part);
            RC_ASSERT(world.find<Position>(built.placements[i])->value == placements[i].at);
            RC_ASSERT((world.find<Tag>(built.placements[i]) != nullptr) == (placements[i].part == "thing"));
        }
        ObjectId const known = world.store().find("world");
        RC_ASSERT(world.store().originOf(known).kind == Origin::Kind::world);
        all.insert(known);
        RC_ASSERT(
            all.size() ==
            world.store().objects().size()); // each object belongs to one entry, also for equal placements
    }));
}

TEST_F(BuildWorld, DoesNotDependOnTheOrderOfEntries) {
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
