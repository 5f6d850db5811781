// The view is fitted beside the cards around a level, and, if the player asks, beside those that are open.
#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/view/level_extents.hpp"
#include "game/ui/play/whatif/what_if.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "render/scene/areas.hpp"
#include "render/scene/facts/facts.hpp"
#include "render/scene/facts/pick.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/stage_sessions.hpp"

#include <array>
#include <string>

namespace trembler::ui::test {
namespace fitted_view_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";

std::filesystem::path const& anyLevel(std::size_t i) {
    static std::array const levels{
        firstContact,
        levelsFolder() / "experiments/1-switched-electromagnet.json",
        levelsFolder() / "experiments/3-electric-motor.json",
        levelsFolder() / "2-electricity/1-both-gaps.json",
        levelsFolder() / "5-everything/1-the-laboratory-door.json",
        levelsFolder() / "5-everything/2-the-gate.json",
    };
    return levels.at(i);
}
constexpr std::size_t levelCount = 6;

/// The names of the objects whose relevant part lies under this card: of a floor without end, the part near
/// the other objects.
std::string objectsUnder(Player& player, char const* card) {
    auto const rect = player.layout().card(card);
    EXPECT_TRUE(rect) << card << " is not shown";
    World const& world = player.session().world();
    render::Extent const focus = render::sceneFocus(world);
    std::string names;
    for (render::Facts const& facts : render::FactsReader(world).drawOrder()) {
        render::Extent const own = render::extentOf(facts, render::poseOf(facts));
        if (!rect || own.empty() || !own.overlaps(focus)) {
            continue;
        }
        render::Camera const& camera = player.play().camera();
        Point const a =
            camera.toScreen({std::max(own.lower.x, focus.lower.x), std::min(own.upper.y, focus.upper.y)});
        Point const b =
            camera.toScreen({std::min(own.upper.x, focus.upper.x), std::max(own.lower.y, focus.lower.y)});
        if (rect->overlaps({a, b})) {
            names += world.store().nameOf(facts.id) + ", ";
        }
    }
    return names;
}

/// The size of the level on the screen, in pixels.
Point sizeOfLevel(Player& player) {
    render::Extent const focus = render::sceneFocus(player.session().world());
    return 2 * player.play().camera().pixelsPerMetre * focus.half();
}

void expectUncovered(Player& player, char const* card) {
    player.frames(10);
    EXPECT_EQ(objectsUnder(player, card), "") << "under " << card << " in " << player.play().file();
}

void inspectAnything(Player& player) {
    World const& world = player.session().world();
    for (render::Facts const& facts : render::FactsReader(world).drawOrder()) {
        render::Point const middle = render::poseOf(facts).at;
        Vec2 const at{middle.x, middle.y};
        if (player.layout().cardAt(player.at(at)).empty()) {
            player.click(player.at(at));
            player.frames(2);
        }
        if (player.showsCard("inspector")) {
            return;
        }
    }
    FAIL() << "nothing can be inspected";
}

/// Presses the key that fits the view.
void fit(Player& player) {
    player.frames(10); // cards that were opened know their size
    player.key(SDLK_HOME);
    player.frames(2);
}

TEST(FittedView, NothingLiesUnderComponentsOrInspector) {
    for (std::size_t i = 0; i < levelCount; ++i) {
        Player player;
        player.open(anyLevel(i));
        player.frames(10);
        render::Camera const before = player.play().camera();
        player.key(SDLK_c);
        player.frames(10);
        EXPECT_EQ(player.play().camera().centre, before.centre) << "a card that opens moves nothing";
        fit(player);
        expectUncovered(player, "components");
        player.key(SDLK_c);
        fit(player);
        EXPECT_EQ(player.play().camera().pixelsPerMetre, before.pixelsPerMetre) << "it is as it was";
        EXPECT_EQ(player.play().camera().centre, before.centre);
        inspectAnything(player);
        fit(player);
        expectUncovered(player, "inspector");
        EXPECT_TRUE(player.showsCard("toolbox"));
    }
}

TEST(FittedView, NothingLiesUnderThemInARun) {
    for (std::size_t i = 0; i < levelCount; ++i) {
        Player player;
        player.open(anyLevel(i));
        player.frames(10);
        render::Camera const before = player.play().camera();
        player.key(SDLK_SPACE);
        player.simulate(16);
        player.key(SDLK_p);
        EXPECT_EQ(player.play().camera().centre, before.centre) << "a run does not move the view";
        player.key(SDLK_c);
        fit(player);
        expectUncovered(player, "components");
        Point const level = sizeOfLevel(player);
        EXPECT_TRUE(level.x > 300 || level.y > 300)
            << level.x << " x " << level.y << " pixels in " << player.play().file();
        render::Camera const beside = player.play().camera();
        player.key(SDLK_SPACE);
        player.frames(10);
        EXPECT_EQ(player.play().camera().centre, beside.centre) << "the end of a run moves nothing, either";
        expectUncovered(player, "components");
        if (player.showsCard("toolbox")) {
            expectUncovered(player, "toolbox");
        }
        player.key(SDLK_c);
        fit(player); // the goals have buttons now that ask why, and may be higher
        EXPECT_NEAR(player.play().camera().pixelsPerMetre, before.pixelsPerMetre,
                    0.12 * before.pixelsPerMetre);
        player.key(SDLK_SPACE);
        player.simulate(16);
        player.key(SDLK_p);
        player.key(SDLK_y, KMOD_LSHIFT);
        player.play().why().wait();
        fit(player);
        expectUncovered(player, "why");
    }
}

TEST(FittedView, NothingLiesUnderMods) {
    Player player;
    player.open(dataFolder() / "breeze.json");
    player.key(SDLK_m);
    fit(player);
    expectUncovered(player, "mods");
}

// The card of what-if lay over the battery, and its lane over the floor, however often one pressed *Fit*.
TEST(FittedView, NothingLiesUnderTheCardsOfThePast) {
    for (render::Size const size : {render::Size{1280, 720}, render::Size{800, 600}}) {
        Player player(size);
        player.open(firstContact);
        player.key(SDLK_f);
        player.key(SDLK_f);
        render::Camera const before = player.play().camera();
        player.key(SDLK_k);
        player.frames(2);
        player.play().timeline().seek(1);
        player.frames(2);
        player.key(SDLK_z);
        ASSERT_TRUE(player.play().whatIf().active());
        for (int i = 0; i < 600 && player.play().whatIf().moving(); ++i) {
            player.frame();
        }
        player.frames(4);
        EXPECT_EQ(player.play().camera().centre, before.centre) << "what opens moves nothing";
        fit(player);
        for (char const* const card : {"timeline", "what if lane", "what if", "corner"}) {
            expectUncovered(player, card);
        }
        player.look("fitted-what-if-" + std::to_string(size.width));
        EXPECT_GE(player.play().camera().pixelsPerMetre, 0.5 * before.pixelsPerMetre);
        player.play().timeline().probes().toggle("iron ball.position.x");
        fit(player);
        for (char const* const card : {"timeline", "what if lane", "what if", "probes"}) {
            expectUncovered(player, card);
        }
        resizeWindow(player, {1920, 1080});
        for (char const* const card : {"timeline", "what if lane", "what if", "probes"}) {
            expectUncovered(player, card);
        }
    }
}

// A balloon beside the contacts rises without end. What has left the level is not looked for.
TEST(FittedView, DoesNotFollowABalloonThatFliesAway) {
    Player player;
    player.open(levelsFolder() / "2-electricity/2-the-easy-way.json");
    player.drag(player.item("part foil balloon"), player.at({1, 2.6}));
    ASSERT_EQ(player.session().placed().size(), 1U);
    player.frames(10);
    render::Camera const before = player.play().camera();
    player.key(SDLK_SPACE);
    player.simulate(480);
    World const& world = player.session().world();
    EXPECT_GT(world.find<Position>(world.store().find("foil balloon 1"))->value.y, 8) << "it is away";
    EXPECT_LT(focusOf(player.session()).upper.y, 5) << "a picture of this moment does not show it";
    player.key(SDLK_p);
    player.key(SDLK_HOME);
    player.key(SDLK_c);
    player.key(SDLK_c);
    player.frames(10);
    EXPECT_NEAR(player.play().camera().pixelsPerMetre, before.pixelsPerMetre, 1e-6);
    EXPECT_NEAR(length(player.play().camera().centre - before.centre), 0, 0.01);
    player.look("balloon-away");
    player.key(SDLK_SPACE);
    player.frames(10);
    EXPECT_NEAR(player.play().camera().pixelsPerMetre, before.pixelsPerMetre, 1e-6);
}

TEST(FittedView, StaysWhereThePlayerHasMovedIt) {
    Player player;
    player.open(firstContact);
    player.frames(10);
    player.moveTo(player.at({0, 1.6}));
    player.wheel(2);
    player.frames(4);
    render::Camera const moved = player.play().camera();
    player.key(SDLK_c);
    player.frames(10);
    EXPECT_EQ(player.play().camera().centre, moved.centre);
    EXPECT_EQ(player.play().camera().pixelsPerMetre, moved.pixelsPerMetre);
    player.clickItem("fit");
    expectUncovered(player, "components");
    EXPECT_LT(player.play().camera().pixelsPerMetre, moved.pixelsPerMetre);
}

// In a small window the card takes the place of the level: the view stays as it was without the card, instead
// of showing a level that is too small to be recognised.
TEST(FittedView, IsCoveredWhereThereIsNoRoomBeside) {
    Player player({800, 600});
    player.open(anyLevel(1));
    player.frames(10);
    render::Camera const before = player.play().camera();
    player.key(SDLK_c);
    fit(player);
    ASSERT_TRUE(player.showsCard("components"));
    EXPECT_GE(player.play().camera().pixelsPerMetre, 0.5 * before.pixelsPerMetre);
}

// Boxes of 0.2 m were 7 pixels wide, as the view had to show all empty places beside the goal card.
TEST(FittedView, ShowsAllPlacesBelowTheGoalCardInASmallWindow) {
    Player player({800, 600});
    player.open(levelsFolder() / "experiments/4-raft.json");
    player.frames(10);
    EXPECT_GT(player.play().camera().pixelsPerMetre, 45);
    expectUncovered(player, "goal");
    Rect const goal = *player.layout().card("goal");
    for (Area const& area : *player.session().level().placing) {
        EXPECT_FALSE(goal.overlaps(onScreen(player.play().camera(), render::extentOf(area))));
    }
}

// The player has moved the view so that a place lies under the card.
TEST(FittedView, HidesTheGoalCardWhileAPartIsHeldThatMayBePlacedUnderIt) {
    Player player({800, 600});
    player.open(levelsFolder() / "experiments/4-raft.json");
    player.frames(10);
    for (int i = 0; i < 3; ++i) {
        player.key(SDLK_DOWN, KMOD_LCTRL);
    }
    Vec2 const place{-3, 2.1};
    Rect const goal = *player.layout().card("goal");
    ASSERT_TRUE(goal.contains(player.at(place))) << "a place where a part may lie";
    player.moveTo(player.item("part cargo box"));
    player.press();
    player.moveTo(player.at(place));
    player.frames(2);
    EXPECT_FALSE(player.showsCard("goal"));
    player.look("held-over-goal");
    player.release();
    player.frames(10);
    ASSERT_EQ(player.session().placed().size(), 1U);
    EXPECT_NEAR(player.session().placed()[0].placement.at.y, place.y, 0.1);
    EXPECT_TRUE(player.showsCard("goal"));
}

} // namespace
} // namespace fitted_view_test
} // namespace trembler::ui::test
