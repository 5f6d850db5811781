// Joints and connections may end at pieces of composite parts: commands on the objects take them along.
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/clipboard.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/problems/live_problems.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

namespace trembler::edit {
namespace pieces_as_ends_test {
namespace {

/// The small level with a doorbell and a battery "cell"; the bell's striker has a hinge of its own, a rope
/// leads from it to the crate on the left, and a wire from its left terminal to the battery.
Json withEnds() {
    Json level = Json::parse(smallLevel());
    level["objects"].push_back({{"name", "door"}, {"part", "doorbell"}, {"at", {0, 5}}});
    level["objects"].push_back({{"name", "cell"}, {"part", "battery"}, {"at", {2, 5}}});
    level["joints"].push_back({{"name", "hold"}, {"form", "hinge"}, {"a", "door striker"}, {"at", {0, 5.5}}});
    level["joints"].push_back(
        {{"form", "rope"}, {"a", "door striker"}, {"b", "left"}, {"at", {0, 4}}, {"at_b", {-2, 0.25}}});
    level["joints"].push_back({{"form", "gear"}, {"joint_a", "hold"}, {"joint_b", "door pivot"}});
    level["connections"] = Json::array({Json::array({"door left", "cell"})});
    return level;
}

Json after(Json level, Command const& command) {
    command.change(level);
    return level;
}

std::size_t jointsAt(Json const& level, std::string const& start) {
    std::size_t count = 0;
    for (Json const& joint : level["joints"]) {
        count += joint.dump().find("\"" + start) == std::string::npos ? 0 : 1;
    }
    return count;
}

TEST(PiecesAsEnds, AreRemovedWithTheObject) {
    for (bool const cut : {false, true}) {
        Json const level = after(withEnds(), cut ? cutObjects(editData(), withEnds(), {"door"})
                                                 : removeObjects(editData(), withEnds(), {"door"}));
        EXPECT_EQ(level["joints"], Json::parse(smallLevel())["joints"]);
        EXPECT_FALSE(level.contains("connections"));
    }
    Json const level = after(withEnds(), removeObjects(editData(), withEnds(), {"left"}));
    EXPECT_EQ(level["joints"].size(), 2U) << "the hinge of the striker and the gear";
    EXPECT_EQ(level["connections"].size(), 1U);
}

TEST(PiecesAsEnds, AreRemovedWithAJoint) {
    Json const level = after(withEnds(), removeJoints(editData(), withEnds(), {2}));
    EXPECT_EQ(level["joints"].size(), 3U) << "the gear refers to it";
    EXPECT_EQ(level["connections"].size(), 1U);
}

TEST(PiecesAsEnds, AreCopiedWithTheObject) {
    auto const expectCopies = [](Json const& level) {
        EXPECT_EQ(level["connections"],
                  Json::array({Json::array({"door left", "cell"}), Json::array({"door 2 left", "cell 2"})}));
        ASSERT_EQ(jointsAt(level, "door 2 "), 2U) << "the rope's other end is not among them";
        Json const& hinge = level["joints"][level["joints"].size() - 2];
        EXPECT_EQ(hinge["a"], "door 2 striker");
        EXPECT_EQ(hinge["name"], "hold 2");
        EXPECT_EQ(hinge["at"], Json::array({1, 5.5}));
        EXPECT_EQ(level["joints"].back()["joint_a"], "hold 2");
        EXPECT_EQ(level["joints"].back()["joint_b"], "door 2 pivot");
    };
    Json const level = withEnds();
    expectCopies(after(level, duplicateObjects(editData(), level, {"door", "cell"}, {1, 0})));
    std::string const text = copiedText(editData(), level, {"door", "cell"});
    expectCopies(after(level, pasteText(editData(), level, text, Vec2{2, 5})));
}

TEST(PiecesAsEnds, MoveWithTheObject) {
    Json level = after(withEnds(), moveObjects(editData(), withEnds(), {"door"}, {1, -1}));
    EXPECT_EQ(level["joints"][2]["at"], Json::array({1, 4.5}));
    EXPECT_EQ(level["joints"][3]["at"], Json::array({1, 3}));
    EXPECT_EQ(level["joints"][3]["at_b"], Json::array({-2, 0.25}));
    level = after(withEnds(), rotateObjects(editData(), withEnds(), {"door"}, 90, {0, 5}));
    EXPECT_EQ(level["joints"][2]["at"], Json::array({-0.5, 5}));
    EXPECT_EQ(level["joints"][3]["at"], Json::array({1, 5}));
    level = after(withEnds(), moveObjects(editData(), withEnds(), {"cell"}, {1, -1}));
    EXPECT_EQ(level["joints"], withEnds()["joints"]);
}

TEST(PiecesAsEnds, LeaveALevelThatLoads) {
    LevelDocument document = smallDocument();
    document.run(addObject(document.tree(), {.part = "doorbell", .at = {0, 5}, .name = "door"}));
    document.run(addJoint(editData(), document.tree(), "hinge", "door striker", "left", {-0.5, 5.7}, {}));
    document.run(duplicateObjects(editData(), document.tree(), {"door", "left"}, {1, 0}));
    document.run(addConnection(document.tree(), "door 2 left", "door left"));
    LiveProblems problems;
    problems.refresh(document);
    EXPECT_TRUE(problems.all().empty()) << problems.all().front().words();
    document.run(removeObjects(editData(), document.tree(), {"door"}));
    problems.refresh(document);
    EXPECT_TRUE(problems.all().empty()) << problems.all().front().words();
    EXPECT_EQ(document.tree()["joints"].back()["a"], "door 2 striker");
    EXPECT_EQ(document.tree()["joints"].back()["b"], "left 2");
}

} // namespace
} // namespace pieces_as_ends_test
} // namespace trembler::edit
