// Wires and joints are drawn from piece to piece, with real input events.
#include "game/ui/edit/tools/join_tool.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "render/scene/facts/pick.hpp"
#include "render/scene/facts/poses.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <algorithm>
#include <set>

namespace trembler::ui::test {
namespace join_tool_test {
namespace {

char const* const circuit = R"({"version": 2, "title": "Circuit",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "floor", "at": [0, -0.15], "properties": {"material": "stone", "fixed": true,
         "shape": [{"form": "box", "width": 7.6, "height": 0.3}]}},
        {"name": "cell", "part": "battery", "at": [-2, 0.12]},
        {"name": "button", "part": "push switch", "at": [0, 0.18]},
        {"name": "light", "part": "bulb", "at": [2, 0.26]},
        {"name": "plank", "at": [-1, 2], "properties": {"material": "wood",
         "shape": [{"form": "box", "width": 0.5, "height": 0.2}]}},
        {"name": "beam", "at": [1, 2], "properties": {"material": "wood",
         "shape": [{"form": "box", "width": 0.5, "height": 0.2}]}},
        {"name": "wall", "at": [3, 2], "properties": {"material": "stone", "fixed": true,
         "shape": [{"form": "box", "width": 0.3, "height": 1}]}}],
    "placing": [[-1, 1, 1, 1]],
    "goals": {"moved": {"object": "plank", "by": 1}}})";

using Names = std::set<std::string>;

class Joining : public testing::Test {
protected:
    Joining() {
        designer.editText(circuit);
        designer.frames(20);
    }
    /// Where a piece of the world is.
    Vec2 at(std::string const& name) {
        Store const& store = designer.parts().world.world()->store();
        ObjectId const object = store.find(name);
        EXPECT_TRUE(object.valid()) << name;
        return store.findColumn<Position>()->find(object)->value;
    }
    Point on(std::string const& name) { return designer.on(at(name)); }
    Names connections() {
        Names all;
        if (designer.tree().contains("connections")) {
            for (auto const& pair : designer.tree()["connections"]) {
                all.insert(pair[0].get<std::string>() + " to " + pair[1].get<std::string>());
            }
        }
        return all;
    }
    JoinTool const& join() { return designer.screen().mouse().join(); }
    std::vector<std::string> problems() {
        designer.frames(40);
        std::vector<std::string> all;
        for (edit::Problem const& problem : designer.parts().problems.all()) {
            all.push_back(problem.words());
        }
        return all;
    }
    Names lit(JoinEnd const& from = {}) {
        Names names;
        Store const& store = designer.parts().world.world()->store();
        for (ObjectId const object : joinableInView(designer.parts(), from)) {
            names.insert(store.nameOf(object));
        }
        return names;
    }

    Designer designer;
};

TEST_F(Joining, ThreeWiresAreThreeDrags) {
    std::vector<std::string> const before = problems();
    designer.key(SDLK_w);
    designer.drag(on("cell plus"), on("button left") - Point{6, 0});
    designer.drag(on("button right") + Point{6, 0}, on("light left"));
    designer.drag(on("light right"), on("cell minus"));
    EXPECT_EQ(connections(),
              (Names{"cell plus to button left", "button right to light left", "light right to cell minus"}));
    EXPECT_EQ(problems(), before) << "what was drawn is right as it is";
    EXPECT_EQ(designer.parts().tool, Tool::wire) << "the tool stays";
    EXPECT_EQ(designer.parts().document.done(), 3U) << "each is a step";
    // They are drawn: the longest one can be clicked where it hangs below the floor.
    designer.key(SDLK_s);
    std::vector<Point> const path = pathOf(designer.parts(), "light right", "cell minus");
    ASSERT_GE(path.size(), 2U);
    Point const middle = 0.5 * (path[(path.size() - 1) / 2] + path[path.size() / 2]);
    designer.click(designer.on({middle.x, middle.y}));
    EXPECT_EQ(designer.parts().selection.kind(), EntryKind::connection);
    designer.key(SDLK_w);
    designer.look("edit-three-wires");
}

