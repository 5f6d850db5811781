#include "insight/trial/level_under_test.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace {

TEST(LevelUnderTest, IsTheSameFromItsFileAndFromMemory) {
    LevelUnderTest const again(gameData(), firstContact().level(), "first contact");
    EXPECT_EQ(again.identity(), firstContact().identity());
    EXPECT_EQ(again.name(), "first contact");
}

} // namespace
} // namespace trembler::insight
