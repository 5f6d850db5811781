// Building with the mouse: every way to take, place, turn, move and put back a part.
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

class Building : public testing::Test {
protected:
    Building() { player.open(levelsFolder() / "first/1-first-contact.json"); }

    [[nodiscard]] std::vector<PlacedPart> const& placed() { return player.session().placed(); }
    [[nodiscard]] int left(std::string const& part) {
        for (ToolboxSlot const& slot : player.session().toolbox()) {
            if (slot.part == part) {
                return slot.left;
            }
        }
        return -1;
    }
    void dragFromToolbox(std::string const& part, Vec2 to) {
        player.drag(player.item("part " + part), player.at(to));
    }
    void expectPlaced(std::size_t index, Vec2 at, double degrees) {
        ASSERT_LT(index, placed().size());
        EXPECT_NEAR(placed()[index].placement.at.x, at.x, 1e-9);
        EXPECT_NEAR(placed()[index].placement.at.y, at.y, 1e-9);
        EXPECT_NEAR(placed()[index].placement.angle * 180 / pi, degrees, 1e-9);
    }

    Player player;
    static constexpr Vec2 free{-1.8, 1.5};
};

TEST_F(Building, APartIsDraggedOutOfTheToolbox) {
    EXPECT_EQ(left("steel bar"), 1);
    dragFromToolbox("steel bar", free);
    expectPlaced(0, free, 0);
    EXPECT_EQ(left("steel bar"), 0);
    // It lies where it was dropped on the screen, and an empty compartment provides no further part.
    auto const object = player.session().objectOf(placed()[0].number);
    EXPECT_EQ(render::pick(player.session().world(), {free.x, free.y}), object);
    dragFromToolbox("steel bar", {-1.8, 2.0});
    EXPECT_EQ(placed().size(), 1U);
}

TEST_F(Building, APartIsTakenWithOneClickAndPlacedWithAnother) {
    player.clickItem("part spanner");
    EXPECT_TRUE(player.play().placing().carried());
    player.click(player.at(free));
    expectPlaced(0, free, 0);
    EXPECT_FALSE(player.play().placing().carried());
    EXPECT_EQ(placed()[0].placement.part, "spanner");
}

TEST_F(Building, PartsSnapToTheGridUnlessCtrlIsHeld) {
    Vec2 const between{-1.812, 1.518};
    dragFromToolbox("steel bar", between);
    expectPlaced(0, {-1.8, 1.5}, 0);
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_TRUE(placed().empty());
    player.moveTo(player.item("part steel bar"));
    player.press();
    render::pushKey(window(), SDLK_LCTRL, true, KMOD_LCTRL);
    player.moveTo(player.at(between));
    player.release();
    ASSERT_EQ(placed().size(), 1U);
    // As exactly as whole pixels of the screen allow.
    double const pixel = 1 / player.play().camera().pixelsPerMetre;
    EXPECT_NEAR(placed()[0].placement.at.x, between.x, pixel);
    EXPECT_NEAR(placed()[0].placement.at.y, between.y, pixel);
    EXPECT_GT(std::abs(placed()[0].placement.at.y - 1.5), 1e-6);
}

TEST_F(Building, APartIsMirroredInTheHandAndOnThePaper) {
    player.moveTo(player.item("part spanner"));
    player.press();
    player.moveTo(player.at(free));
    player.key(SDLK_q);
    player.key(SDLK_v);
    ASSERT_TRUE(player.play().placing().carried());
    EXPECT_TRUE(player.play().placing().carried()->landing.flipped);
    player.release();
    player.frame();
    expectPlaced(0, free, -15);
    EXPECT_TRUE(placed()[0].placement.flipped);
    player.key(SDLK_v);
    expectPlaced(0, free, 15);
    EXPECT_FALSE(placed()[0].placement.flipped);
    player.clickItem("flip");
    EXPECT_TRUE(placed()[0].placement.flipped);
    player.key(SDLK_z, KMOD_LCTRL);
    expectPlaced(0, free, 15);
    EXPECT_FALSE(placed()[0].placement.flipped);
}

