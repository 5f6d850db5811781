// Messages of scripts that nobody reads do not gather for ever.
#include "lua/component/script_log.hpp"

#include <gtest/gtest.h>

#include <string>

namespace trembler::lua {
namespace {

TEST(ScriptLog, KeepsTheFirstThousandMessagesUntilTheyAreRead) {
    ScriptLog log;
    for (int i = 0; i < 1001; ++i) {
        log.add({.script = "s", .frame = 0, .error = false, .text = std::to_string(i), .traceback = {}});
    }
    std::vector<ScriptMessage> const messages = log.take();
    ASSERT_EQ(messages.size(), 1000U);
    EXPECT_EQ(messages.front().text, "0");
    EXPECT_EQ(messages.back().text, "999");
    log.add({.script = "s", .frame = 1, .error = true, .text = "after reading", .traceback = {}});
    ASSERT_EQ(log.take().size(), 1U);
    EXPECT_TRUE(log.take().empty());
}

TEST(ScriptLog, RemembersWhatWasApplied) {
    ScriptLog log;
    EXPECT_FALSE(log.everApplied("s"));
    log.noteApplied("s");
    EXPECT_TRUE(log.everApplied("s"));
    EXPECT_FALSE(log.everApplied("t"));
}

} // namespace
} // namespace trembler::lua
