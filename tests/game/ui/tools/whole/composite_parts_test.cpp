// Parts of several pieces in the player's hand: they are moved as one, whichever piece is taken.
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace composite_parts_test {
namespace {

class Composites : public testing::Test {
protected:
    Composites() {
        player.open(dataFolder() / "composites.json");
        player.drag(player.item("part doorbell"), player.at(there));
    }
    [[nodiscard]] std::vector<PlacedPart> const& placed() { return player.session().placed(); }
    [[nodiscard]] int number() { return placed()[0].number; }
    /// Where a piece lies that is at `at` in the part.
    [[nodiscard]] Vec2 piece(Vec2 at) { return placed()[0].placement.at + at; }

    Player player;
    static constexpr Vec2 there{-1, 2};
    static constexpr Vec2 left{-0.95, -0.9};
    static constexpr Vec2 right{0.95, -0.9};
};

TEST_F(Composites, AnyPieceIsTheWholePart) {
    ASSERT_EQ(placed().size(), 1U);
    EXPECT_GT(player.session().objectsOf(number()).size(), 5U);
    player.click(player.at({2, 3}));
    EXPECT_FALSE(player.play().placing().selected());
    player.click(player.at(piece(right)));
    EXPECT_EQ(player.play().placing().selected(), number());
    player.look("composite-selected");

    player.moveTo(player.at(piece(left)));
    player.press();
    player.moveTo(player.at(piece(left) + Vec2{1, 0.2}));
    ASSERT_TRUE(player.play().placing().carried());
    EXPECT_TRUE(player.play().placing().carried()->verdict.ok) << "its own pieces are not in its way";
    player.look("composite-carried");
    player.release();
    player.frame();
    EXPECT_NEAR(placed()[0].placement.at.x, there.x + 1, 1e-9);
    EXPECT_NEAR(placed()[0].placement.at.y, there.y + 0.2, 1e-9);
}

TEST_F(Composites, AreMirroredWithAllPieces) {
    player.key(SDLK_v);
    ASSERT_TRUE(placed()[0].placement.flipped);
    World const& world = player.session().world();
    Position const* const post = world.find<Position>(world.store().find("doorbell 1 left"));
    ASSERT_NE(post, nullptr);
    EXPECT_NEAR(post->value.x, there.x - left.x, 1e-9);
    player.look("composite-flipped");
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_FALSE(placed()[0].placement.flipped);
}

TEST_F(Composites, NothingIsPlacedOnAnyOfTheirPieces) {
    player.moveTo(player.item("part steel ball"));
    player.press();
    player.moveTo(player.at(piece(right)));
    render::pushKey(window(), SDLK_LCTRL, true, KMOD_LCTRL); // not beside it either
    player.frames(2);
    ASSERT_TRUE(player.play().placing().carried());
    EXPECT_FALSE(player.play().placing().carried()->verdict.ok);
    render::pushKey(window(), SDLK_LCTRL, false);
    player.key(SDLK_ESCAPE);
    player.release();
}

TEST_F(Composites, MoveInAGroup) {
    player.drag(player.item("part steel ball"), player.at({1, 2}));
    ASSERT_EQ(placed().size(), 2U);
    player.key(SDLK_a, KMOD_LCTRL);
    ASSERT_EQ(player.play().group().chosen().size(), 2U);
    player.moveTo(player.at(piece(left)));
    player.press();
    player.moveTo(player.at(piece(left) + Vec2{0.3, 0}));
    EXPECT_TRUE(player.play().group().verdict().ok) << player.play().group().verdict().why;
    player.look("composite-in-a-group");
    player.release();
    player.frame();
    EXPECT_NEAR(placed()[0].placement.at.x, there.x + 0.3, 1e-9);
    EXPECT_NEAR(placed()[1].placement.at.x, 1.3, 1e-9);
    player.key(SDLK_v);
    EXPECT_TRUE(placed()[0].placement.flipped);
    EXPECT_NEAR(placed()[0].placement.at.x, 1.3, 1e-9) << "they changed sides";
}

TEST_F(Composites, AWireEndsAtAnyPieceAndTravelsInASolution) {
    player.key(SDLK_w);
    player.click(player.at({-3, 0.4}));
    player.click(player.at(piece(left)));
    ASSERT_EQ(player.session().wires().size(), 1U);
    player.click(player.at({3, 0.4}));
    player.click(player.at(piece(right)));
    ASSERT_EQ(player.session().wires().size(), 2U);
    player.look("composite-wired");
    Solution const solution = player.session().record("rings");
    ASSERT_EQ(solution.wires.size(), 2U);
    EXPECT_EQ(solution.wires[0].a, "doorbell 1 left");
    EXPECT_EQ(solution.wires[1].a, "doorbell 1 right");

    Session again(gameData().registry, gameData().parts, player.session().level());
    again.load(solution);
    ASSERT_EQ(again.wires().size(), 2U);
    ASSERT_TRUE(again.move(again.placed()[0].number, {0, 2}, 0));
    EXPECT_EQ(again.wires().size(), 2U) << "they go along";
    ASSERT_TRUE(again.putBack(again.placed()[0].number));
    EXPECT_TRUE(again.wires().empty());
}

} // namespace
} // namespace composite_parts_test
} // namespace trembler::ui::test
