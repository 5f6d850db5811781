// The changes of the tree by each kind of command.
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/clipboard.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/own_parts.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/commands/shapes.hpp"
#include "puzzle/edit/commands/solutions.hpp"
#include "puzzle/edit/tree/extent.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace trembler::edit {
namespace {

Json done(Json tree, Command const& command) {
    command.change(tree);
    return tree;
}

Json small() {
    return Json::parse(smallLevel());
}

Json const& entry(Json const& level, std::string const& name) {
    return *findObject(level, name);
}

TEST(ObjectCommands, RenameEveryReference) {
    Json const level = done(small(), renameObject(editData(), small(), "ball", "toy"));
    EXPECT_EQ(level["goals"]["all"][0]["touching"], (Json::array({"toy", "table"})));
    EXPECT_EQ(level["goals"]["all"][1]["inside"]["object"], "toy");
    EXPECT_EQ(level["solutions"][0]["inputs"][0]["grab"], "toy");
    Json const joints = done(small(), renameObject(editData(), small(), "left", "west"))["joints"];
    EXPECT_EQ(joints[0]["a"], "west");
    EXPECT_EQ(joints[1]["a"], "west");
    EXPECT_NE(refusalOf([] { return renameObject(editData(), small(), "ball", "left"); }), "");
    EXPECT_NE(refusalOf([] { return renameObject(editData(), small(), "ball", "line"); }), "");
    EXPECT_NE(refusalOf([] { return renameObject(editData(), small(), "ball", "world"); }), "");
    EXPECT_NE(refusalOf([] { return renameObject(editData(), small(), "ball", " x"); }), "");
    EXPECT_NE(refusalOf([] { return renameObject(editData(), small(), "none", "x"); }), "");
}

TEST(ObjectCommands, RenameWhatPropertiesReferTo) {
    Json level = small();
    level["objects"][1]["properties"]["electric_motor"] = {{"torque", 1}, {"against", "right"}};
    level = done(level, renameObject(editData(), level, "right", "east"));
    EXPECT_EQ(level["objects"][1]["properties"]["electric_motor"]["against"], "east");
}

TEST(ObjectCommands, RemoveWithJointsAndConnections) {
    Json level = small();
    level = done(level, addConnection(level, "left", "right"));
    level = done(level, groupObjects(level, {"left", "right"}));
    level = done(level, removeObjects(editData(), level, {"right"}));
    EXPECT_EQ(level["joints"].size(), 1U);
    EXPECT_FALSE(level.contains("connections"));
    EXPECT_FALSE(level.contains("editor"));
    level = done(level, lockObjects(level, {"left"}, true));
    EXPECT_NE(refusalOf([&] { return removeObjects(editData(), level, {"left"}); }), "");
    level = done(level, removeObjects(editData(), level, {"left", "ball"}));
    EXPECT_EQ(objectNames(level), (std::vector<std::string>{"table", "left"}));
}

TEST(ObjectCommands, DuplicateWithWhatHoldsAmongThem) {
    Command const command = duplicateObjects(editData(), small(), {"left", "right"}, {0.5, 0});
    EXPECT_EQ(command.selects, (std::vector<std::string>{"left 2", "right 2"}));
    Json const level = done(small(), command);
    ASSERT_EQ(level["joints"].size(), 4U);
    EXPECT_EQ(level["joints"][3]["a"], "left 2");
    EXPECT_EQ(level["joints"][3]["b"], "right 2");
    EXPECT_EQ(level["joints"][3]["at_b"], Json::array({2.5, 0.5}));
    EXPECT_EQ(entry(level, "left 2")["at"], Json::array({-1.5, 0.25}));
}

TEST(ArrangeCommands, TakeJointsAlong) {
    Json level = done(small(), moveObjects(editData(), small(), {"left"}, {1, 1}));
    EXPECT_EQ(entry(level, "left")["at"], Json::array({-1, 1.25}));
    EXPECT_EQ(level["joints"][0]["at"], Json::array({-1, 1.5}));
    EXPECT_EQ(level["joints"][1]["at"], Json::array({-1, 1.25}));
    EXPECT_EQ(level["joints"][1]["at_b"], Json::array({2, 0.5}));
    level = done(small(), rotateObjects(editData(), small(), {"left"}, 90, {-2, 0.25}));
    EXPECT_EQ(level["joints"][0]["at"], Json::array({-2.25, 0.25}));
    EXPECT_EQ(entry(level, "left")["angle_deg"], 90);
}

TEST(ArrangeCommands, MirrorTwiceIsNothing) {
    Json level = small();
    level["objects"][1]["properties"]["shape"] = Json::array(
        {Json{{"form", "polygon"}, {"corners", Json::array({{0, 0}, {1, 0}, {0, 0.5}})}, {"at", {0.25, 0}}}});
    level["joints"][0]["lower_deg"] = -10;
    level["joints"][0]["upper_deg"] = 30;
    for (Mirror const mirror : {Mirror::leftRight, Mirror::upDown}) {
        Command const once = mirrorObjects(editData(), level, {"left", "right"}, mirror, {0, 1});
        Json const mirrored = done(level, once);
        EXPECT_NE(mirrored, level);
        EXPECT_EQ(entry(mirrored, "left")["flipped"], true);
        EXPECT_EQ(mirrored["joints"][0]["lower_deg"], -30);
        EXPECT_EQ(mirrored["joints"][0]["upper_deg"], 10);
        Json const back =
            done(mirrored, mirrorObjects(editData(), mirrored, {"left", "right"}, mirror, {0, 1}));
        EXPECT_EQ(entry(back, "left"), entry(level, "left"));
        EXPECT_EQ(back["joints"], level["joints"]);
        Box const before = *extentOfObjects(editData(), level, {"left"});
        Box const after = *extentOfObjects(editData(), back, {"left"});
        EXPECT_NEAR(length(before.corner - after.corner) + length(before.size - after.size), 0, 1e-9);
    }
    // A symmetric shape of a part is not overridden.
    Json const ball = done(small(), mirrorObjects(editData(), small(), {"ball"}, Mirror::leftRight, {1, 0}));
    EXPECT_EQ(entry(ball, "ball"), (Json{{"name", "ball"}, {"part", "rubber ball"}, {"at", {2, 3}}}));
}

TEST(ArrangeCommands, MeasureAllPiecesOfAPart) {
    Json level = done(small(), addObject(small(), {.part = "doorbell", .at = {0, 5}}));
    std::string const bell = level["objects"].back()["name"];
    Box const box = *extentOfObjects(editData(), level, {bell});
    EXPECT_GT(box.size.x, 0.2);
    EXPECT_FALSE(mayScale(editData(), level, {bell}, {2, 2}));
    Vec2 const centre{box.corner.x + box.size.x, 5};
    level = done(level, mirrorObjects(editData(), level, {bell}, Mirror::leftRight, centre));
    Box const after = *extentOfObjects(editData(), level, {bell});
    EXPECT_NEAR(after.corner.x, centre.x, 1e-9);
    EXPECT_NEAR(after.size.x, box.size.x, 1e-9);
}

TEST(ArrangeCommands, ScaleWhatCanBeScaled) {
    Json const level = done(small(), scaleObjects(editData(), small(), {"right"}, {1, 3}, {2, 0.5}));
    // It stands on its end: the world's vertical is its own x axis.
    EXPECT_EQ(entry(level, "right")["properties"]["shape"][0]["width"], 3);
    EXPECT_EQ(entry(level, "right")["properties"]["shape"][0]["height"], 0.5);
    EXPECT_TRUE(mayScale(editData(), small(), {"ball"}, {2, 2}));
    EXPECT_FALSE(mayScale(editData(), small(), {"ball"}, {2, 1}));
    EXPECT_FALSE(mayScale(editData(), small(), {"right"}, {1e6, 1e6}));
    EXPECT_NE(refusalOf([] {
                  static_cast<void>(scaleObjects(editData(), small(), {"ball"}, {0, 1}, {}));
              }),
              "");
}

TEST(ArrangeCommands, AlignAndDistribute) {
    Json const aligned =
        done(small(), alignObjects(editData(), small(), {"left", "right"}, Alignment::bottom));
    Box const left = *extentOfObjects(editData(), aligned, {"left"});
    Box const right = *extentOfObjects(editData(), aligned, {"right"});
    EXPECT_NEAR(left.corner.y, right.corner.y, 1e-9);
    Json level = done(small(), moveObjects(editData(), small(), {"ball"}, {1.3, 0}));
    level = done(level, distributeObjects(editData(), level, {"left", "right", "ball"}, Axis::x));
    Box const ball = *extentOfObjects(editData(), level, {"ball"});
    EXPECT_NEAR(ball.corner.x - (-1.75), 1.75 - ball.corner.x - ball.size.x, 1e-9);
    Json grouped = done(small(), groupObjects(small(), {"left", "right"}));
    EXPECT_NE(refusalOf([&] {
                  static_cast<void>(alignObjects(editData(), grouped, {"left", "right"}, Alignment::top));
              }),
              "");
}

TEST(Shapes, DivideConcavePolygons) {
    DrawnShape const drawn = drawnPolygon(std::vector<Vec2>{{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}});
    EXPECT_GE(drawn.shape.size(), 2U);
    EXPECT_LE(drawn.shape.size(), 3U);
    EXPECT_NE(refusalOf([] {
                  static_cast<void>(drawnPolygon(std::vector<Vec2>{{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
              }),
              "");
    EXPECT_NE(refusalOf([] {
                  static_cast<void>(drawnPolygon(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}}));
              }),
              "");
    EXPECT_NE(refusalOf([] { static_cast<void>(drawnBox({0, 0}, {0, 1})); }), "");
    EXPECT_EQ(drawnDisc({1, 1}, {1, 2}).shape[0]["radius"], 1);
}

TEST(PropertyCommands, OverrideAndReset) {
    Json level = done(small(), setField(editData(), small(), {"ball", "left"}, "restitution", "", 0.25));
    EXPECT_EQ(entry(level, "ball")["properties"], (Json{{"restitution", 0.25}}));
    EXPECT_EQ(entry(level, "left")["properties"]["restitution"], 0.25);
    level = done(level, resetProperty(editData(), level, {"ball"}, "restitution"));
    EXPECT_EQ(entry(level, "ball"), entry(small(), "ball"));
    level = done(level, removeProperty(editData(), level, {"ball", "left"}, "material"));
    EXPECT_EQ(entry(level, "ball")["properties"]["material"], false);
    EXPECT_FALSE(entry(level, "left")["properties"].contains("material"));
    auto const set = [](std::string const& property, std::string const& field, Json const& value) {
        return refusalOf(
            [&] { done(small(), setField(editData(), small(), {"left"}, property, field, value)); });
    };
    EXPECT_NE(set("mass", "", -1), "");
    EXPECT_NE(set("mass", "", "heavy"), "");
    EXPECT_NE(set("unheard", "", 1), "");
    EXPECT_NE(set("shape", "/7/width", 1), "");
    EXPECT_NE(set("shape", "/0/radius", 1), "");
    EXPECT_EQ(set("shape", "/0/width", 2), "");
}

TEST(PropertyCommands, AddEveryPropertyThatThereIs) {
    for (PropertyInfo const* const info : editData().registry.objectProperties()) {
        std::string const key(info->text.key);
        if (info->text.place != PropertyPlace::properties || key == "generator" || key == "joint" ||
            key == "scripts") { // these need an object or a script to be named
            continue;
        }
        EXPECT_EQ(refusalOf([&] { done(small(), addProperty(editData(), small(), {"left"}, key)); }), "")
            << key;
    }
}

TEST(GoalCommands, KeepATree) {
    Json level = done(small(), wrapGoal(small(), "/all/1", "not"));
    EXPECT_EQ(goalLines(level).size(), 4U);
    EXPECT_EQ(goalLines(level)[2].kind, "not");
    EXPECT_EQ(goalLines(level)[3].place, "/all/1/not");
    level = done(level, setGoalOption(level, "/all/1/not", "for", 2));
    level = done(level, addGoal(level, "/all/1/not", newCondition("on", {"ball"})));
    EXPECT_EQ(level["goals"]["all"][1]["not"]["all"].size(), 2U);
    level = done(level, removeGoal(level, "/all/1/not/all/1"));
    level = done(level, unwrapGoal(level, "/all/1/not"));
    EXPECT_EQ(level["goals"]["all"][1]["not"]["for"], 2);
    level = done(level, removeGoal(level, "/all/1/not"));
    EXPECT_EQ(level["goals"]["all"].size(), 1U);
    level = done(level, removeGoal(level, "/all/0"));
    EXPECT_FALSE(level.contains("goals"));
    EXPECT_NE(refusalOf([&] { return removeGoal(level, ""); }), "");
    level = done(level, addGoal(level, "", newCondition("touching", {"ball", "table"})));
    EXPECT_EQ(goalLines(level).size(), 1U);
}

TEST(Clipboard, PastesIntoAnotherLevel) {
    std::string const text = copiedText(editData(), small(), {"left", "right"});
    EXPECT_TRUE(canPaste(text));
    Json other = LevelDocument::blank(editData()).tree();
    other = done(other, pasteText(editData(), other, text, Vec2{10, 10}));
    EXPECT_EQ(objectNames(other), (std::vector<std::string>{"floor", "left", "right"}));
    EXPECT_EQ(other["joints"].size(), 2U);
    EXPECT_EQ(entry(other, "left")["at"], Json::array({8, 9.875}));
    Json const again = done(small(), pasteText(editData(), small(), text));
    EXPECT_EQ(entry(again, "left 2")["at"], Json::array({-1.8, 0.05}));
    for (std::string const bad :
         {"", "x", "{}", "[1]", R"({"trembler":"objects","version":2,"objects":[3]})"}) {
        EXPECT_FALSE(canPaste(bad)) << bad;
    }
}

TEST(OwnParts, AreMadeFromObjects) {
    Json const one = partFrom(editData(), small(), {"left"}, "left", {"box", "", ""});
    auto const document = JsonDocument::parse(one.dump(), "part");
    EXPECT_EQ(readPart(editData().registry, document).name, "box");
    Json const two = partFrom(editData(), small(), {"left", "right"}, "left", {"pair", "A pair", "Two."});
    EXPECT_EQ(two["objects"][1]["at"], Json::array({4, 0.25}));
    EXPECT_EQ(two["joints"].size(), 2U);
    auto const folder = testFolder() / "parts";
    auto const first = writePart(folder, two);
    EXPECT_NE(writePart(folder, two), first);
    EXPECT_EQ(Json::parse(fileText(first)), two);
    EXPECT_NE(refusalOf([] {
                  static_cast<void>(partFrom(editData(), small(), {"left"}, "left", {"plank", "", ""}));
              }),
              "");
    Json const replaced =
        done(small(), replaceByPart(editData(), small(), {"left", "right"}, "left", "pair"));
    EXPECT_EQ(objectNames(replaced), (std::vector<std::string>{"table", "left", "ball"}));
    EXPECT_FALSE(replaced.contains("joints"));
}

TEST(ContentCommands, StepsAndWires) {
    Json level = done(small(), addStep(small(), newStep("place", {"steel ball"}, {1, 2}).value()));
    level = done(level, addStep(level, newStep("wire", {"left", "right"}, {}).value()));
    level = done(level, addStep(level, newStep("run", {}, {}).value()));
    EXPECT_EQ(level["teaching"], Json::parse(R"([{"place": "steel ball", "at": [1, 2]},
                                                 {"wire": ["left", "right"]}, {"run": true}])"));
    EXPECT_FALSE(newStep("cut", {"left"}, {}).has_value()) << "a wire has two ends";
    level = done(level, renameObject(editData(), level, "left", "west"));
    EXPECT_EQ(level["teaching"][1]["wire"][0], "west");
    level = done(level, moveStep(level, 2, 0));
    EXPECT_TRUE(level["teaching"][0].contains("run"));
    level = done(level, setStep(level, 0, newStep("grab", {"ball"}, {0, 1}).value()));
    EXPECT_EQ(level["teaching"][0]["grab"], "ball");
    level = done(level, removeStep(level, 1));
    EXPECT_EQ(level["teaching"].size(), 2U);
    EXPECT_NE(refusalOf([&] { return removeStep(level, 2); }), "");
    level = done(level, setWires(level, 3));
    EXPECT_EQ(level["toolbox"][1], (Json{{"wire", 3}}));
    level = done(level, setWires(level, 5));
    EXPECT_EQ(level["toolbox"][1], (Json{{"wire", 5}}));
    level = done(level, setWires(level, 0));
    EXPECT_EQ(level["toolbox"].size(), 1U);
    EXPECT_NE(refusalOf([&] { return setWires(level, 1001); }), "");
}

TEST(SolutionCommands, RecordAndExpect) {
    Solution run;
    run.name = "wait";
    run.frames = 10;
    Json level = done(small(), addSolution(small(), run));
    EXPECT_EQ(level["solutions"][1]["name"], "wait 2");
    level = done(level, expectSolved(level, "wait", false));
    level = done(level, recordAgain(level, "wait", run));
    EXPECT_EQ(level["solutions"][0], (Json{{"name", "wait"}, {"expect", "unsolved"}, {"frames", 10}}));
    run.wires.push_back({"left", "right", ""});
    level = done(level, recordAgain(level, "wait", run));
    EXPECT_EQ(level["solutions"][0]["wires"], Json::parse(R"([["left", "right"]])"));
    run.wires.clear();
    level = done(level, recordAgain(level, "wait", run));
    EXPECT_FALSE(level["solutions"][0].contains("wires")) << "of the run before";
    level = done(level, setSolutionFrames(level, "wait", 90));
    EXPECT_EQ(level["solutions"][0]["frames"], 90);
    level = done(level, setSolutionFrames(level, "wait", 0));
    EXPECT_FALSE(level["solutions"][0].contains("frames"));
    std::string const refused = refusalOf([&] { return setSolutionFrames(level, "wait", -1); });
    EXPECT_NE(refused.find(fmt::format("1 to {} frames, or 0", limits::frames)), std::string::npos)
        << "0 is allowed: " << refused;
    level = done(level, moveSolution(level, 1, 0));
    EXPECT_EQ(level["solutions"][0]["name"], "wait 2");
    EXPECT_NE(refusalOf([&] { return renameSolution(level, "wait", "wait 2"); }), "");
    level = done(level, removeSolution(level, "wait 2"));
    EXPECT_EQ(level["solutions"].size(), 1U);
}

TEST(Commands, RefuseTreesOfAnotherForm) {
    LevelDocument document = LevelDocument::fromText(
        editData(),
        R"({"objects": 3, "joints": {}, "goals": [], "editor": 1, "toolbox": [1], "solutions": 2})", {}, {});
    int state = 1;
    auto const next = [&](int below) { // any fixed sequence of numbers
        state = (state * 1103 + 12345) % 65536;
        return state % below;
    };
    for (int i = 0; i < 500; ++i) {
        try {
            document.run(anyCommand(document, next));
        } catch (CommandError const&) {
            continue;
        } catch (Json::exception const& error) {
            FAIL() << error.what();
        }
    }
}

} // namespace
} // namespace trembler::edit