TEST_F(Joining, ThePieceUnderThePointerIsTakenAtAnyZoom) {
    for (int const notches : {0, 6, 8}) {
        designer.key(SDLK_s);
        designer.moveTo(on("cell minus"));
        for (int i = 0; i < notches; ++i) {
            designer.wheel(1);
        }
        designer.frames(30);
        designer.doubleClick(on("cell minus"));
        EXPECT_EQ(designer.parts().selection.piece(), "minus") << notches;
        designer.key(SDLK_w);
        designer.moveTo(on("cell minus"));
        EXPECT_EQ(join().under().name, "cell minus") << notches;
        EXPECT_EQ(join().why(), "") << notches;
        designer.moveTo(on("cell plus"));
        EXPECT_EQ(join().under().name, "cell plus") << notches;
        designer.moveTo(on("cell"));
        EXPECT_EQ(join().under().name, "cell") << notches << ": the case, by the name of the whole";
    }
    designer.look("edit-wire-zoomed");
}

TEST_F(Joining, AWireIsAlsoTwoClicksAndIsLetGo) {
    designer.key(SDLK_w);
    designer.click(on("cell plus"));
    EXPECT_EQ(join().from().name, "cell plus");
    designer.click(on("button right") + Point{6, 0});
    EXPECT_EQ(connections(), Names{"cell plus to button right"});
    EXPECT_FALSE(join().from().valid());
    auto const begin = [&] {
        designer.key(SDLK_w);
        if (designer.parts().tool != Tool::wire) {
            designer.key(SDLK_w);
        }
        designer.click(on("cell plus"));
        EXPECT_EQ(join().from().name, "cell plus");
    };
    designer.key(SDLK_s);
    begin();
    designer.key(SDLK_ESCAPE);
    EXPECT_FALSE(join().from().valid());
    EXPECT_EQ(designer.parts().tool, Tool::wire) << "first the wire is let go, then the tool";
    designer.key(SDLK_ESCAPE);
    EXPECT_EQ(designer.parts().tool, Tool::select);
    begin();
    designer.click(designer.on({0, 1}), MouseButton::Right);
    EXPECT_FALSE(join().from().valid());
    designer.key(SDLK_s);
    begin();
    designer.key(SDLK_b); // another tool
    EXPECT_FALSE(join().from().valid());
    designer.key(SDLK_s);
    begin();
    designer.click(designer.on({0, 1})); // the paper
    EXPECT_FALSE(join().from().valid());
    EXPECT_EQ(connections().size(), 1U);
}

TEST_F(Joining, WhatAWireCannotJoinSaysWhy) {
    designer.key(SDLK_w);
    auto const toasts = designer.app().context().toasts.count();
    designer.moveTo(on("cell"));
    EXPECT_NE(join().why().find("current"), std::string::npos) << join().why();
    designer.look("edit-wire-refused");
    designer.drag(on("cell"), on("light left"));
    EXPECT_EQ(connections(), Names{});
    EXPECT_GT(designer.app().context().toasts.count(), toasts);
    designer.drag(on("cell plus"), on("plank"));
    EXPECT_EQ(connections(), Names{});
    designer.drag(on("cell plus"), on("cell plus") + Point{2, 2}); // no drag: a click
    designer.moveTo(on("plank"));
    EXPECT_NE(join().why(), "");
    designer.moveTo(on("light left"));
    EXPECT_EQ(join().why(), "");
    designer.click(on("light left"));
    ASSERT_EQ(connections(), Names{"cell plus to light left"});
    designer.click(on("light left"));
    designer.moveTo(on("cell plus"));
    EXPECT_NE(join().why(), "") << "they are connected already";
    designer.click(on("cell plus"));
    EXPECT_EQ(connections().size(), 1U);
}

