// Lists of the editor's panels are searched by typing and used by keys, with real input events.
#include "puzzle/edit/commands/objects.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

namespace trembler::ui::test {
namespace drop_down_test {
namespace {

char const* const room = R"({"version": 2, "title": "Room",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "crate", "part": "crate", "at": [-1, 1]},
        {"name": "ball", "at": [1, 1], "properties": {"material": "wood",
         "shape": [{"form": "circle", "radius": 0.2}]}}]})";

class Lists : public testing::Test {
protected:
    Lists() { designer.editText(room); }
    void open(std::string const& object, std::string const& item) {
        designer.parts().selection.set({object});
        designer.parts().tab = Tab::properties;
        designer.frames(2);
        designer.clickItem(item);
        designer.frames(2);
        ASSERT_TRUE(designer.parts().dropDown.open());
    }
    edit::Json const& entry(std::string const& name) { return *edit::findObject(designer.tree(), name); }

    Designer designer;
};

TEST_F(Lists, ALongListIsNarrowedDownByLetters) {
    open("crate", "object part");
    std::size_t const all = designer.parts().data->parts.names().size();
    ASSERT_GT(all, 60U);
    designer.typeText("push");
    designer.frames(2);
    EXPECT_TRUE(designer.shows("object part = push switch"));
    EXPECT_FALSE(designer.shows("object part = bell"));
    designer.look("edit-list-typed");
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_FALSE(designer.parts().dropDown.open());
    EXPECT_EQ(entry("crate")["part"], "push switch");
    EXPECT_EQ(designer.parts().test, nullptr) << "Enter was the list's";
}

TEST_F(Lists, LettersCanBeErasedAndEscapeChangesNothing) {
    open("crate", "object part");
    designer.typeText("pushx");
    designer.frames(2);
    EXPECT_FALSE(designer.shows("object part = push switch"));
    designer.key(SDLK_RETURN); // there is nothing to choose
    EXPECT_TRUE(designer.parts().dropDown.open());
    designer.key(SDLK_BACKSPACE);
    designer.frames(2);
    EXPECT_TRUE(designer.shows("object part = push switch"));
    designer.key(SDLK_ESCAPE);
    designer.frames(3);
    EXPECT_FALSE(designer.parts().dropDown.open());
    EXPECT_EQ(entry("crate")["part"], "crate");
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{"crate"});
}

TEST_F(Lists, APropertyIsAddedInTwoActions) {
    open("ball", "add property");
    designer.look("edit-list-properties");
    designer.typeText("fixed");
    designer.frames(2);
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_EQ(entry("ball")["properties"]["fixed"], true);
}

TEST_F(Lists, ArrowsMoveTheMarkFromThePresentEntry) {
    std::vector<std::string> materials;
    open("ball", "material");
    for (Placed const& item : designer.layout().items()) {
        if (item.name.starts_with("material = ")) {
            materials.push_back(item.name.substr(11));
        }
    }
    auto const wood = std::find(materials.begin(), materials.end(), "wood");
    ASSERT_NE(wood, materials.end());
    ASSERT_NE(wood, materials.begin());
    designer.key(SDLK_UP);
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_EQ(entry("ball")["properties"]["material"], *(wood - 1));
    open("ball", "material");
    designer.key(SDLK_HOME);
    designer.key(SDLK_DOWN);
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_EQ(entry("ball")["properties"]["material"], materials[1]);
}

TEST_F(Lists, InAShortListLettersGoToTheFirstFit) {
    designer.parts().tool = Tool::joint;
    designer.frames(2);
    designer.clickItem("joint form");
    designer.frames(2);
    designer.typeText("w");
    designer.typeText("h");
    designer.frames(1);
    EXPECT_TRUE(designer.shows("joint form = rope") || designer.shows("joint form = wheel"));
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_EQ(designer.parts().jointForm, "wheel");
    EXPECT_EQ(designer.parts().tool, Tool::joint) << "the letters were no commands";
}

TEST_F(Lists, WorkInThePanelByKeysAlone) {
    designer.parts().selection.set({"crate"});
    designer.parts().tab = Tab::properties;
    designer.key(SDLK_F9);
    designer.frames(2);
    designer.key(SDLK_DOWN); // the name, then the part
    designer.frames(2);
    for (int i = 0; i < 4 && !designer.parts().dropDown.open(); ++i) {
        designer.key(SDLK_SPACE);
        designer.frames(2);
        if (!designer.parts().dropDown.open()) {
            designer.key(SDLK_DOWN);
            designer.frames(2);
        }
    }
    ASSERT_TRUE(designer.parts().dropDown.open());
    designer.typeText("bell");
    designer.frames(1);
    designer.key(SDLK_RETURN);
    designer.frames(3);
    EXPECT_EQ(entry("crate")["part"], "bell");
    EXPECT_TRUE(designer.parts().panelKeys) << "the panel still has the keyboard";
}

} // namespace
} // namespace drop_down_test
} // namespace trembler::ui::test
