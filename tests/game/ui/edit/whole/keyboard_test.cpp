// A level made by the keyboard alone or a gamepad, the player's own parts, which can be used at once, and
// texts; with real key events.
#include "puzzle/edit/commands/objects.hpp"
#include "render/window/gamepad.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <algorithm>
#include <cstdlib>

namespace trembler::ui::test {
namespace keyboard_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";

Vec2 pointIn(edit::Json const& point) {
    return {point[0].get<double>(), point[1].get<double>()};
}

TEST(EditorKeyboard, ObjectsJointsWiresAndAreas) {
    Designer designer;
    designer.editNew();
    designer.key(SDLK_2);
    designer.key(SDLK_2); // a box in the middle
    designer.key(SDLK_3);
    designer.key(SDLK_3); // a disc in the middle
    ASSERT_EQ(designer.count("objects"), 3U);
    std::string const disc = designer.parts().selected().front();
    Vec2 const before = designer.placeOf(disc);
    designer.key(SDLK_RIGHT);
    designer.key(SDLK_UP, KMOD_LSHIFT);
    EXPECT_NEAR(designer.placeOf(disc).x - before.x, 0.05, 1e-9);
    EXPECT_NEAR(designer.placeOf(disc).y - before.y, 0.001, 1e-9);
    designer.key(SDLK_TAB); // around to the floor
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{"floor"});
    designer.key(SDLK_TAB, KMOD_LSHIFT);
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{disc});
    designer.key(SDLK_TAB, KMOD_LCTRL | KMOD_LSHIFT);
    EXPECT_EQ(designer.parts().selected(), (std::vector<std::string>{disc, "box"}));
    designer.key(SDLK_6);
    designer.key(SDLK_6); // joins both
    ASSERT_EQ(designer.count("joints"), 1U);
    EXPECT_EQ(designer.parts().selection.kind(), EntryKind::joint);
    Vec2 const pin = pointIn(designer.tree()["joints"][0]["at"]);
    designer.key(SDLK_LEFT);
    EXPECT_NEAR(pointIn(designer.tree()["joints"][0]["at"]).x, pin.x - 0.05, 1e-9);
    designer.key(SDLK_8);
    designer.key(SDLK_8); // an area in the middle
    ASSERT_EQ(designer.count("placing"), 1U);
    double const left = designer.tree()["placing"][0][0].get<double>();
    designer.key(SDLK_RIGHT);
    EXPECT_NEAR(designer.tree()["placing"][0][0].get<double>(), left + 0.05, 1e-9);
    designer.key(SDLK_TAB);              // the floor
    designer.key(SDLK_TAB, KMOD_LSHIFT); // the area
    EXPECT_EQ(designer.parts().selection.kind(), EntryKind::placing);
    designer.key(SDLK_TAB, KMOD_LSHIFT);
    EXPECT_EQ(designer.parts().selection.kind(), EntryKind::joint);
    designer.key(SDLK_DELETE);
    EXPECT_EQ(designer.count("joints"), 0U);
    designer.look("edit-keyboard");
}

TEST(EditorKeyboard, WiresBetweenSelectedObjects) {
    Designer designer;
    designer.editCopyOf(firstContact);
    std::size_t const connections = designer.count("connections");
    designer.parts().selection.clear();
    auto const& objects = designer.tree()["objects"];
    auto const selectByTab = [&](std::string const& name) {
        for (std::size_t i = 0; i < objects.size() && designer.parts().selected() != std::vector{name}; ++i) {
            designer.key(SDLK_TAB);
        }
    };
    selectByTab("left contact");
    ASSERT_EQ(designer.parts().selected(), std::vector<std::string>{"left contact"});
    for (int i = 0; i < 30 && !designer.parts().selection.has("right contact"); ++i) {
        designer.key(SDLK_TAB, KMOD_LCTRL);
    }
    designer.parts().selection.set({"left contact", "right contact"});
    designer.key(SDLK_7);
    designer.key(SDLK_7);
    EXPECT_EQ(designer.count("connections"), connections + 1);
}

TEST(EditorKeyboard, TheCatalogueAndTheDialogs) {
    Designer designer;
    designer.editNew();
    std::size_t const before = designer.count("objects");
    designer.key(SDLK_F2);
    designer.key(SDLK_F9);
    designer.frames(2);
    for (int i = 0; i < 3; ++i) {
        designer.key(SDLK_DOWN);
        designer.frames(2);
    }
    designer.key(SDLK_RETURN);
    designer.frames(2);
    EXPECT_EQ(designer.count("objects"), before + 1) << "a part of the catalogue";
    designer.look("edit-keyboard-catalogue");
    designer.key(SDLK_ESCAPE);
    EXPECT_FALSE(designer.parts().panelKeys);
    designer.ctrl(SDLK_o);
    designer.frames(2);
    ASSERT_TRUE(designer.showsCard("unsaved"));
    designer.key(SDLK_DOWN);
    designer.frames(1);
    designer.key(SDLK_DOWN);
    designer.frames(1);
    designer.key(SDLK_DOWN);
    designer.frames(1);
    designer.key(SDLK_RETURN); // the last button cancels
    designer.frames(2);
    EXPECT_FALSE(designer.showsCard("unsaved"));
    EXPECT_EQ(designer.count("objects"), before + 1);
}

