// Lower case for comparisons: ASCII only, whatever the locale is.
#include "runtime/file/lower_case.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(LowerCase, ChangesOnlyTheLettersOfAscii) {
    EXPECT_EQ(inLowerCase("Pad R1 @[Z]"), "pad r1 @[z]");
    EXPECT_EQ(inLowerCase("Größe ÄÖÜ"), "größe ÄÖÜ");
    EXPECT_EQ(inLowerCase(""), "");
}

} // namespace
} // namespace trembler