TEST_F(Building, TheWheelAndTheKeysTurnThePartInTheHand) {
    player.moveTo(player.item("part steel bar"));
    player.press();
    player.moveTo(player.at(free));
    player.wheel(1);
    player.wheel(1);
    player.key(SDLK_e);
    player.key(SDLK_q, KMOD_LSHIFT);
    player.release();
    expectPlaced(0, free, 16);
}

TEST_F(Building, KeysTurnAndMoveTheSelectedPart) {
    dragFromToolbox("steel bar", free);
    ASSERT_TRUE(player.play().placing().selected());
    player.key(SDLK_q);
    player.key(SDLK_q);
    expectPlaced(0, free, 30);
    for (int i = 0; i < 24; ++i) { // a full turn restores the angle
        player.key(SDLK_e);
    }
    expectPlaced(0, free, 30);
    player.key(SDLK_RIGHT);
    player.key(SDLK_UP, KMOD_LSHIFT);
    expectPlaced(0, {free.x + 0.05, free.y + 0.01}, 30);
}

TEST_F(Building, TheHandleTurnsOnTheSpot) {
    dragFromToolbox("steel bar", free);
    auto const knob = player.play().handle();
    ASSERT_TRUE(knob);
    player.drag(player.at(*knob), player.at(free + Vec2{-1, 0}));
    expectPlaced(0, free, 90);
    player.key(SDLK_z, KMOD_LCTRL);
    expectPlaced(0, free, 0);
}

TEST_F(Building, APlacedPartIsMovedByDragging) {
    dragFromToolbox("steel bar", free);
    int const number = placed()[0].number;
    // Grabbed beside its middle, it moves as far as the mouse does.
    player.drag(player.at(free + Vec2{0.3, 0}), player.at(free + Vec2{0.1, 0.4}));
    expectPlaced(0, free + Vec2{-0.2, 0.4}, 0);
    EXPECT_EQ(placed()[0].number, number);
}

TEST_F(Building, EveryWayBackIntoTheToolbox) {
    dragFromToolbox("steel bar", free);
    player.drag(player.at(free), player.item("part wooden bar"));
    EXPECT_TRUE(placed().empty()) << "dragged back";
    dragFromToolbox("steel bar", free);
    player.click(player.at(free), MouseButton::Right);
    EXPECT_TRUE(placed().empty()) << "right click";
    dragFromToolbox("steel bar", free);
    player.key(SDLK_DELETE);
    EXPECT_TRUE(placed().empty()) << "Delete";
    EXPECT_EQ(left("steel bar"), 1);
    // A part that was never placed: by a second click on its tile, by Esc, by a right click.
    player.clickItem("part steel bar");
    player.clickItem("part steel bar");
    EXPECT_FALSE(player.play().placing().carried());
    player.clickItem("part steel bar");
    player.moveTo(player.at(free));
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.play().placing().carried());
    EXPECT_FALSE(player.app().menu().isOpen());
    player.clickItem("part steel bar");
    player.click(player.at(free), MouseButton::Right);
    EXPECT_FALSE(player.play().placing().carried());
    EXPECT_TRUE(placed().empty());
}

TEST_F(Building, UndoAndRedoWithoutEnd) {
    dragFromToolbox("steel bar", free);
    dragFromToolbox("spanner", {-1.8, 2.0});
    player.key(SDLK_q);
    ASSERT_EQ(placed().size(), 2U);
    player.key(SDLK_z, KMOD_LCTRL);
    expectPlaced(1, {-1.8, 2.0}, 0);
    player.clickItem("undo");
    EXPECT_EQ(placed().size(), 1U);
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_TRUE(placed().empty());
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_TRUE(placed().empty());
    player.key(SDLK_y, KMOD_LCTRL);
    player.key(SDLK_z, KMOD_LCTRL | KMOD_LSHIFT);
    player.key(SDLK_y, KMOD_LCTRL);
    ASSERT_EQ(placed().size(), 2U);
    expectPlaced(1, {-1.8, 2.0}, 15);
}

