#include "runtime/file/visible_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck.h>

#include <algorithm>
#include <array>

namespace trembler {
namespace {

/// UTF-8 of one character (RFC 3629).
std::string utf8(char32_t c) {
    auto const byte = [](char32_t bits) { return static_cast<char>(bits); };
    if (c < 0x80) {
        return {byte(c)};
    }
    if (c < 0x800) {
        return {byte(0xC0 | c >> 6), byte(0x80 | (c & 0x3F))};
    }
    if (c < 0x10000) {
        return {byte(0xE0 | c >> 12), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F))};
    }
    return {byte(0xF0 | c >> 18), byte(0x80 | (c >> 12 & 0x3F)), byte(0x80 | (c >> 6 & 0x3F)),
            byte(0x80 | (c & 0x3F))};
}

// The characters that control terminals, one by one.
constexpr std::array<char32_t, 20> dangerous{0x00,   0x07,   0x08,   0x0D,   0x1B,   0x7F,   0x80,
                                             0x85,   0x9B,   0x9F,   0x200E, 0x200F, 0x202A, 0x202D,
                                             0x202E, 0x2028, 0x2066, 0x2069, 0xFEFF, 0x61C};

/// Whether none of its code points is dangerous. nlohmann's reader decodes it and so checks the UTF-8.
bool isHarmless(std::string const& text, bool lines) {
    if (!nlohmann::json::accept('"' + text + '"') && std::none_of(text.begin(), text.end(), [](char c) {
            return c == '"' || c == '\\' || c == '\n' || c == '\t';
        })) {
        return false;
    }
    bool const controls = std::any_of(text.begin(), text.end(), [&](char c) {
        auto const byte = static_cast<unsigned char>(c);
        return (byte < 0x20 && !(lines && (c == '\n' || c == '\t'))) || byte == 0x7F;
    });
    return !controls && std::none_of(dangerous.begin(), dangerous.end(), [&](char32_t c) {
        return c >= 0x80 && text.find(utf8(c)) != std::string::npos;
    });
}

/// Letters, dangerous characters, and invalid bytes.
std::string anyText() {
    std::string text;
    auto const pieces = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 4));
    for (int const kind : pieces) {
        switch (kind) {
        case 0:
            text += utf8(dangerous[*rc::gen::inRange<std::size_t>(0, dangerous.size())]);
            break;
        case 1:
            text += *rc::gen::arbitrary<char>();
            break;
        case 2: {
            auto const c = static_cast<char32_t>(*rc::gen::inRange(0, 0x110000));
            text += c >= 0xD800 && c < 0xE000 ? "\n" : utf8(c);
            break;
        }
        default:
            text += *rc::gen::element<std::string>("a", "Ω", "µ", "m²", "\t", "木", "🙂");
        }
    }
    return text;
}

TEST(VisibleText, IsHarmlessForAnyInput) {
    EXPECT_TRUE(rc::check([] {
        std::string const text = anyText();
        RC_ASSERT(isHarmless(visible(text), false));
        RC_ASSERT(isHarmless(visibleLines(text), true));
        RC_ASSERT(visible(visible(text)) == visible(text));
        std::string lines = visibleLines(text);
        RC_ASSERT(std::count(lines.begin(), lines.end(), '\n') == std::count(text.begin(), text.end(), '\n'));
    }));
}

TEST(VisibleText, ShowsReplacedCharactersAsCodes) {
    EXPECT_EQ(visible("a\x1b[31mb"), "a<U+001B>[31mb");
    EXPECT_EQ(visible("two\nlines"), "two<U+000A>lines");
    EXPECT_EQ(visibleLines("two\nlines\r"), "two\nlines<U+000D>");
    EXPECT_EQ(visible("\xC2\x9B"), "<U+009B>");
    EXPECT_EQ(visible("\x9B"), "<9B>") << "a byte that is C1 to a terminal without UTF-8";
    EXPECT_EQ(visible("\xE2\x80\xAE"), "<U+202E>");
    EXPECT_EQ(visible("\xF3\xA0\x80\x81"), "<U+E0001>");
    EXPECT_EQ(visible("\xED\xA0\x80"), "<ED><A0><80>") << "a surrogate";
    EXPECT_EQ(visible("\xC0\x9B"), "<C0><9B>") << "an overlong form";
    EXPECT_EQ(visible(std::string("\0", 1)), "<U+0000>");
    EXPECT_EQ(visible("9.81 m/s² – Ω 木 🙂"), "9.81 m/s² – Ω 木 🙂");
}

TEST(VisibleText, IsTheSameIfGivenInPieces) {
    EXPECT_TRUE(rc::check([] {
        std::string const text = anyText();
        std::string made;
        std::string pending;
        for (char const c : text) {
            pending += c;
            std::size_t const tail = unfinishedCharacter(pending);
            RC_ASSERT(tail <= 3);
            made += visibleLines(std::string_view(pending).substr(0, pending.size() - tail));
            pending = pending.substr(pending.size() - tail);
        }
        RC_ASSERT(made + visibleLines(pending) == visibleLines(text));
    }));
}

TEST(VisibleText, KeepsItsMeaningInJson) {
    EXPECT_TRUE(rc::check([] {
        std::string text;
        do {
            text = anyText();
        } while (!nlohmann::json::accept(
            nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
        std::string const printed =
            nlohmann::json{{"key", text}}.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
        std::string const escaped = escapedJson(printed);
        RC_ASSERT(nlohmann::json::parse(escaped) == nlohmann::json::parse(printed));
        RC_ASSERT(visibleLines(escaped) == escaped);
    }));
    EXPECT_EQ(escapedJson("\"\xE2\x80\xAE\x7F\xF3\xA0\x80\x81\""), "\"\\u202e\\u007f\\udb40\\udc01\"");
    EXPECT_EQ(escapedJson("{\n  \"µ\": 1\n}\n"), "{\n  \"µ\": 1\n}\n");
}

TEST(VisibleText, KnowsControlCharacters) {
    for (char const* const text : {"a\nb", "\t", "\x1b[0m", "a\x7f"}) {
        EXPECT_TRUE(hasControlCharacter(text)) << text;
    }
    EXPECT_TRUE(hasControlCharacter(std::string_view("a\0b", 3)));
    for (char const* const text : {"", "a b", "\xc3\x9c", "~"}) {
        EXPECT_FALSE(hasControlCharacter(text)) << text;
    }
}

} // namespace
} // namespace trembler