TEST(EditorGamepad, SelectsMovesAndReachesEveryCommandThroughTheirList) {
    using render::padKey;
    Designer designer;
    designer.editNew();
    designer.key(padKey(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER));
    ASSERT_EQ(designer.parts().selected(), std::vector<std::string>{"floor"});
    double const x = designer.placeOf("floor").x;
    designer.key(padKey(SDL_CONTROLLER_BUTTON_DPAD_RIGHT));
    EXPECT_NEAR(designer.placeOf("floor").x, x + 0.05, 1e-9);
    designer.key(padKey(SDL_CONTROLLER_BUTTON_BACK));
    EXPECT_NEAR(designer.placeOf("floor").x, x, 1e-9);
    designer.key(padKey(SDL_CONTROLLER_BUTTON_A));
    designer.frames(2);
    ASSERT_TRUE(designer.showsCard("command palette"));
    for (int i = 0; i < 4; ++i) { // new, open, save, save as, test
        designer.key(padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN));
    }
    designer.key(padKey(SDL_CONTROLLER_BUTTON_A));
    designer.frames(2);
    EXPECT_NE(designer.screen().test(), nullptr);
    designer.key(padKey(SDL_CONTROLLER_BUTTON_B));
    designer.frames(2);
    EXPECT_EQ(designer.screen().test(), nullptr);
}

TEST(EditorGamepad, WorksInThePanel) {
    using render::padKey;
    Designer designer;
    designer.editNew();
    std::size_t const before = designer.count("objects");
    auto const press = [&](SDL_GameControllerButton button) {
        designer.key(padKey(button));
        designer.frames(2);
    };
    press(SDL_CONTROLLER_BUTTON_LEFTSTICK);
    ASSERT_TRUE(designer.parts().panelKeys);
    ASSERT_EQ(designer.parts().tab, Tab::parts);
    for (int i = 0; i < 3; ++i) {
        press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    }
    press(SDL_CONTROLLER_BUTTON_A);
    EXPECT_EQ(designer.count("objects"), before + 1) << "a part of the catalogue";
    EXPECT_FALSE(designer.showsCard("command palette")) << "the button acts in the panel";
    press(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
    EXPECT_EQ(designer.parts().tab, Tab::outline);
    press(SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
    press(SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
    EXPECT_EQ(designer.parts().tab, Tab::problems) << "the last page is before the first";
    EXPECT_TRUE(designer.parts().panelKeys);
    press(SDL_CONTROLLER_BUTTON_B);
    EXPECT_FALSE(designer.parts().panelKeys);
    EXPECT_FALSE(designer.app().menu().isOpen());
}

TEST(EditorOwnParts, AreThereAtOnceInTheCatalogueAndTheGame) {
    auto const folder = testFolder() / "data";
    std::filesystem::remove_all(folder);
    char const* const stated = std::getenv("XDG_DATA_HOME");
    std::string const before = stated == nullptr ? "" : stated;
    ::setenv("XDG_DATA_HOME", folder.c_str(), 1);
    {
        Designer designer;
        designer.editCopyOf(firstContact);
        designer.parts().selection.set({"left post", "right post"});
        designer.key(SDLK_k);
        designer.frames(3);
        ASSERT_TRUE(designer.showsCard("part name"));
        designer.ctrl(SDLK_a);
        designer.typeText("twin posts");
        designer.frames(1);
        designer.clickItem("make part here");
        designer.frames(12);
        EXPECT_NE(designer.parts().data->parts.find("twin posts"), nullptr);
        EXPECT_EQ((*edit::findObject(designer.tree(), "left post"))["part"], "twin posts");
        EXPECT_EQ(designer.parts().world.objectsOf("left post").size(), 2U);
        designer.parts().selection.set({"left post"});
        designer.key(SDLK_F2);
        designer.frames(2);
        designer.look("edit-own-part"); // the outline is around both pieces
        designer.clickItem("search parts");
        designer.typeText("twin");
        designer.frames(2);
        EXPECT_TRUE(designer.shows("part twin posts"));
        // Also in a new editor and in free play.
        designer.parts().document.goTo(0);
        designer.app().edit({});
        designer.frames(3);
        EXPECT_NE(designer.parts().data->parts.find("twin posts"), nullptr);
        designer.app().showTitle();
        designer.frames(2);
        designer.clickItem("free play");
        designer.frames(4);
        auto* const play = dynamic_cast<PlayScreen*>(&designer.app().screen());
        ASSERT_NE(play, nullptr);
        auto const& toolbox = play->session().level().toolbox;
        EXPECT_TRUE(std::any_of(toolbox.begin(), toolbox.end(),
                                [](ToolboxEntry const& entry) { return entry.part == "twin posts"; }));
    }
    if (stated == nullptr) {
        ::unsetenv("XDG_DATA_HOME");
    } else {
        ::setenv("XDG_DATA_HOME", before.c_str(), 1);
    }
}

TEST(EditorTexts, AreWrappedInTheirFields) {
    Designer designer;
    designer.editCopyOf(firstContact);
    designer.key(SDLK_F6);
    designer.frames(2);
    designer.clickItem("level text");
    designer.frames(1);
    designer.ctrl(SDLK_a);
    std::string const words =
        "The bar lies beside the posts and nothing else conducts, so whoever wants light lays it on top.";
    designer.typeText(words);
    designer.frames(2);
    designer.look("edit-wrapped");
    designer.clickItem("level title"); // leaves the field
    designer.frames(2);
    EXPECT_EQ(designer.tree()["text"], words) << "without the breaks of the field";
}

} // namespace
} // namespace keyboard_test
} // namespace trembler::ui::test
