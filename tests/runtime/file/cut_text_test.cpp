// Cut texts are short, are the beginning of the whole text, and end with a whole character.
#include "runtime/file/cut_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>

namespace trembler {
namespace {

TEST(CutText, LeavesAShortTextAlone) {
    EXPECT_EQ(cutText("", 0), "");
    EXPECT_EQ(cutText("seven b", 7), "seven b");
    EXPECT_EQ(cutText("eight by", 7), "eigh...");
}

TEST(CutText, CutsNoCharacterInTwo) {
    bool const holds = rc::check([] {
        std::string text;
        int const count = *rc::gen::inRange(0, 40);
        for (int i = 0; i < count; ++i) {
            text += *rc::gen::element<std::string>("a", "\u00E4", "\u20AC", "\U0001F600");
        }
        auto const most = *rc::gen::inRange<std::size_t>(3, 60);
        std::string const cut = cutText(text, most);
        RC_ASSERT(cut.size() <= most);
        if (text.size() <= most) {
            RC_ASSERT(cut == text);
            return;
        }
        RC_ASSERT(cut.ends_with("..."));
        std::size_t const kept = cut.size() - 3;
        RC_ASSERT(text.compare(0, kept, cut, 0, kept) == 0);
        RC_ASSERT(kept == text.size() || (static_cast<unsigned char>(text[kept]) & 0xC0U) != 0x80U);
        RC_ASSERT(cut.size() + 4 > most); // no more is left out than one character
    });
    EXPECT_TRUE(holds);
}

} // namespace
} // namespace trembler
