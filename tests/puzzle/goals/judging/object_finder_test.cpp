// The objects that a selector matches: objects made from a part, whatever their names.
#include "puzzle/goals/judging/object_finder.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/placement.hpp"
#include "tests/support/experiment.hpp"

#include <algorithm>

namespace trembler {
namespace {

class ObjectFinderTest : public Experiment {
protected:
    ObjectFinderTest() {
        level = readLevel(gameData().registry, JsonDocument::parse(R"({"version": 2, "title": "names",
            "objects": [{"name": "steel ball 3", "part": "wooden ball", "at": [0, 0]},
                        {"name": "steel ball 4", "at": [1, 0], "properties": {"shape": [{"form": "circle"}]}},
                        {"name": "a", "part": "steel ball", "at": [2, 0]},
                        {"name": "wooden ball", "part": "steel ball", "at": [3, 0]}],
            "joints": [{"name": "steel ball 5", "form": "hinge", "a": "a", "at": [2, 0]}],
            "toolbox": [{"part": "steel ball", "count": 2}, {"part": "wooden ball"}]})",
                                                                   "names.json"));
        built = buildLevel(gameData().registry, level, gameData().parts,
                           std::vector<Placement>{{"steel ball", {6, 0}, 0, ""},
                                                  {"wooden ball", {5, 0}, 0, ""},
                                                  {"steel ball", {4, 0}, 0, ""}});
    }
    [[nodiscard]] std::vector<ObjectId> found(Selector const& selector, ObjectId it = {}) {
        return ObjectFinder(level, *built.world, problems).find(selector, it);
    }
    static std::vector<ObjectId> ascending(std::vector<ObjectId> ids) {
        std::sort(ids.begin(), ids.end());
        return ids;
    }
    LevelFile level;
    BuiltLevel built;
    Problems problems;
};

TEST_F(ObjectFinderTest, APartMatchesTheObjectsMadeFromIt) {
    auto const& objects = built.objects;
    auto const& placements = built.placements;
    std::vector<ObjectId> const steel = ascending({objects[2], objects[3], placements[0], placements[2]});
    std::vector<ObjectId> const wood = ascending({objects[0], placements[1]});
    EXPECT_EQ(found({{}, {"steel ball"}, false, ""}), steel);
    EXPECT_EQ(found({{}, {"wooden ball"}, false, ""}), wood);
    std::vector<ObjectId> both = steel;
    both.insert(both.end(), wood.begin(), wood.end());
    EXPECT_EQ(found({{}, {"wooden ball", "steel ball"}, false, ""}), ascending(both));
    EXPECT_TRUE(found({{}, {"iron ball"}, false, ""}).empty()) << "no object is made from this part";
    EXPECT_TRUE(found({{}, {"nothing"}, false, ""}).empty());
}

TEST_F(ObjectFinderTest, ANameMatchesItsObjectAndEachIsFoundOnce) {
    EXPECT_EQ(found({{"wooden ball"}, {}, false, ""}), std::vector{built.objects[3]});
    EXPECT_EQ(found({{"steel ball 5"}, {}, false, ""}), std::vector{built.joints[0]});
    EXPECT_EQ(found({{"steel ball 3", "steel ball 3"}, {"wooden ball"}, true, ""}, built.objects[0]),
              ascending({built.objects[0], built.placements[1]}));
    EXPECT_TRUE(found({{"nobody"}, {}, true, ""}).empty());
}

TEST_F(ObjectFinderTest, ReportsImpossibleSelectors) {
    ObjectFinder const finder(level, *built.world, problems);
    finder.mustHave({{"a", "steel ball 5", "steel ball 4"}, {}, false, ""}, propertyInfo<Position>(),
                    "is nowhere");
    ASSERT_EQ(problems.count(), 1U);
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("'steel ball 5' is nowhere"), std::string::npos)
            << error.what();
    }
    EXPECT_TRUE(finder.take(ObjectFinder::most, ""));
    EXPECT_EQ(problems.count(), 1U);
    EXPECT_FALSE(finder.take(1, ""));
    EXPECT_FALSE(finder.take(1, ""));
    EXPECT_EQ(problems.count(), 2U) << "once only";
}

// The goals are refused then; looking for the objects of thousands of further conditions would take minutes.
TEST_F(ObjectFinderTest, FindsNothingMoreOnceThereAreTooMany) {
    ObjectFinder const finder(level, *built.world, problems);
    Selector const ball{{}, {"steel ball"}, false, ""};
    EXPECT_TRUE(finder.take(ObjectFinder::most, "/goals"));
    EXPECT_FALSE(finder.full());
    EXPECT_EQ(finder.find(ball, {}).size(), 4U);
    EXPECT_TRUE(problems.empty());
    EXPECT_FALSE(finder.take(1, "/goals"));
    EXPECT_TRUE(finder.full());
    EXPECT_TRUE(finder.find(ball, {}).empty());
    EXPECT_FALSE(problems.empty());
}

} // namespace
} // namespace trembler
