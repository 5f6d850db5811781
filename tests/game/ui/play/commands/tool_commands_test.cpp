// The key for wires in levels that have none, or none left: it says why, once.
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace tool_commands_test {
namespace {

class WireKey : public testing::Test {
protected:
    std::string told() { return player.app().context().toasts.newest(); }
    std::size_t count() { return player.app().context().toasts.count(); }
    Player player;
};

TEST_F(WireKey, SaysThatALevelHasNoWires) {
    for (char const* const level : {"first/1-first-contact.json", "2-electricity/1-both-gaps.json"}) {
        player.open(levelsFolder() / level);
        ASSERT_EQ(player.session().level().wires, 0);
        auto const before = count();
        player.key(SDLK_w);
        EXPECT_EQ(told(), "There are no wires to lay in this level.");
        EXPECT_EQ(count(), before + 1);
        player.key(SDLK_w);
        EXPECT_EQ(count(), before + 1) << "once, as long as it can be read";
        EXPECT_FALSE(player.play().wires().laying());
        player.key(SDLK_SPACE);
        player.key(SDLK_w);
        EXPECT_EQ(told(), "There are no wires to lay in this level.") << "nor in a run";
        player.frames(400);
    }
}

TEST_F(WireKey, SaysThatNoneIsLeftOrThatTheLevelRuns) {
    player.open(dataFolder() / "wires.json");
    player.key(SDLK_w);
    EXPECT_TRUE(player.play().wires().laying());
    EXPECT_EQ(count(), 0U);
    for (Vec2 const end : {Vec2{-0.4, 1.6}, Vec2{1, 0.4}}) {
        player.click(player.at({-1.6, 0.4}));
        player.click(player.at(end));
    }
    ASSERT_EQ(player.session().wiresLeft(), 0);
    player.key(SDLK_w);
    EXPECT_EQ(told(), "There is no wire left in the toolbox.");
    EXPECT_EQ(count(), 1U);
    player.key(SDLK_SPACE);
    player.key(SDLK_w);
    EXPECT_EQ(told(), "Only while building: stop the run first");
}

} // namespace
} // namespace tool_commands_test
} // namespace trembler::ui::test
