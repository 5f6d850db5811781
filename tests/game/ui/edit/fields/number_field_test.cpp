// One click on a number begins to type, Tab goes on to the next one, a drag changes it; with real input
// events.
#include "puzzle/edit/commands/objects.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <cmath>

namespace trembler::ui::test {
namespace number_field_test {
namespace {

char const* const room = R"({"version": 2, "title": "Room",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "crate", "part": "crate", "at": [-1, 1]},
        {"name": "chip", "at": [1, 1.123456789], "properties": {"material": "wood",
         "shape": [{"form": "polygon", "corners": [[-0.067974321, -0.1], [0.2, -0.1], [0, 0.2]]}]}}]})";

class Numbers : public testing::Test {
protected:
    Numbers() {
        designer.editText(room);
        select("crate");
    }
    void select(std::string const& name) {
        designer.parts().selection.set({name});
        designer.parts().tab = Tab::properties;
        designer.frames(2);
    }
    bool typing() { return designer.app().context().gui.wantsKeyboard(); }

    Designer designer;
};

TEST_F(Numbers, OneClickBeginsToType) {
    designer.clickItem("at x");
    designer.frames(1);
    ASSERT_TRUE(typing());
    designer.ctrl(SDLK_a);
    EXPECT_EQ(designer.parts().selected().size(), 1U) << "Ctrl+A selects in the field";
    designer.typeText("1.25");
    designer.look("edit-number-typed");
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_FALSE(typing());
    EXPECT_EQ(designer.parts().test, nullptr) << "Enter ends the typing and starts no test";
    EXPECT_EQ(designer.placeOf("crate"), (Vec2{1.25, 1}));
    EXPECT_EQ(designer.parts().document.done(), 1U) << "one step of undo";
}

TEST_F(Numbers, TabGoesOnToTheNext) {
    designer.clickItem("at x");
    designer.frames(1);
    designer.typeText("0.5");
    designer.key(SDLK_TAB);
    designer.frames(3);
    ASSERT_TRUE(typing());
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{"crate"});
    designer.typeText("2");
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_EQ(designer.placeOf("crate"), (Vec2{0.5, 2}));
}

TEST_F(Numbers, EscapeTakesTheTypedNumberBack) {
    designer.clickItem("at x");
    designer.frames(1);
    designer.typeText("3");
    designer.key(SDLK_ESCAPE);
    designer.frames(2);
    EXPECT_FALSE(typing());
    EXPECT_EQ(designer.placeOf("crate"), (Vec2{-1, 1}));
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{"crate"});
}

TEST_F(Numbers, ADragChangesIt) {
    Point const at = designer.item("at x");
    designer.drag(at, at + Point{60, 0});
    EXPECT_GT(designer.placeOf("crate").x, -0.9);
    EXPECT_FALSE(typing());
    EXPECT_EQ(designer.parts().document.done(), 1U);
}

TEST_F(Numbers, ADragMakesRoundNumbers) {
    for (int const pixels : {37, 53}) {
        Point const at = designer.item("at x");
        double const before = designer.placeOf("crate").x;
        designer.drag(at, at + Point{1.0 * pixels, 0});
        double const after = designer.placeOf("crate").x;
        EXPECT_GT((after - before) * pixels, 0);
        EXPECT_NEAR(100 * after, std::round(100 * after), 1e-6) << "a centimetre, after " << pixels;
    }
}

TEST_F(Numbers, LookingAtALongNumberChangesNothing) {
    select("chip");
    std::string const before = designer.parts().document.text();
    designer.seek("shape/0/corners/0 x");
    designer.look("edit-number-long");
    for (char const* const item : {"shape/0/corners/0 x", "shape/0/corners/1 y"}) {
        designer.clickItem(item);
        designer.frames(2);
        ASSERT_TRUE(typing()) << item;
        designer.key(SDLK_RETURN);
        designer.frames(2);
        designer.clickItem(item);
        designer.frames(2);
        designer.key(SDLK_TAB);
        designer.frames(2);
        designer.key(SDLK_TAB);
        designer.frames(2);
        designer.key(SDLK_ESCAPE);
        designer.frames(2);
    }
    EXPECT_EQ(designer.parts().document.text(), before);
    EXPECT_EQ(designer.parts().document.done(), 0U);
}

TEST_F(Numbers, TheGridStepIsTypedAfterOneClick) {
    designer.clickItem("grid step");
    designer.frames(1);
    designer.typeText("0.1");
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_EQ(designer.parts().snapping.grid, 0.1);
}

} // namespace
} // namespace number_field_test
} // namespace trembler::ui::test
