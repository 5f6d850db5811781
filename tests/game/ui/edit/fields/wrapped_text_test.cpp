// Wrapping lines of a text while it is typed, and restoring the typed text.
#include "game/ui/edit/fields/wrapped_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler::ui {
namespace wrapped_text_test {
namespace {

float one(std::uint32_t /*character*/) {
    return 1;
}

TEST(WrappedText, BreaksAfterBlanksAndInsideLongWords) {
    EXPECT_EQ(wrapLines({"aa bb cc", 0}, 5, one).text, "aa bb \r\ncc");
    EXPECT_EQ(wrapLines({"aa bb cc", 6}, 5, one).cursor, 8U) << "at the beginning of the next line";
    EXPECT_EQ(wrapLines({"aa bb cc", 5}, 5, one).cursor, 5U);
    EXPECT_EQ(wrapLines({"aaaaaaa", 0}, 3, one).text, "aaa\r\naaa\r\na");
    EXPECT_EQ(wrapLines({"aa\nbb", 0}, 2, one).text, "aa\nbb");
    EXPECT_EQ(wrapLines({"ää öö", 0}, 3, one).text, "ää \r\nöö") << "characters are counted, not bytes";
    EXPECT_EQ(wrapLines({"", 0}, 3, one), (WrappedText{"", 0}));
}

TEST(WrappedText, ComesBackAsItWas) {
    rc::check([] {
        auto const letters = *rc::gen::container<std::string>(rc::gen::element('a', 'b', ' ', '\n'));
        auto const cursor = *rc::gen::inRange<std::size_t>(0, letters.size() + 1);
        auto const width = *rc::gen::inRange(1, 9);
        WrappedText const plain{letters, cursor};
        RC_ASSERT(unwrapLines(wrapLines(plain, static_cast<float>(width), one)) == plain);
    });
}

TEST(WrappedText, BackspaceAtTheBeginningOfALineDeletesWhatIsBefore) {
    // "aa bb \r\n|cc", and the "\n" was deleted
    EXPECT_EQ(unwrapLines({"aa bb \rcc", 7}), (WrappedText{"aa bbcc", 5}));
}

} // namespace
} // namespace wrapped_text_test
} // namespace trembler::ui