TEST_F(Joining, AnEndThatIsRefusedLeavesTheWireInTheHand) {
    designer.key(SDLK_w);
    auto& toasts = designer.app().context().toasts;
    auto const before = toasts.count();
    designer.drag(on("cell plus"), on("plank"));
    EXPECT_EQ(join().from().name, "cell plus") << "after a drag";
    EXPECT_EQ(toasts.count(), before + 1) << "the designer is told once";
    designer.click(on("plank"));
    EXPECT_EQ(join().from().name, "cell plus") << "after a click";
    designer.click(on("cell plus"));
    EXPECT_EQ(join().from().name, "cell plus") << "after a click on the beginning";
    designer.click(on("light left"));
    EXPECT_EQ(connections(), Names{"cell plus to light left"});
    EXPECT_FALSE(join().from().valid());
    designer.drag(on("cell plus"), on("plank"));
    designer.drag(on("cell plus"), on("light right")); // from the beginning once more
    EXPECT_EQ(connections().size(), 2U);
    designer.click(on("cell plus"));
    designer.click(on("plank"));
    designer.key(SDLK_ESCAPE);
    EXPECT_FALSE(join().from().valid());
    EXPECT_EQ(designer.parts().tool, Tool::wire);
}

TEST_F(Joining, OnThePaperTheToolSaysHowItBegins) {
    auto const says = [&](std::string const& words) {
        designer.look("edit-join-begins");
        std::vector<std::string> const lines = DrawnWords().lines();
        return std::count_if(lines.begin(), lines.end(),
                             [&](std::string const& line) { return line.find(words) != std::string::npos; });
    };
    Point const paper = designer.on({0, 3});
    designer.moveTo(paper);
    for (auto const& [key, words] :
         {std::pair(SDLK_w, "the wire begins there"), std::pair(SDLK_j, "Drag from one object to another")}) {
        EXPECT_EQ(says(words), 0) << words;
        designer.key(key);
        designer.moveTo(paper);
        EXPECT_EQ(says(words), 1) << words;
        designer.moveTo(on("cell plus"));
        EXPECT_EQ(says(words), 0) << "over an object its name is said";
        designer.moveTo(paper);
    }
}

TEST_F(Joining, AJointThatIsThereIsNotMadeAgain) {
    designer.key(SDLK_j);
    designer.doubleClick(on("beam"));
    ASSERT_EQ(designer.count("joints"), 1U);
    designer.moveTo(on("beam"));
    designer.press();
    designer.frame();
    EXPECT_NE(join().why().find("already"), std::string::npos) << join().why();
    designer.release();
    EXPECT_EQ(designer.count("joints"), 1U);
    designer.click(on("beam") + Point{15, 0});
    EXPECT_EQ(designer.count("joints"), 2U) << "at another place of it";
    designer.parts().jointForm = "weld";
    designer.click(on("beam"));
    EXPECT_EQ(designer.count("joints"), 3U) << "of another form";
    designer.parts().jointForm = "rope";
    designer.drag(on("plank"), on("cell plus"));
    designer.drag(on("cell plus"), on("plank"));
    EXPECT_EQ(designer.count("joints"), 4U) << "the same rope from its other end";
}

TEST_F(Joining, WhatCanBeJoinedLightsUp) {
    designer.key(SDLK_w);
    Store const& store = designer.parts().world.world()->store();
    Names conductors;
    for (char const* const entry : {"floor", "cell", "button", "light", "plank", "beam", "wall"}) {
        for (ObjectId const object : designer.parts().world.objectsOf(entry)) {
            if (store.has<Conductor>(object)) {
                conductors.insert(store.nameOf(object));
            }
        }
    }
    EXPECT_GE(conductors.size(), 8U);
    EXPECT_EQ(lit(), conductors);
    designer.click(on("cell plus"));
    Names others = conductors;
    others.erase("cell plus");
    EXPECT_EQ(lit(join().from()), others);
    designer.click(on("light left"));
    designer.click(on("cell plus"));
    others.erase("light left");
    EXPECT_EQ(lit(join().from()), others) << "not what it is connected with already";
    designer.look("edit-wire-lit");
    designer.key(SDLK_j);
    Names const all = lit();
    EXPECT_TRUE(all.contains("plank") && all.contains("cell plus") && all.contains("wall"));
    JoinEnd const wall = endNamed(designer.parts(), "wall");
    Names const toWall = lit(wall);
    EXPECT_FALSE(toWall.contains("floor")) << "both are fixed";
    EXPECT_TRUE(toWall.contains("plank"));
    // Only what is in the view is looked for.
    designer.key(SDLK_w);
    designer.moveTo(on("cell plus"));
    for (int i = 0; i < 10; ++i) {
        designer.wheel(1);
    }
    Names const near = lit();
    EXPECT_TRUE(near.contains("cell plus"));
    EXPECT_LT(near.size(), conductors.size());
    render::Extent const view = render::viewOf(designer.parts().camera());
    World const& world = *designer.parts().world.world();
    render::FactsReader const reader(world);
    for (std::string const& name : conductors) {
        render::Facts const facts = reader.of(world.store().find(name));
        EXPECT_EQ(near.contains(name), render::extentOf(facts, render::poseOf(facts)).overlaps(view)) << name;
    }
}

