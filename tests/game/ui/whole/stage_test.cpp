// The scene stands where it stands: the view is fitted once, into a stage that the cards leave free, and only
// the player moves it.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/play/view/level_extents.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/scene/facts/pick.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"
#include "tests/game/ui/stage_sessions.hpp"
#include "tests/game/ui/tidy.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui::test {
namespace stage_test {
namespace {

constexpr std::array stageSizes{render::Size{800, 600}, render::Size{1280, 720}, render::Size{1280, 800},
                                render::Size{1920, 1080}, render::Size{3840, 2160}};
constexpr double leastShare = 0.7; ///< of the window's width
auto const firstContact = levelsFolder() / "first/1-first-contact.json";
auto const ferry = levelsFolder() / "4-water/3-ferry.json";

std::vector<std::filesystem::path> allLevels() {
    std::vector<std::filesystem::path> all;
    for (auto const& file : std::filesystem::recursive_directory_iterator(levelsFolder())) {
        std::string const name = file.path().filename().string();
        if (file.path().extension() == ".json" && name.front() >= '0' && name.front() <= '9') {
            all.push_back(file.path());
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::string sized(render::Size size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// In place of a level's file.
std::filesystem::path const freePlay = "free play";

void enter(Player& player, std::filesystem::path const& level) {
    if (level == freePlay) {
        player.app().showTitle();
        player.frames(3);
        player.clickItem("free play");
        player.frames(4);
    } else {
        player.open(level);
    }
}

struct View {
    Point centre;
    double scale = 0;
    bool operator==(View const&) const = default;
};
View viewOf(Player& player) {
    return {player.play().camera().centre, player.play().camera().pixelsPerMetre};
}
std::ostream& operator<<(std::ostream& out, View const& view) {
    return out << view.scale << " pixels per metre around " << view.centre.x << ", " << view.centre.y;
}

void expectStage(Player& player, std::string const& where) {
    render::Size const size = window().size();
    Rect const stage = player.play().stage();
    double const wide = leastShare * size.width;
    EXPECT_GE(stage.high.x - stage.low.x, wide) << where;
    EXPECT_GE(widestFree(player.layout(), size, 0.4 * size.height).high.x -
                  widestFree(player.layout(), size, 0.4 * size.height).low.x,
              wide)
        << where;
    for (Placed const& card : player.layout().cards()) {
        EXPECT_FALSE(card.rect.overlaps(stage)) << where << ": " << card.name << " lies on the stage";
    }
}

/// What of the scene lies under a card.
std::string coveredBy(Player& player, char const* name) {
    auto const card = player.layout().card(name);
    if (!card) {
        return "";
    }
    World const& world = player.session().world();
    render::Extent const focus = focusOf(player.session());
    std::string covered;
    for (render::Facts const& facts : render::FactsReader(world).drawOrder()) {
        render::Extent own = render::extentOf(facts, render::poseOf(facts));
        if (own.empty() || !own.overlaps(focus)) {
            continue;
        }
        own.lower = {std::max(own.lower.x, focus.lower.x), std::max(own.lower.y, focus.lower.y)};
        own.upper = {std::min(own.upper.x, focus.upper.x), std::min(own.upper.y, focus.upper.y)};
        if (card->overlaps(onScreen(player.play().camera(), own))) {
            covered += world.store().nameOf(facts.id) + ", ";
        }
    }
    return covered;
}

TEST(Stage, IsSevenTenthsOfTheWindowsWidthAndNoCardCoversTheLevel) {
    for (render::Size const size : stageSizes) {
        for (char const* const language : {"en", "de"}) {
            for (float const letters : {1.F, 1.6F}) {
                Player player(size);
                changeSettings(player.app().context(),
                               {.uiScale = letters, .reducedMotion = true, .language = language});
                for (auto const& level :
                     {firstContact, ferry, levelsFolder() / "experiments/3-electric-motor.json", freePlay}) {
                    enter(player, level);
                    player.frames(4);
                    std::string const where = level.filename().string() + " at " + sized(size) + " in " +
                                              language + ", letters " + std::to_string(letters);
                    ASSERT_FALSE(player.play().settles()) << where;
                    expectStage(player, where);
                    for (char const* const card : {"goal", "toolbox", "transport", "tools", "corner"}) {
                        EXPECT_EQ(coveredBy(player, card), "") << "under " << card << ", " << where;
                    }
                }
            }
        }
    }
    window().setUiScaleRequest(1.F);
    useLanguage("en");
}

// At 1280x800 the floor of this level was 736 pixels wide, beside a column of goals.
TEST(Stage, IsFilledByTheScene) {
    Player player({1280, 800});
    player.open(firstContact);
    player.frames(4);
    Rect const scene = onScreen(player.play().camera(), focusOf(player.session()));
    EXPECT_GE(scene.high.x - scene.low.x, 0.7 * 1280);
}

TEST(Stage, HoldsStillFromPlacingToStop) {
    for (auto const& level : {firstContact, ferry}) {
        Player player({1280, 800});
        player.open(level);
        player.frames(4);
        View const before = viewOf(player);
        auto const expectStill = [&](char const* after) {
            player.frames(4);
            EXPECT_EQ(viewOf(player), before) << "after " << after << " in " << level;
        };
        Area const place = player.session().level().placing->front();
        Vec2 const at = place.box->corner + 0.5 * place.box->size;
        for (std::size_t i = 0; i < player.session().toolbox().size(); ++i) {
            player.drag(player.item("part " + player.session().toolbox()[i].part),
                        player.at(at + Vec2{0.6 * static_cast<double>(i), 0.3}));
            expectStill("placing");
            if (player.play().placing().carried()) {
                player.key(SDLK_ESCAPE);
            }
        }
        ASSERT_FALSE(player.session().placed().empty());
        for (int hint = 0; hint < 4; ++hint) {
            player.key(SDLK_h);
            expectStill("a hint");
        }
        for (SDL_Keycode const key : {SDLK_1, SDLK_2, SDLK_3, SDLK_c, SDLK_c, SDLK_SPACE}) {
            player.key(key);
            expectStill("a key");
        }
        player.simulate(40);
        expectStill("a run");
        for (SDL_Keycode const key : {SDLK_p, SDLK_k, SDLK_PAGEUP, SDLK_z, SDLK_c, SDLK_c, SDLK_SPACE}) {
            player.key(key);
            expectStill("a key in the run");
        }
        ASSERT_EQ(player.session().mode(), SessionMode::building);
        player.key(SDLK_BACKSPACE);
        player.key(SDLK_BACKSPACE);
        expectStill("putting all back");
        player.play().commands().run("restart");
        expectStill("starting again");
    }
}

TEST(Stage, IsFittedByAButtonWithItsKeyAlsoWhilePaused) {
    Player player;
    player.open(firstContact);
    player.frames(4);
    View const whole = viewOf(player);
    auto const lookAway = [&] {
        player.key(SDLK_EQUALS, KMOD_LCTRL);
        player.key(SDLK_RIGHT, KMOD_LCTRL);
        player.frames(2);
        ASSERT_NE(viewOf(player), whole);
    };
    lookAway();
    player.clickItem("fit");
    player.frames(2);
    EXPECT_EQ(viewOf(player), whole);
    player.key(SDLK_SPACE);
    player.simulate(40);
    player.key(SDLK_p);
    lookAway();
    player.key(SDLK_HOME);
    player.frames(2);
    EXPECT_EQ(viewOf(player), whole);
    player.key(SDLK_k);
    player.frames(4);
    player.key(SDLK_HOME);
    player.frames(2);
    EXPECT_FALSE(player.play().timeline().looksBack()) << "it only fits the view";
    EXPECT_EQ(coveredBy(player, "timeline"), "") << "beside what is open";
    CommandSet& commands = player.play().commands();
    CommandInfo const& info = commands.info(commands.indexOf("fit"));
    EXPECT_FALSE(std::string_view(info.tip).empty());
    EXPECT_FALSE(player.app().context().keys.keysOf("fit").empty());
}

TEST(Stage, EndsPanningWhereTheSceneEnds) {
    Player player;
    player.open(firstContact);
    player.frames(4);
    Point const paper = player.at({-0.6, 2.6});
    ASSERT_EQ(player.layout().cardAt(paper), "");
    for (MouseButton const button : {MouseButton::Left, MouseButton::Right, MouseButton::Middle}) {
        for (Point const way : {Point{1, 0}, Point{-1, 0}, Point{0, 1}, Point{0, -1}, Point{1, 1}}) {
            View const before = viewOf(player);
            Rect const stage = player.play().stage();
            player.drag(paper, paper + 6000.0 * way, button);
            Rect const scene = onScreen(player.play().camera(), focusOf(player.session()));
            EXPECT_NE(viewOf(player), before);
            EXPECT_TRUE(scene.overlaps(stage)) << "a quarter of the stage still shows it";
            Rect const middle{stage.middle() - Point{60, 60}, stage.middle() + Point{60, 60}};
            EXPECT_TRUE(scene.overlaps(middle));
            player.key(SDLK_HOME);
            player.frames(2);
        }
    }
    player.moveTo(paper);
    player.wheel(-30);
    player.drag(paper, paper + Point{6000, 6000});
    EXPECT_TRUE(onScreen(player.play().camera(), focusOf(player.session())).overlaps(player.play().stage()));
}

TEST(Stage, IsFittedAgainWhenTheWindowHasAnotherSizeAlsoWhilePausedOrBehindTheMenu) {
    for (bool const menu : {false, true}) {
        for (bool const moved : {false, true}) {
            Player player;
            player.open(firstContact);
            player.frames(4);
            View const whole = viewOf(player);
            player.key(SDLK_SPACE);
            player.simulate(30);
            player.key(SDLK_p);
            if (moved) {
                player.key(SDLK_EQUALS, KMOD_LCTRL);
            }
            if (menu) {
                player.key(SDLK_ESCAPE);
                ASSERT_TRUE(player.app().menu().isOpen());
            }
            for (render::Size const size : stageSizes) {
                resizeWindow(player, size);
                std::string const where =
                    sized(size) + (menu ? " behind the menu" : " while paused") + (moved ? ", moved" : "");
                Rect const scene = onScreen(player.play().camera(), focusOf(player.session()));
                Rect const stage = player.play().stage();
                EXPECT_TRUE(scene.overlaps({stage.middle() - Point{1, 1}, stage.middle() + Point{1, 1}}))
                    << where;
                EXPECT_GE(scene.high.x - scene.low.x, 0.3 * size.width) << where;
                if (!moved) {
                    EXPECT_TRUE(scene.low.x >= 0 && scene.low.y >= 0 && scene.high.x <= size.width &&
                                scene.high.y <= size.height)
                        << where;
                }
            }
            resizeWindow(player, {1280, 720});
            if (menu) {
                player.key(SDLK_ESCAPE);
            }
            player.frames(FittedView::settling + 2);
            if (!moved) {
                player.key(SDLK_SPACE);
                player.frames(2);
                player.key(SDLK_HOME);
                player.frames(2);
                // The goals have buttons now that ask why, and may be higher.
                EXPECT_NEAR(viewOf(player).scale, whole.scale, 0.12 * whole.scale)
                    << "as at this size before";
                EXPECT_EQ(coveredBy(player, "goal"), "");
            }
        }
    }
}

TEST(Stage, ShowsHintsOneAtATimeFoldsThemAndPutsThemAwayInARun) {
    Player player;
    player.open(firstContact);
    player.frames(4);
    player.key(SDLK_h);
    player.frames(4);
    ASSERT_TRUE(player.showsCard("hints"));
    expectTidy(player, "a hint");
    Rect const first = *player.layout().card("hints");
    player.clickItem("hint");
    player.clickItem("hint");
    player.frames(4);
    EXPECT_EQ(player.play().hintsShown(), 3U);
    Rect const third = *player.layout().card("hints");
    EXPECT_LE(third.high.y - first.low.y, 0.4 * 720) << "hints do not pile up";
    player.clickItem("hint before");
    player.clickItem("hint before");
    player.clickItem("fold hints");
    player.frames(2);
    EXPECT_FALSE(player.showsCard("hints"));
    player.clickItem("hint");
    player.frames(2);
    EXPECT_TRUE(player.showsCard("hints"));
    EXPECT_EQ(player.play().hintsShown(), 3U);
    player.moveTo(player.item("part steel bar"));
    player.press();
    player.moveTo(player.at({-1.8, 1.3}));
    player.frames(2);
    EXPECT_FALSE(player.showsCard("hints")) << "nothing lies over the scene while a part is held";
    player.release();
    player.frames(2);
    EXPECT_TRUE(player.showsCard("hints"));
    player.key(SDLK_SPACE);
    player.frames(2);
    EXPECT_FALSE(player.showsCard("hints"));
    player.key(SDLK_SPACE);
    player.frames(2);
    EXPECT_FALSE(player.showsCard("hints")) << "they stay folded";
}

TEST(Stage, KeepsTheToolboxFreeOfAnswersAndOfTheInspector) {
    for (render::Size const size : stageSizes) {
        Player player(size);
        player.open(firstContact);
        player.frames(4);
        player.key(SDLK_SPACE);
        player.simulate(40);
        player.key(SDLK_y, KMOD_LSHIFT);
        player.play().why().wait();
        player.frames(4);
        ASSERT_TRUE(player.showsCard("why")) << sized(size);
        player.key(SDLK_SPACE);
        player.frames(4);
        EXPECT_TRUE(player.showsCard("toolbox")) << sized(size);
        EXPECT_TRUE(player.showsCard("why")) << "it helps to build better: " << sized(size);
        expectTidy(player, "an answer while building at " + sized(size));
        player.drag(player.item("part steel bar"), player.at({-1.8, 1.3}));
        ASSERT_EQ(player.session().placed().size(), 1U) << sized(size);
        player.frames(2);
        player.key(SDLK_i);
        player.frames(4);
        EXPECT_TRUE(player.showsCard("inspector")) << sized(size);
        EXPECT_TRUE(player.showsCard("toolbox")) << sized(size);
        expectTidy(player, "the inspector while building at " + sized(size));
    }
}

// It jumped to the other side as soon as its object came under it, and back.
TEST(Stage, TheInspectorStaysOnItsSideWhileTheViewIsMoved) {
    for (char const* const name : {"iron ball", "battery plus"}) { // beside the toolbox, and far from it
        Player player;
        player.open(firstContact);
        World const& world = player.session().world();
        player.click(player.at(world.find<Position>(world.store().find(name))->value));
        player.frames(4);
        ASSERT_TRUE(player.showsCard("inspector")) << name;
        double const before = player.layout().card("inspector")->low.x;
        for (SDL_Keycode const way : {SDLK_RIGHT, SDLK_LEFT}) {
            for (int i = 0; i < 12; ++i) {
                player.key(way, KMOD_LCTRL);
                ASSERT_EQ(player.layout().card("inspector")->low.x, before) << name;
            }
        }
    }
}

TEST(Stage, EscapeDeselectsBeforeItOpensTheMenu) {
    Player player;
    player.open(firstContact);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.5}));
    ASSERT_TRUE(player.play().placing().selected());
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.play().placing().selected());
    EXPECT_FALSE(player.app().menu().isOpen());
    EXPECT_EQ(player.session().placed().size(), 1U);
    player.key(SDLK_ESCAPE);
    EXPECT_TRUE(player.app().menu().isOpen());
}

// A part near the upper edge of the stage has its knob under the goals.
TEST(Stage, KeepsTheKnobThatTurnsAPartFreeOfCards) {
    Player player;
    player.open(firstContact);
    player.drag(player.item("part spanner"), player.at({-1.8, 1.5}));
    ASSERT_TRUE(player.play().handle());
    Vec2 const above = *player.play().handle();
    EXPECT_GT(above.y, 1.5);
    for (int i = 0; i < 20 && player.layout().cardAt(player.at(above)).empty(); ++i) {
        player.key(SDLK_DOWN, KMOD_LCTRL);
    }
    player.frames(2);
    ASSERT_TRUE(player.play().handle());
    Vec2 const below = *player.play().handle();
    ASSERT_LT(below.y, 1.5);
    EXPECT_EQ(player.layout().cardAt(player.at(below)), "");
    player.drag(player.at(below), player.at(Vec2{-1.8, 1.5} + Vec2{1, 0}));
    EXPECT_NEAR(player.session().placed().front().placement.angle, pi / 2, 1e-9);
}

/// How many of the pixels on a line of the world are not as they are without the areas for placing.
int inkAlong(Player& player, render::Image const& with, render::Image const& without, Vec2 from, Vec2 to) {
    int ink = 0;
    for (int i = 0; i <= 200; ++i) {
        Point const at = player.at(from + (i / 200.0) * (to - from));
        int const x = static_cast<int>(at.x);
        int const y = static_cast<int>(at.y);
        for (int beside = -1; beside <= 1; ++beside) {
            if (with.at(x, y + beside) != without.at(x, y + beside)) {
                ++ink;
                break;
            }
        }
    }
    return ink;
}

TEST(Stage, ShowsWherePartsMayStandFaintlyBeforeOneIsHeld) {
    Player player;
    changeSettings(player.app().context(), {.reducedMotion = true});
    player.open(ferry);
    player.moveTo({640, 718});
    player.frames(8);
    render::Image const building = player.look("stage-places");
    player.moveTo(player.item("part " + player.session().toolbox().front().part));
    player.press();
    player.moveTo(player.item("fit")); // beside the scene
    player.frames(4);
    render::Image const held = player.look("stage-places-held");
    player.key(SDLK_ESCAPE);
    player.release();
    player.moveTo({640, 718});
    player.key(SDLK_f);
    player.frames(8);
    render::Image const running = player.look("stage-places-running");
    Box const box = *player.session().level().placing->front().box;
    Vec2 const from = box.corner + Vec2{0.05, box.size.y};
    Vec2 const to = box.corner + Vec2{box.size.x - 0.05, box.size.y};
    int const faint = inkAlong(player, building, running, from, to);
    EXPECT_GT(faint, 40) << "of 201 places on the upper edge";
    int strong = 0;
    int weak = 0;
    for (int i = 0; i <= 200; ++i) {
        Point const at = player.at(from + (i / 200.0) * (to - from));
        auto const far = [&](render::Image const& image) {
            auto const a = image.at(static_cast<int>(at.x), static_cast<int>(at.y));
            auto const b = running.at(static_cast<int>(at.x), static_cast<int>(at.y));
            return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
        };
        strong += far(held);
        weak += far(building);
    }
    EXPECT_GT(strong, 2 * weak) << "more clearly while a part is held";
}

TEST(Stage, IsTheSameInTheTestOfTheEditor) {
    for (render::Size const size : stageSizes) {
        Designer designer(size);
        designer.editCopyOf(firstContact);
        designer.key(SDLK_SPACE);
        designer.frames(8);
        auto& screen = dynamic_cast<EditScreen&>(designer.app().screen());
        ASSERT_NE(screen.test(), nullptr);
        Rect const stage = screen.test()->stage();
        EXPECT_GE(stage.high.x - stage.low.x, leastShare * size.width) << sized(size);
        expectTidy(designer, "the test at " + sized(size));
        auto const view = screen.test()->camera();
        designer.key(SDLK_SPACE);
        designer.frames(40);
        expectTidy(designer, "the test runs at " + sized(size));
        designer.key(SDLK_SPACE);
        designer.frames(4);
        EXPECT_EQ(screen.test()->camera().centre, view.centre);
        EXPECT_EQ(screen.test()->camera().pixelsPerMetre, view.pixelsPerMetre);
    }
}

std::optional<std::size_t> numberIn(char const* variable) {
    char const* const stated = std::getenv(variable);
    if (stated == nullptr) {
        return {};
    }
    std::size_t number = 0;
    std::string_view const digits(stated);
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

int failuresSoFar() {
    return testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
}

/// Fails if something but the player moves the scene.
void playRandomly(Player& player, std::vector<std::filesystem::path> const& levels, render::Size size,
                  std::size_t number) {
    std::mt19937_64 choice(number);
    bool const free = number % 7 == 3; // at each of the sizes in turn
    auto const& level = free ? freePlay : levels[choice() % levels.size()];
    std::string const where = level.string() + " at " + sized(size) + ", session " + std::to_string(number);
    resizeWindow(player, size);
    enter(player, level);
    player.frames(4);
    ASSERT_FALSE(player.play().settles()) << where;
    int const before = failuresSoFar();
    expectStage(player, where);
    StageSession session(player, number);
    for (int acts = 0; acts < 30 && session.goesOn() && failuresSoFar() == before; ++acts) {
        session.act();
    }
    ASSERT_EQ(failuresSoFar(), before) << where << session.story();
}

// A few sessions, or as many as TREMBLER_SESSIONS in the environment says, or only that of the number
// TREMBLER_SESSION.
TEST(Stage, IsMovedOnlyByThePlayerInRandomSessions) {
    std::vector<std::filesystem::path> const levels = allLevels();
    auto const only = numberIn("TREMBLER_SESSION");
    std::size_t const count = only ? *only + 1 : numberIn("TREMBLER_SESSIONS").value_or(20);
    for (std::size_t s = 0; s < stageSizes.size(); ++s) {
        if (only && s != *only % stageSizes.size()) {
            continue;
        }
        Player player(stageSizes[s]); // all sessions of a size together: letters are loaded once
        changeSettings(player.app().context(), {.reducedMotion = true, .language = "en"});
        for (std::size_t i = only.value_or(s); i < count; i += stageSizes.size()) {
            playRandomly(player, levels, stageSizes[s], i);
        }
    }
}

} // namespace
} // namespace stage_test
} // namespace trembler::ui::test
