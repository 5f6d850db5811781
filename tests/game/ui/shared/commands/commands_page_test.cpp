// The page of all commands: every one of a level is reached by a gamepad.
#include "render/window/gamepad.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

// A command without a button is chosen in the menu's list of commands, and run in the next picture.
TEST(CommandsPage, ReachesEveryCommandOfALevel) {
    using render::padKey;
    Player player;
    player.open(levelsFolder() / "first/1-first-contact.json");
    auto const choose = [&](std::string const& id) {
        player.key(padKey(SDL_CONTROLLER_BUTTON_START));
        player.moveTo({640, 20}); // the mouse removes the ring
        player.frames(2);
        player.clickItem("menu.commands");
        player.frames(2);
        ASSERT_EQ(player.app().menu().page(), MenuPage::commands);
        player.key(padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN)); // the ring appears, at the first command
        CommandSet const& commands = player.play().commands();
        std::size_t row = 0;
        for (std::size_t i = 0; i < commands.size(); ++i) {
            CommandInfo const& info = commands.info(i);
            bool const before =
                info.group < commands.info(commands.indexOf(id)).group ||
                (info.group == commands.info(commands.indexOf(id)).group && i < commands.indexOf(id));
            row += before && commands.available(i) && !info.leads && info.use != KeyUse::held ? 1U : 0U;
        }
        for (std::size_t i = 0; i < row; ++i) {
            player.key(padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN));
        }
        player.key(padKey(SDL_CONTROLLER_BUTTON_A));
        player.frames(3);
    };
    choose("names");
    EXPECT_FALSE(player.app().menu().isOpen());
    EXPECT_TRUE(player.play().commands().on(player.play().commands().indexOf("names")));
    choose("help");
    EXPECT_EQ(player.app().menu().page(), MenuPage::help) << "also what asks the program for something";
}

} // namespace
} // namespace trembler::ui::test
