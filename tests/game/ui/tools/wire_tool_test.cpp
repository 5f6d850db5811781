// Laying wires with the mouse, and taking them back.
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace wire_tool_test {
namespace {

class Wiring : public testing::Test {
protected:
    Wiring() { player.open(dataFolder() / "wires.json"); }
    Player player;
    static constexpr Vec2 plus{-1.6, 0.4};
    static constexpr Vec2 lamp{-0.4, 1.6};
    static constexpr Vec2 minus{1, 0.4};
};

TEST_F(Wiring, AWireIsDraggedFromConductorToConductor) {
    player.clickItem("wire");
    EXPECT_TRUE(player.play().wires().laying());
    player.moveTo(player.at(plus));
    player.press();
    player.moveTo(player.at({-1, 1}));
    EXPECT_TRUE(player.play().wires().from().valid());
    player.look("wire-being-laid");
    player.moveTo(player.at(lamp));
    EXPECT_EQ(player.play().wires().why(), "");
    player.release();
    player.frame();
    ASSERT_EQ(player.session().wires().size(), 1U);
    EXPECT_TRUE(player.play().wires().laying()) << "there is another one";
    player.key(SDLK_SPACE);
    player.simulate(10);
    EXPECT_TRUE(player.session().solved());
    player.key(SDLK_SPACE);
    player.key(SDLK_z, KMOD_LCTRL);
    EXPECT_TRUE(player.session().wires().empty());
}

TEST_F(Wiring, ClicksLayTwoAndThenTheToolIsEmpty) {
    player.key(SDLK_w);
    player.click(player.at(plus));
    player.click(player.at(minus));
    EXPECT_EQ(player.session().wires().size(), 1U);
    player.click(player.at(plus));
    player.click(player.at(minus));
    EXPECT_EQ(player.session().wires().size(), 1U) << "there is one already";
    player.click(player.at(plus));
    player.click(player.at(lamp));
    EXPECT_EQ(player.session().wires().size(), 2U);
    EXPECT_FALSE(player.play().wires().laying());
    player.key(SDLK_w);
    EXPECT_FALSE(player.play().wires().laying()) << "none is left";
}

TEST_F(Wiring, WhatDoesNotConductIsRefusedAtThePointer) {
    player.drag(player.item("part wooden bar"), player.at({2, 2.5}));
    player.key(SDLK_w);
    player.moveTo(player.at({2, 2.5}));
    EXPECT_NE(player.play().wires().why(), "");
    player.look("wire-refused");
    player.click(player.at(plus));
    player.moveTo(player.at({2, 2.5}));
    EXPECT_NE(player.play().wires().why(), "");
    player.click(player.at({2, 2.5}));
    EXPECT_TRUE(player.session().wires().empty());
    player.key(SDLK_ESCAPE);
    EXPECT_TRUE(player.play().wires().laying()) << "first the wire is let go, then the tool";
    EXPECT_FALSE(player.play().wires().from().valid());
    player.key(SDLK_ESCAPE);
    EXPECT_FALSE(player.play().wires().laying());
    EXPECT_FALSE(player.app().menu().isOpen());
}

TEST_F(Wiring, AnEndThatIsRefusedLeavesTheWireInTheHand) {
    player.drag(player.item("part wooden bar"), player.at({2, 2.5}));
    player.key(SDLK_w);
    auto const from = [&] {
        WireTool const& wires = player.play().wires();
        return wires.from().valid() ? player.session().world().store().nameOf(wires.from()) : std::string();
    };
    auto& toasts = player.app().context().toasts;
    auto const before = toasts.count();
    player.drag(player.at(plus), player.at({2, 2.5}));
    EXPECT_EQ(from(), "plus") << "after a drag";
    EXPECT_EQ(toasts.count(), before + 1) << "the player is told once";
    player.click(player.at({2, 2.5}));
    EXPECT_EQ(from(), "plus") << "after a click";
    player.click(player.at(plus));
    EXPECT_EQ(from(), "plus") << "after a click on the beginning";
    player.drag(player.at(plus), player.at(lamp)); // from the beginning once more
    EXPECT_EQ(player.session().wires().size(), 1U);
    EXPECT_EQ(from(), "");
    player.click(player.at(plus));
    player.click(player.at({2, 2.5}));
    player.click(player.at({2, 2.5}), MouseButton::Right);
    EXPECT_EQ(from(), "");
    EXPECT_TRUE(player.play().wires().laying());
}

TEST_F(Wiring, BothEndsAreRefusedInTheSameWords) {
    player.drag(player.item("part wooden bar"), player.at({2, 2.5}));
    player.key(SDLK_w);
    player.moveTo(player.at({2, 2.5}));
    std::string const asBeginning = player.play().wires().why();
    ASSERT_NE(asBeginning.find("current"), std::string::npos) << asBeginning;
    player.click(player.at(plus));
    player.moveTo(player.at({2, 2.5}));
    EXPECT_EQ(player.play().wires().why(), asBeginning);
}

TEST_F(Wiring, ScissorsTakeBackOnlyThePlayersWires) {
    player.key(SDLK_w);
    player.drag(player.at(plus), player.at(lamp));
    ASSERT_EQ(player.session().wires().size(), 1U);
    player.key(SDLK_x);
    EXPECT_TRUE(player.play().wires().cutting());
    auto const wire = [&](char const* a, char const* b) {
        World const& world = player.session().world();
        render::FactsReader const reader(world);
        auto const poseOf = [&](ObjectId id) { return render::SceneView().poseOf(world, id); };
        ObjectId const first = world.store().find(a);
        ObjectId const last = world.store().find(b);
        auto const path = cablePath(reader.of(first), poseOf(first), reader.of(last), poseOf(last));
        auto const middle = path[path.size() / 2];
        return player.at({middle.x, middle.y});
    };
    player.click(wire("lamp", "minus"));
    EXPECT_EQ(player.session().wires().size(), 1U);
    EXPECT_TRUE(player.session().level().connections.size() == 1U);
    player.click(wire("lamp", "plus"));
    EXPECT_TRUE(player.session().wires().empty());
    EXPECT_EQ(player.session().wiresLeft(), 2);
}

} // namespace
} // namespace wire_tool_test
} // namespace trembler::ui::test
