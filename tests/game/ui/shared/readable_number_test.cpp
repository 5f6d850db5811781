#include "game/ui/shared/readable_number.hpp"

#include <gtest/gtest.h>

namespace trembler::ui {
namespace {

TEST(ReadableNumber, HasAboutFourDigits) {
    EXPECT_EQ(readable(0), "0");
    EXPECT_EQ(readable(-0.0), "0");
    EXPECT_EQ(readable(1.0 / 3), "0.333");
    EXPECT_EQ(readable(9.81), "9.81");
    EXPECT_EQ(readable(-12.5), "-12.5");
    EXPECT_EQ(readable(150000), "150000");
    EXPECT_EQ(readable(1e9), "1e+09");
    EXPECT_EQ(readable(2.5e-5), "2.5e-05");
}

} // namespace
} // namespace trembler::ui
