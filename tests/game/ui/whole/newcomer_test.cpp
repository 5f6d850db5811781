// What confused players in their first hour, each by real events and by what is then on the screen.
#include "game/ui/shared/kept/profile.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace newcomer_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";

// "Step" was clicked twice, and the second click recorded a clip: the buttons had moved.
TEST(Newcomer, FindsEveryButtonInItsPlaceWhileBuildingAndInARun) {
    Player player;
    player.open(firstContact);
    player.frames(4);
    auto const places = [&] {
        std::vector<Point> all;
        for (char const* const name : {"undo", "redo", "step", "pause", "slower", "faster", "electricity",
                                       "components", "fit", "save", "picture", "record", "help", "menu"}) {
            all.push_back(player.item(name));
        }
        return all;
    };
    auto const before = places();
    Point const run = player.item("run");
    Point const step = player.item("step");
    player.click(step);
    player.frames(3);
    EXPECT_EQ(places(), before);
    EXPECT_EQ(player.item("stop"), run);
    player.click(step);
    player.frames(3);
    EXPECT_EQ(player.session().world().frame(), 2U) << "two clicks are two frames";
    EXPECT_EQ(places(), before);
    player.key(SDLK_SPACE);
    player.frames(3);
    EXPECT_EQ(places(), before);
}

// Another size of the letters switched the shadows on, and solving a level kept them as on.
TEST(Newcomer, KeepsTheShadowsAsTheyWereWhateverElseChanges) {
    auto const file = testFolder() / "profile.json";
    std::filesystem::remove(file);
    {
        Profile profile(file);
        Settings settings = profile.settings();
        settings.shadows = false;
        settings.shadowsChosen = true;
        profile.setSettings(settings);
    }
    {
        Player player({1280, 720}, file);
        player.clickItem("settings");
        player.frames(3);
        player.clickItem("115%");
        player.frames(3);
        EXPECT_FALSE(player.app().context().shadows);
        player.open(firstContact);
        player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
        player.key(SDLK_SPACE);
        player.simulate(400);
        ASSERT_TRUE(player.session().solved());
    }
    Profile const kept(file);
    EXPECT_TRUE(kept.solved("first/1-first-contact.json"));
    EXPECT_NEAR(static_cast<double>(kept.settings().uiScale), 1.15, 1e-6);
    EXPECT_FALSE(kept.settings().shadows);
}

// At a low frame rate the whole of Ctrl+Z lies between two pictures.
TEST(Newcomer, UndoesByCtrlZBetweenTwoPictures) {
    Player player;
    player.open(firstContact);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    ASSERT_EQ(player.session().placed().size(), 1U);
    render::pushKey(window(), SDLK_LCTRL, true, KMOD_LCTRL);
    render::pushKey(window(), SDLK_z, true, KMOD_LCTRL);
    render::pushKey(window(), SDLK_z, false, KMOD_LCTRL);
    render::pushKey(window(), SDLK_LCTRL, false);
    player.frames(2);
    EXPECT_TRUE(player.session().placed().empty());
}

// A part that is let go where it may not lie stays in the hand with the reason; Esc puts it back, and
// Backspace works then.
TEST(Newcomer, KeepsAPartInHandThatIsLetGoWhereItMayNotLie) {
    Player player;
    player.open(firstContact);
    render::Toasts const& toasts = player.app().context().toasts;
    auto const troubles = toasts.troubles();
    player.drag(player.item("part wooden bar"), player.at({1.7, 0.2}));
    player.frames(3);
    EXPECT_TRUE(player.play().placing().carried());
    EXPECT_TRUE(player.session().placed().empty());
    EXPECT_EQ(toasts.troubles(), troubles + 1) << "which is what the sound of a refusal follows";
    player.look("let-go");
    std::vector<std::string> const lines = DrawnWords().lines();
    EXPECT_EQ(std::count_if(
                  lines.begin(), lines.end(),
                  [](std::string const& line) { return line.find("would overlap") != std::string::npos; }),
              1)
        << "beside the part, and in no message elsewhere";
    player.click(player.at({1.7, 0.2}));
    EXPECT_EQ(toasts.troubles(), troubles + 2) << "a click is refused in the same way";
    EXPECT_EQ(toasts.count(), 0U);
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.play().placing().carried());
    player.drag(player.item("part wooden bar"), player.at({-1.8, 1.6}));
    ASSERT_EQ(player.session().placed().size(), 1U);
    player.key(SDLK_BACKSPACE);
    player.key(SDLK_BACKSPACE);
    EXPECT_TRUE(player.session().placed().empty());
}

