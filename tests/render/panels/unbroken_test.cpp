// Numbers stay on one line with their units and counts.
#include "render/panels/unbroken.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace trembler::render {
namespace {

/// With "_" for a no-break space.
std::string marked(std::string_view text) {
    std::string made = unbroken(text);
    for (std::size_t at = made.find("\u00A0"); at != std::string::npos; at = made.find("\u00A0")) {
        made.replace(at, 2, "_");
    }
    return made;
}

TEST(Unbroken, KeepsANumberWithItsUnitAndItsOtherPart) {
    EXPECT_EQ(marked("Keep the lamp lit for 4 seconds"), "Keep the lamp lit for 4_seconds");
    EXPECT_EQ(marked("Ring the bell (0 of 5)"), "Ring the bell (0_of_5)");
    EXPECT_EQ(marked("Teil 3 von 12, wie gelegt"), "Teil 3_von_12, wie gelegt");
    EXPECT_EQ(marked("turned by 0.3 N m in all"), "turned by 0.3_N_m in all");
    EXPECT_EQ(marked("turned by 0.3 N m."), "turned by 0.3_N_m.");
    EXPECT_EQ(marked("pulled by 3 N more than before"), "pulled by 3_N more than before");
}

TEST(Unbroken, LeavesOtherWordsAlone) {
    for (std::string_view const text : {"", " ", "one of two", "a first, a second", "of 5", "level 5/1"}) {
        EXPECT_EQ(unbroken(text), text);
    }
}

} // namespace
} // namespace trembler::render
