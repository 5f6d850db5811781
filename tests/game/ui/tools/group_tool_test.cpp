// Several parts at once, by mouse and by keys.
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace group_tool_test {
namespace {

class Several : public testing::Test {
protected:
    Several() {
        player.open(dataFolder() / "several.json");
        player.drag(player.item("part steel bar"), player.at(a));
        player.drag(player.item("part spanner"), player.at(b));
    }
    [[nodiscard]] std::vector<PlacedPart> const& placed() { return player.session().placed(); }
    void holdShift(bool down) {
        render::pushKey(window(), SDLK_LSHIFT, down, down ? KMOD_LSHIFT : KMOD_NONE);
        player.frame();
    }
    void shiftClick(Vec2 where) {
        holdShift(true);
        player.click(player.at(where));
        holdShift(false);
    }
    void expectAt(std::size_t index, Vec2 at) {
        ASSERT_LT(index, placed().size());
        EXPECT_NEAR(placed()[index].placement.at.x, at.x, 1e-9);
        EXPECT_NEAR(placed()[index].placement.at.y, at.y, 1e-9);
    }
    [[nodiscard]] std::size_t chosen() { return player.play().group().chosen().size(); }

    Player player;
    static constexpr Vec2 a{-1, 1.5};
    static constexpr Vec2 b{0.5, 2};
};

TEST_F(Several, ShiftClicksChooseAndADragMovesAllInOneStep) {
    ASSERT_EQ(placed().size(), 2U);
    shiftClick(a);
    EXPECT_EQ(chosen(), 2U) << "the spanner was selected already";
    player.drag(player.at(a), player.at(a + Vec2{0.5, 0.5}));
    expectAt(0, a + Vec2{0.5, 0.5});
    expectAt(1, b + Vec2{0.5, 0.5});
    EXPECT_EQ(chosen(), 2U);
    player.look("several-chosen");
    player.key(SDLK_z, KMOD_LCTRL);
    expectAt(0, a);
    expectAt(1, b);
    shiftClick(b);
    player.frames(2);
    EXPECT_EQ(chosen(), 0U);
    EXPECT_EQ(player.play().placing().selected(), placed()[0].number);
}

TEST_F(Several, ABoxChoosesAndKeysTurnMoveAndPutBack) {
    player.click(player.at({2, 2.8})); // on the paper: nothing is selected
    holdShift(true);
    player.drag(player.at({-1.6, 2.5}), player.at({1.2, 1}));
    holdShift(false);
    EXPECT_EQ(chosen(), 2U);
    Vec2 const centre = 0.5 * (a + b);
    for (int i = 0; i < 12; ++i) {
        player.key(SDLK_q);
    }
    expectAt(0, centre - (a - centre));
    EXPECT_NEAR(std::abs(placed()[0].placement.angle), pi, 1e-9);
    player.key(SDLK_RIGHT);
    expectAt(1, centre - (b - centre) + Vec2{gridStep, 0});
    player.key(SDLK_DELETE);
    EXPECT_TRUE(placed().empty());
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_EQ(placed().size(), 2U);
}

TEST_F(Several, AreDuplicatedAsFarAsTheToolboxHasThem) {
    player.key(SDLK_a, KMOD_LCTRL);
    EXPECT_EQ(chosen(), 2U);
    player.key(SDLK_d, KMOD_LCTRL);
    ASSERT_EQ(placed().size(), 4U);
    EXPECT_EQ(chosen(), 2U);
    EXPECT_NEAR(length(placed()[3].placement.at - placed()[2].placement.at - (b - a)), 0, 1e-9);
    player.key(SDLK_d, KMOD_LCTRL);
    EXPECT_EQ(placed().size(), 4U) << "there are only two spanners";
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_EQ(placed().size(), 2U) << "one step of undo";
}

TEST_F(Several, AreMirroredTogether) {
    player.key(SDLK_a, KMOD_LCTRL);
    player.key(SDLK_v);
    expectAt(0, {b.x, a.y});
    expectAt(1, {a.x, b.y});
    EXPECT_TRUE(placed()[0].placement.flipped && placed()[1].placement.flipped);
    player.clickItem("flip");
    expectAt(0, a);
    EXPECT_FALSE(placed()[0].placement.flipped);
    player.key(SDLK_z, KMOD_LCTRL);
    expectAt(0, {b.x, a.y});
}

TEST_F(Several, AForbiddenPlaceChangesNothingAndTheyStayInTheHand) {
    Vec2 const forbidden{0.5, 3.9};
    player.key(SDLK_a, KMOD_LCTRL);
    player.drag(player.at(b), player.at(forbidden));
    expectAt(0, a);
    expectAt(1, b);
    EXPECT_TRUE(player.play().group().dragging());
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.play().group().dragging());
    expectAt(1, b);
    player.drag(player.at(b), player.at(forbidden));
    player.moveTo(player.at(b + Vec2{0.5, 0.2}));
    EXPECT_TRUE(player.play().group().verdict().ok);
    player.click(player.at(b + Vec2{0.5, 0.2}));
    EXPECT_FALSE(player.play().group().dragging());
    expectAt(0, a + Vec2{0.5, 0.2});
    expectAt(1, b + Vec2{0.5, 0.2});
    player.key(SDLK_z, KMOD_LCTRL);
    expectAt(1, b);
    player.drag(player.at(b), player.at(forbidden));
    player.click(player.at({2, 2.8}), MouseButton::Right);
    EXPECT_FALSE(player.play().group().dragging());
    expectAt(1, b);
    player.drag(player.at(b), player.item("part spanner"));
    EXPECT_TRUE(placed().empty()) << "onto the toolbox";
}

TEST_F(Several, EscapeAndARunEndTheChoice) {
    player.key(SDLK_a, KMOD_LCTRL);
    player.key(SDLK_ESCAPE);
    EXPECT_EQ(chosen(), 0U);
    EXPECT_FALSE(player.app().menu().isOpen());
    player.key(SDLK_a, KMOD_LCTRL);
    player.key(SDLK_SPACE);
    player.frames(3);
    EXPECT_EQ(chosen(), 0U);
}

} // namespace
} // namespace group_tool_test
} // namespace trembler::ui::test
