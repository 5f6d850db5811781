// The list of placed parts: edits, numbers, undo and redo, the toolbox, and valid places.
#include "puzzle/session/placements.hpp"
#include "runtime/level/build/build_world.hpp"
#include "tests/support/experiment.hpp"

namespace trembler {
namespace {

class PlacementsTest : public Experiment {
protected:
    PlacementsTest() {
        level = readLevel(gameData().registry, JsonDocument::parse(R"({"version": 2, "title": "yard",
            "objects": [{"name": "post", "part": "block", "at": [0, 0]}],
            "placing": [[-5, -5, 10, 10]],
            "toolbox": [{"part": "steel ball", "count": 3}, {"part": "cargo box"}]})",
                                                                   "yard.json"));
    }
    static std::vector<int> numbersIn(Placements::List const& list) {
        std::vector<int> numbers;
        for (PlacedPart const& part : list) {
            numbers.push_back(part.number);
        }
        return numbers;
    }
    static Placement ball(double x) { return {"steel ball", {x, 2}, 0, ""}; }
    int add(Placement const& placement) {
        placements.keep(placements.with(placement));
        return placements.now().back().number;
    }
    LevelFile level;
    Placements placements{level, gameData().parts};
};

TEST_F(PlacementsTest, NumbersNameAPartThroughUndoAndRedoAndAreNeverUsedAgain) {
    int const a = add(ball(1));
    int const b = add(ball(2));
    placements.keep(*placements.without(a));
    EXPECT_EQ(numbersIn(placements.now()), std::vector{b});
    EXPECT_FALSE(placements.indexOf(a));
    EXPECT_EQ(placements.indexOf(b), 0U);
    EXPECT_TRUE(placements.undo());
    EXPECT_EQ(numbersIn(placements.now()), (std::vector{a, b}));
    EXPECT_EQ(placements.indexOf(b), 1U);
    EXPECT_TRUE(placements.undo());
    EXPECT_TRUE(placements.redo());
    EXPECT_EQ(numbersIn(placements.now()), (std::vector{a, b}));
    EXPECT_TRUE(placements.undo());
    int const c = add(ball(3)); // after this, no edit can be redone
    EXPECT_FALSE(placements.canRedo());
    EXPECT_NE(c, b);
    EXPECT_EQ(numbersIn(placements.now()), (std::vector{a, c}));
}

TEST_F(PlacementsTest, ADiscardedEditChangesNothing) {
    int const a = add(ball(1));
    add(ball(2));
    EXPECT_TRUE(placements.undo());
    auto const moved = placements.moved(a, {4, 3}, 0.25);
    ASSERT_TRUE(moved);
    EXPECT_EQ((*moved)[0].number, a);
    EXPECT_EQ((*moved)[0].placement.at, (Vec2{4, 3}));
    EXPECT_EQ((*moved)[0].placement.angle, 0.25);
    EXPECT_EQ(placements.with(ball(3)).size(), 2U);
    EXPECT_TRUE(placements.without(a)->empty());
    EXPECT_FALSE(placements.moved(99, {}, 0));
    EXPECT_FALSE(placements.without(99));
    EXPECT_EQ(placements.now()[0].placement.at, (Vec2{1, 2}));
    EXPECT_TRUE(placements.canRedo()) << "the undone edit can still be redone";
}

TEST_F(PlacementsTest, TheToolboxHasThePartsThatAreNotPlaced) {
    auto const left = [&] {
        std::vector<int> counts;
        for (ToolboxSlot const& slot : placements.toolbox()) {
            counts.push_back(slot.left);
        }
        return counts;
    };
    EXPECT_EQ(left(), (std::vector{3, 1}));
    add(ball(1));
    int const second = add(ball(2));
    add({"cargo box", {3, 2}, 0, ""});
    EXPECT_EQ(left(), (std::vector{1, 0}));
    placements.keep(*placements.without(second));
    EXPECT_EQ(left(), (std::vector{2, 0}));
    EXPECT_EQ(placements.toolbox()[0].part, "steel ball");
    EXPECT_EQ(placements.toolbox()[0].total, 3);
}

TEST_F(PlacementsTest, APartMayBePlacedAtAllowedFreePlaces) {
    int const a = add(ball(1));
    BuiltLevel const built =
        buildLevel(gameData().registry, level, gameData().parts, placementsOf(placements.now()));
    auto const why = [&](Placement const& placement, std::optional<int> moved = {}, ObjectId ignored = {}) {
        Verdict const verdict = placements.check(placement, *built.world, moved, {&ignored, 1});
        EXPECT_EQ(verdict.ok, verdict.why.empty());
        return verdict.why;
    };
    EXPECT_EQ(why(ball(3)), "");
    EXPECT_NE(why(ball(6)), "") << "outside the area";
    EXPECT_NE(why({"iron ball", {3, 2}, 0, ""}), "") << "not in the toolbox";
    EXPECT_NE(why({"steel ball", {0, 0}, 0, ""}).find("post"), std::string::npos);
    EXPECT_NE(why(ball(1.1)).find("steel ball 1"), std::string::npos);
    EXPECT_EQ(why(ball(1.1), a, built.placements[0]), "") << "it does not collide with itself";
    add(ball(2));
    add(ball(-2));
    EXPECT_NE(why(ball(3)), "") << "no ball is left in the toolbox";
    EXPECT_EQ(why(ball(3), a, built.placements[0]), "") << "this one is only moved";
}

TEST_F(PlacementsTest, ASolutionsPartsAreRefusedInItsFile) {
    Solution solution;
    solution.placements = {ball(1), ball(1), {"steel ball", {9, 9}, 0, "/placements/2"}};
    int const before = add(ball(0.5));
    try {
        (void)placements.those(solution);
        ADD_FAILURE() << "the third part could not be placed";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("/placements/2"), std::string::npos) << error.what();
    }
    EXPECT_EQ(numbersIn(placements.now()), std::vector{before});
    solution.placements.pop_back();
    placements.keep(placements.those(solution));
    ASSERT_EQ(placements.now().size(), 2U) << "in the same place, as recorded";
    EXPECT_NE(placements.now()[0].number, placements.now()[1].number);
    EXPECT_TRUE(placements.undo());
    EXPECT_EQ(numbersIn(placements.now()), std::vector{before});
}

} // namespace
} // namespace trembler