// F11 was dead in the menu, F1 on the title.
TEST(Newcomer, UsesTheKeysOfTheProgramOnEveryScreen) {
    Player player;
    auto const fullscreen = [&] { return player.app().context().profile.settings().fullscreen; };
    player.key(SDLK_F1);
    player.frames(2);
    EXPECT_TRUE(player.showsCard("help"));
    player.key(SDLK_ESCAPE);
    player.key(SDLK_F11);
    EXPECT_TRUE(fullscreen());
    player.open(firstContact);
    player.key(SDLK_ESCAPE);
    player.frames(2);
    ASSERT_TRUE(player.showsCard("menu"));
    player.key(SDLK_F11);
    EXPECT_FALSE(fullscreen());
    EXPECT_TRUE(player.app().menu().isOpen()) << "it stays open";
}

// A new part in the hand left the toolbox's number as it was.
TEST(Newcomer, SeesTheSameNumberForANewPartInTheHandAndForOneThatIsMoved) {
    Player player;
    player.open(levelsFolder() / "2-electricity/2-the-easy-way.json"); // has three tiles with one part or two
    auto const numbers = [&] {
        player.look("numbers");
        std::vector<std::string> all;
        for (std::string const& line : DrawnWords().lines()) {
            if (line.size() == 1 && line[0] >= '0' && line[0] <= '9') {
                all.push_back(line);
            }
        }
        return all;
    };
    EXPECT_EQ(numbers(), (std::vector<std::string>{"1", "1", "2", "2"}));
    std::vector<std::string> const held{"0", "1", "2", "2"};
    player.moveTo(player.item("part steel bar"));
    player.press();
    player.moveTo(player.at({0, 3}));
    EXPECT_EQ(numbers(), held);
    player.release();
    ASSERT_EQ(player.session().placed().size(), 1U);
    player.press();
    player.moveTo(player.at({0.5, 3.2}));
    EXPECT_EQ(numbers(), held);
    player.release();
}

// What an object is called was known only to those who clicked on it.
TEST(Newcomer, ReadsTheNameOfTheObjectOnWhichThePointerRests) {
    Player player;
    player.open(levelsFolder() / "first/2-into-the-basket.json"); // without a lesson
    World const& world = player.session().world();
    ObjectId const ball = world.store().find("ball");
    ASSERT_TRUE(ball.valid());
    auto const named = [&] {
        player.look("name-under-pointer");
        std::vector<std::string> const lines = DrawnWords().lines();
        return std::find(lines.begin(), lines.end(), "Ball") != lines.end();
    };
    player.moveTo(player.at(world.find<Position>(ball)->value));
    EXPECT_FALSE(named()) << "the pointer only passes";
    player.frames(40);
    EXPECT_TRUE(named());
    player.frames(200);
    EXPECT_TRUE(player.app().resting()) << "it stays without being drawn again";
    player.moveTo(player.at({0, 3.5}));
    EXPECT_FALSE(named());
}

// Purple, black and blue arrows were not explained.
TEST(Newcomer, ReadsWhatTheArrowsOfTheOverlaysMean) {
    Player player;
    player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
    player.key(SDLK_SPACE);
    player.simulate(60);
    player.frames(4);
    EXPECT_FALSE(player.showsCard("legend"));
    for (SDL_Keycode const key : {SDLK_1, SDLK_2, SDLK_3}) {
        player.key(key);
    }
    player.frames(10);
    ASSERT_TRUE(player.showsCard("legend"));
    player.look("legend");
    std::vector<std::string> const lines = DrawnWords().lines();
    for (char const* const words : {"current flows", "its direction", "force of 1 N", "100 N",
                                    "magnetic field, from north to south", "objects touch"}) {
        EXPECT_EQ(std::count(lines.begin(), lines.end(), words), 1) << words;
    }
    Rect const legend = *player.layout().card("legend");
    for (char const* const other : {"goal", "tools", "transport"}) {
        EXPECT_FALSE(legend.overlaps(*player.layout().card(other))) << other;
    }
    player.key(SDLK_1);
    player.key(SDLK_3);
    player.frames(4);
    player.look("legend-magnetism");
    std::vector<std::string> const fewer = DrawnWords().lines();
    EXPECT_EQ(std::count(fewer.begin(), fewer.end(), "current flows"), 0);
    EXPECT_EQ(std::count(fewer.begin(), fewer.end(), "force of 1 N"), 1);
}

} // namespace
} // namespace newcomer_test
} // namespace trembler::ui::test