TEST_F(Joining, JointsTakePiecesAndSayWhyNot) {
    designer.key(SDLK_j);
    designer.drag(on("plank"), on("cell plus"));
    ASSERT_EQ(designer.count("joints"), 1U);
    EXPECT_EQ(designer.tree()["joints"][0]["a"], "plank");
    EXPECT_EQ(designer.tree()["joints"][0]["b"], "cell plus");
    designer.drag(on("wall"), designer.on({3.5, 3}));
    EXPECT_EQ(designer.count("joints"), 1U) << "a fixed object cannot be held to the world";
    designer.moveTo(on("wall"));
    designer.press();
    designer.moveTo(on("floor"));
    EXPECT_NE(join().why().find("fixed"), std::string::npos) << join().why();
    designer.look("edit-joint-refused");
    designer.release();
    EXPECT_EQ(designer.count("joints"), 1U);
    designer.click(on("beam"));
    ASSERT_EQ(designer.count("joints"), 2U);
    EXPECT_FALSE(designer.tree()["joints"][1].contains("b")) << "a click holds it to the world";
}

TEST_F(Joining, EveryFormOfJointIsRightAsItIsDrawn) {
    for (std::string_view const form : choiceNames<JointForm>) {
        designer.editText(circuit);
        std::vector<std::string> const before = problems();
        designer.key(SDLK_j);
        if (form == "gear") { // what it couples must turn
            for (char const* const name : {"plank", "beam"}) {
                designer.click(on(name));
            }
            ASSERT_EQ(designer.count("joints"), 2U);
        }
        designer.parts().jointForm = form;
        std::size_t const joints = designer.count("joints");
        designer.drag(on("plank"), on("beam"));
        ASSERT_EQ(designer.count("joints"), joints + 1) << form << ": " << join().why();
        EXPECT_EQ(designer.tree()["joints"].back()["form"], form);
        EXPECT_EQ(problems(), before) << form;
    }
    designer.editText(circuit);
    designer.key(SDLK_j);
    designer.parts().jointForm = "gear";
    designer.moveTo(on("plank"));
    designer.press();
    designer.moveTo(on("beam"));
    EXPECT_NE(join().why().find("hinge"), std::string::npos) << join().why();
    designer.release();
    EXPECT_EQ(designer.count("joints"), 0U);
}

TEST_F(Joining, ByKeysASelectedPieceOrTheOnlyConductorIsTheEnd) {
    designer.parts().selection.set({"cell", "light"});
    designer.key(SDLK_w);
    designer.key(SDLK_w);
    EXPECT_EQ(connections(), Names{}) << "a battery has two poles: which one is meant is not known";
    designer.parts().selection.set({"button", "light"});
    designer.frame();
    EXPECT_EQ(selectedEnds(designer.parts(), Tool::wire).size(), 2U);
    EXPECT_EQ(selectedEnds(designer.parts(), Tool::wire)[1].name, "light") << "its glass conducts";
    designer.parts().selection.set({"cell"});
    designer.parts().selection.choosePiece("plus");
    EXPECT_EQ(selectedEnds(designer.parts(), Tool::wire).front().name, "cell plus");
}

TEST_F(Joining, LockedObjectsAreEndsToo) {
    designer.parts().selection.set({"cell"});
    designer.key(SDLK_l);
    designer.parts().selection.clear();
    designer.key(SDLK_w);
    designer.drag(on("cell plus"), on("light left"));
    EXPECT_EQ(connections(), Names{"cell plus to light left"});
}

} // namespace
} // namespace join_tool_test
} // namespace trembler::ui::test
