// The window changes its size while a level, menu or editor is in use: nothing is lost or left outside.
#include "tests/game/ui/edit/editor_kit.hpp"
#include "tests/game/ui/tidy.hpp"

#include <array>
#include <string>
#include <vector>

namespace trembler::ui::test {
namespace {

constexpr std::array windowSizes{render::Size{800, 600}, render::Size{3840, 2160}, render::Size{1024, 768},
                                 render::Size{1280, 720}};
auto const resizedLevel = levelsFolder() / "first/1-first-contact.json";

/// As the desktop does it: the size, and the event that reports it.
void resizeTo(Player& player, render::Size size) {
    window().resize(size);
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.event = SDL_WINDOWEVENT_SIZE_CHANGED;
    event.window.windowID = SDL_GetWindowID(window().handle());
    event.window.data1 = size.width;
    event.window.data2 = size.height;
    SDL_PushEvent(&event);
    player.frames(6); // the view follows, cards know their size
}

std::string whileSized(char const* what, render::Size size) {
    return std::string(what) + " at " + std::to_string(size.width) + "x" + std::to_string(size.height);
}

TEST(Resizing, ADraggedPartStaysInTheHandAndLandsUnderThePointer) {
    for (render::Size const size : windowSizes) {
        Player player;
        player.open(resizedLevel);
        player.moveTo(player.item("part steel bar"));
        player.press();
        player.moveTo(player.at({-1.8, 1.5}));
        resizeTo(player, size);
        ASSERT_TRUE(player.play().placing().carried()) << whileSized("drag", size);
        expectTidy(player, whileSized("drag", size));
        player.moveTo(player.at({-1.8, 1.5}));
        player.release();
        player.frames(2);
        ASSERT_EQ(player.session().placed().size(), 1U) << whileSized("drag", size);
        EXPECT_NEAR(player.session().placed().front().placement.at.x, -1.8, 0.06) << whileSized("drag", size);
        EXPECT_NEAR(player.session().placed().front().placement.at.y, 1.5, 0.06) << whileSized("drag", size);
    }
}

TEST(Resizing, ARunGoesOnAndIsSolved) {
    Player player;
    player.open(resizedLevel);
    ASSERT_TRUE(player.session().place({"steel bar", {-1.8, 1.3}, 0, ""}));
    player.key(SDLK_SPACE);
    for (render::Size const size : windowSizes) {
        auto const frame = player.session().world().frame();
        resizeTo(player, size);
        EXPECT_GT(player.session().world().frame(), frame) << whileSized("run", size);
        expectTidy(player, whileSized("run", size));
    }
    player.simulate(400);
    EXPECT_TRUE(player.session().solved());
    for (render::Size const size : windowSizes) {
        resizeTo(player, size);
        EXPECT_TRUE(player.showsCard("success")) << whileSized("success", size);
        expectTidy(player, whileSized("success", size));
    }
}

TEST(Resizing, TheMenuKeepsItsPageAndItsButtonsWork) {
    Player player;
    player.open(resizedLevel);
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.clickItem("menu.settings");
    for (render::Size const size : windowSizes) {
        resizeTo(player, size);
        EXPECT_EQ(player.app().menu().page(), MenuPage::settings) << whileSized("settings", size);
        expectTidy(player, whileSized("settings", size));
    }
    player.clickItem("Back");
    player.frames(2);
    EXPECT_EQ(player.app().menu().page(), MenuPage::main);
}

TEST(Resizing, TheEditorKeepsItsDialogItsSelectionAndADrag) {
    Designer designer;
    designer.editCopyOf(resizedLevel);
    designer.select({1.7, 0.15});
    ASSERT_EQ(designer.parts().selected(), std::vector<std::string>{"iron ball"});
    Vec2 const before = designer.placeOf("iron ball");
    designer.moveTo(designer.on(before));
    designer.press();
    designer.moveTo(designer.on(before + Vec2{0.1, 0.1}));
    resizeTo(designer, {800, 600});
    designer.moveTo(designer.on(before + Vec2{0.5, 0.5}));
    designer.release();
    designer.frames(2);
    Vec2 const after = designer.placeOf("iron ball");
    EXPECT_NEAR(after.x, before.x + 0.5, 0.11);
    EXPECT_NEAR(after.y, before.y + 0.5, 0.11);
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{"iron ball"});
    designer.ctrl(SDLK_p);
    designer.typeText("grid");
    for (render::Size const size : windowSizes) {
        resizeTo(designer, size);
        EXPECT_TRUE(designer.parts().palette.isOpen()) << whileSized("commands", size);
        expectTidy(designer, whileSized("commands", size));
    }
    designer.key(SDLK_ESCAPE);
    designer.frames(2);
    EXPECT_FALSE(designer.parts().palette.isOpen());
}

} // namespace
} // namespace trembler::ui::test
