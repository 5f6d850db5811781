// A table of commands, and the screen that they act on.
#include "tests/game/ui/shared/commands/counting_screen.hpp"

#include <gtest/gtest.h>

namespace trembler::ui::test {
namespace {

TEST(CommandTables, RunAvailableCommandsById) {
    Counting counting;
    CommandsOf<Counting> commands(countingTable, counting);
    EXPECT_EQ(commands.size(), countingTable.size());
    commands.run("jump");
    EXPECT_EQ(counting.done["j"], 1);
    counting.mayJump = false;
    EXPECT_FALSE(commands.available(commands.indexOf("jump")));
    commands.run("jump");
    EXPECT_EQ(counting.done["j"], 1);
    EXPECT_TRUE(commands.has("walk"));
    EXPECT_FALSE(commands.has("paint"));
    EXPECT_THROW(commands.run("paint"), std::invalid_argument);
    EXPECT_FALSE(commands.on(0)) << "it is not a switch";
}

} // namespace
} // namespace trembler::ui::test
