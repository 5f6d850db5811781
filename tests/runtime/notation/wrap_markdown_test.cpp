// Wrapping changes only the places where lines of prose end.
#include "runtime/notation/wrap_markdown.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace trembler {
namespace wrap_markdown_test {
namespace {

TEST(WrapMarkdown, ProseIsWrappedBetweenWords) {
    EXPECT_EQ(wrapMarkdown("one two three\n\nfour\n", 8), "one two\nthree\n\nfour\n");
    EXPECT_EQ(wrapMarkdown("one two three", 7), "one two\nthree");
    EXPECT_EQ(wrapMarkdown("extraordinary as it is\n", 5), "extraordinary\nas it\nis\n");
    EXPECT_EQ(wrapMarkdown("", 5), "");
}

TEST(WrapMarkdown, WidthsAreThoseOfCharacters) {
    EXPECT_EQ(wrapMarkdown("Ω µ° Ω µ°\n", 9), "Ω µ° Ω µ°\n");
    EXPECT_EQ(wrapMarkdown("Ω µ° Ω µ°\n", 8), "Ω µ° Ω\nµ°\n");
}

TEST(WrapMarkdown, TablesCodeHeadingsAndPicturesStay) {
    for (std::string const line : {"| a | table |", "## a long heading", "![a picture](of something)",
                                   "<!-- a long comment -->", "    indented code here"}) {
        EXPECT_EQ(wrapMarkdown(line + "\n", 5), line + "\n");
    }
    EXPECT_EQ(wrapMarkdown("```lua\nlocal a = 1 -- one\n```\nnot code\n", 5),
              "```lua\nlocal a = 1 -- one\n```\nnot\ncode\n");
}

TEST(WrapMarkdown, CodeInALineIsNotDivided) {
    EXPECT_EQ(wrapMarkdown("call `out.push(object, force)`. It pushes.\n", 12),
              "call\n`out.push(object, force)`.\nIt pushes.\n");
}

TEST(WrapMarkdown, EntriesOfListsKeepTheirIndent) {
    EXPECT_EQ(wrapMarkdown("- one two three\n  - four five\n", 9),
              "- one two\n  three\n  - four\n    five\n");
    EXPECT_EQ(wrapMarkdown("12. one two\n", 8), "12. one\n    two\n");
}

TEST(WrapMarkdown, NoLineBeginsAnotherBlock) {
    EXPECT_EQ(wrapMarkdown("one two - three\n", 8), "one two -\nthree\n");
    EXPECT_EQ(wrapMarkdown("it was 1999. Then\n", 8), "it was 1999.\nThen\n");
    EXPECT_EQ(wrapMarkdown("one two # three\n", 8), "one two #\nthree\n");
}

std::vector<std::string> wordsOf(std::string const& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) {
        words.push_back(word);
    }
    return words;
}

TEST(WrapMarkdown, KeepsTheWordsOfAnyPageAndOnceIsEnough) {
    ASSERT_TRUE(rc::check([] {
        auto const pieces =
            *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(std::vector<std::string>{
                " ", "  ", "\n", "\n\n", "word", "a", "- ", "`", "| ", "µ", "2. ", "```\n"}));
        std::string page;
        for (std::string const& piece : pieces) {
            page += piece;
        }
        std::string const wrapped = wrapMarkdown(page, 12);
        RC_ASSERT(wordsOf(wrapped) == wordsOf(page));
        RC_ASSERT(wrapMarkdown(wrapped, 12) == wrapped);
    }));
}

} // namespace
} // namespace wrap_markdown_test
} // namespace trembler