TEST_F(Building, AForbiddenPlacementIsRefusedWithTheReason) {
    Vec2 const forbidden{1.7, 1.7}; // far outside the area for placing, in the electromagnet
    player.moveTo(player.item("part steel bar"));
    player.press();
    player.moveTo(player.at(forbidden));
    ASSERT_TRUE(player.play().placing().carried());
    EXPECT_FALSE(player.play().placing().carried()->verdict.ok);
    EXPECT_FALSE(player.play().placing().carried()->verdict.why.empty());
    player.release();
    EXPECT_TRUE(placed().empty());
    ASSERT_TRUE(player.play().placing().carried()) << "it stays in the hand";
    player.moveTo(player.at(free)); // follows without a button held
    EXPECT_TRUE(player.play().placing().carried()->verdict.ok);
    player.click(player.at(free));
    expectPlaced(0, free, 0);
    player.drag(player.at(free), player.at(forbidden));
    ASSERT_TRUE(player.play().placing().carried()) << "a part that was placed before, too";
    expectPlaced(0, free, 0);
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.play().placing().carried());
    expectPlaced(0, free, 0);                  // back where it was
    player.click(player.item("part spanner")); // without a button held it stays in the hand
    player.click(player.at(forbidden));
    ASSERT_TRUE(player.play().placing().carried());
    EXPECT_FALSE(player.play().placing().carried()->verdict.ok);
    player.key(SDLK_BACKSPACE);
    EXPECT_FALSE(player.play().placing().carried()) << "the part in the hand goes back first";
    EXPECT_EQ(placed().size(), 1U);
}

TEST_F(Building, SmallOverlapsAreCorrected) {
    dragFromToolbox("steel bar", {-1.8, 1.2});
    dragFromToolbox("spanner", {-1.8, 1.35}); // partly inside the bar
    ASSERT_EQ(placed().size(), 2U);
    Vec2 const shift = placed()[1].placement.at - Vec2{-1.8, 1.35};
    EXPECT_GT(length(shift), 0);
    EXPECT_LE(length(shift), 14 / player.play().camera().pixelsPerMetre + 1e-9);
    EXPECT_TRUE(player.session().check(placed()[1].placement, placed()[1].number).ok);
}

TEST_F(Building, PuttingAllBackNeedsASecondRequest) {
    dragFromToolbox("steel bar", free);
    dragFromToolbox("spanner", {-1.8, 2.0});
    player.key(SDLK_BACKSPACE);
    EXPECT_EQ(placed().size(), 2U);
    player.key(SDLK_BACKSPACE);
    EXPECT_TRUE(placed().empty());
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_EQ(placed().size(), 2U);
    player.clickItem("all back");
    EXPECT_EQ(placed().size(), 2U);
    player.frames(2);
    player.clickItem("all back");
    EXPECT_TRUE(placed().empty());
}

TEST_F(Building, TheViewIsZoomedAndDragged) {
    auto const before = player.play().camera();
    Point const at = player.at({0, 2.0});
    player.moveTo(at);
    player.wheel(3);
    auto const zoomed = player.play().camera();
    EXPECT_GT(zoomed.pixelsPerMetre, before.pixelsPerMetre * 1.3);
    EXPECT_NEAR(zoomed.toWorld(at).x, 0, 0.02) << "the point under the mouse stays";
    player.drag(at, at + Point{50, 30});
    EXPECT_NEAR(player.play().camera().toScreen({0, 2.0}).x, at.x + 50, 3);
    player.drag(at, at + Point{-20, 0}, MouseButton::Right);
    EXPECT_NEAR(player.play().camera().toScreen({0, 2.0}).x, at.x + 30, 3);
    player.key(SDLK_HOME);
    EXPECT_EQ(player.play().camera().pixelsPerMetre, before.pixelsPerMetre);
    EXPECT_EQ(player.play().camera().centre, before.centre);
    EXPECT_TRUE(placed().empty());
}

} // namespace
} // namespace trembler::ui::test
