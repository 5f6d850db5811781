// All drawing tools follow one rule: a tool stays until another one or Select is chosen.
#include "tests/game/ui/edit/editor_kit.hpp"

namespace trembler::ui::test {
namespace staying_tools_test {
namespace {

char const* const room = R"({"version": 2, "title": "Room",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "floor", "at": [0, 0.75], "properties": {"material": "stone", "fixed": true,
         "shape": [{"form": "box", "width": 6, "height": 1.5}]}},
        {"name": "ball", "at": [1, 2], "properties": {"material": "wood",
         "shape": [{"form": "circle", "radius": 0.2}]}},
        {"name": "rod", "at": [2, 2], "properties": {"material": "steel",
         "shape": [{"form": "box", "width": 0.2, "height": 0.8}]}},
        {"name": "bar", "at": [2.6, 2], "properties": {"material": "steel",
         "shape": [{"form": "box", "width": 0.2, "height": 0.8}]}}]})";

std::size_t entries(Designer& designer) {
    std::size_t goals = 0;
    if (designer.tree().contains("goals")) {
        goals = designer.tree()["goals"].dump().size();
    }
    return designer.count("objects") + designer.count("joints") + designer.count("connections") +
           designer.count("placing") + goals;
}

void drawWith(Designer& designer, Tool tool, Vec2 by) {
    if (tool == Tool::polygon) {
        for (Vec2 const corner : {Vec2{-2, 2}, Vec2{-1.5, 2}, Vec2{-1.75, 2.5}, Vec2{-2, 2}}) {
            designer.click(designer.on(corner + by));
        }
    } else if (tool == Tool::wire) {
        designer.drag(designer.on(by.y > 0 ? Vec2{2.6, 2} : Vec2{2, 2}),
                      designer.on({1, by.y > 0 ? 1. : 2.}));
        designer.drag(designer.on({2, 2}), designer.on({2.6, 2}));
    } else if (tool == Tool::joint) {
        designer.drag(designer.on({1, 2}), designer.on(Vec2{2, 2.2} + by));
    } else {
        designer.drag(designer.on(Vec2{-2, 2} + by), designer.on(Vec2{-1.5, 2.3} + by));
    }
}

TEST(StayingTools, EachStaysUntilItIsPutAway) {
    Designer designer;
    designer.editText(room);
    for (Tool const tool : {Tool::box, Tool::disc, Tool::capsule, Tool::polygon, Tool::joint, Tool::wire,
                            Tool::placing, Tool::goalArea}) {
        designer.parts().document.goTo(0);
        designer.frames(2);
        designer.parts().selection.set({"ball"});
        auto const key = static_cast<SDL_Keycode>(SDLK_1 + static_cast<int>(tool));
        designer.key(key);
        ASSERT_EQ(designer.parts().tool, tool);
        std::size_t const before = entries(designer);
        drawWith(designer, tool, {0, 0});
        std::size_t const once = entries(designer);
        EXPECT_GT(once, before) << static_cast<int>(tool);
        EXPECT_EQ(designer.parts().tool, tool);
        if (tool == Tool::goalArea) { // the selected object is the one of the first goal
            designer.parts().selection.set({"ball"});
        }
        if (tool != Tool::wire) { // there is no second pair
            drawWith(designer, tool, {0.6, 0.4});
            EXPECT_GT(entries(designer), once) << static_cast<int>(tool);
        }
        EXPECT_EQ(designer.parts().tool, tool);
        designer.key(SDLK_ESCAPE);
        EXPECT_EQ(designer.parts().tool, Tool::select);
        designer.key(key);
        designer.click(designer.on({-3, 3}), MouseButton::Right);
        EXPECT_EQ(designer.parts().tool, Tool::select);
        designer.key(key);
        designer.key(SDLK_1);
        EXPECT_EQ(designer.parts().tool, Tool::select);
    }
}

TEST(StayingTools, TheSecondWallDoesNotMoveTheFloor) {
    Designer designer;
    designer.editText(room);
    Vec2 const floor = designer.placeOf("floor");
    std::size_t const before = designer.count("objects");
    designer.key(SDLK_b);
    designer.drag(designer.on({-2, 1.5}), designer.on({-1.8, 2.5}));
    designer.drag(designer.on({-1, 1.4}), designer.on({-0.8, 2.5})); // it begins on the floor
    designer.drag(designer.on({-1.8, 1.5}), designer.on({-1, 1.6})); // at a corner of the first wall
    EXPECT_EQ(designer.count("objects"), before + 3);
    EXPECT_EQ(designer.placeOf("floor"), floor);
    EXPECT_EQ(designer.placeOf("box"), (Vec2{-1.9, 2}));
    designer.look("edit-walls");
}

TEST(StayingTools, CornersOfOneToolAreNotThoseOfAnother) {
    Designer designer;
    designer.editText(room);
    std::size_t const before = designer.count("objects");
    designer.key(SDLK_p);
    designer.click(designer.on({-2, 2}));
    designer.click(designer.on({-1.5, 2}));
    designer.key(SDLK_b);
    EXPECT_TRUE(designer.screen().mouse().corners().empty());
    designer.drag(designer.on({-2, 2.5}), designer.on({-1.5, 3}));
    EXPECT_EQ(designer.count("objects"), before + 1);
}

} // namespace
} // namespace staying_tools_test
} // namespace trembler::ui::test
