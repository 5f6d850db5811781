// Places in a text, compared with a writer that records the place of each value.
#include "runtime/level/json/json_locator.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck.h>

#include <vector>

namespace trembler {
namespace json_locator_test {
namespace {

struct Noted {
    std::string pointer;
    std::size_t value = 0;
    std::size_t key = 0; ///< the place of the value if it has no key
};

/// Writes a random document, with blanks wherever JSON allows them and escapes where it allows those.
class NotingWriter {
public:
    std::string text;
    std::vector<Noted> all;

    void document() {
        blanks();
        value("", text.size(), 3);
        blanks();
    }

private:
    void blanks() {
        for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
            text += *rc::gen::element(' ', '\n', '\t', '\r');
        }
    }
    /// A token for the text, and the same as a reference token of RFC 6901.
    std::string key(int number) {
        struct Piece {
            char const* token;
            char const* pointer;
        };
        static constexpr Piece pieces[] = {{"", ""},
                                           {"a/b", "a~1b"},
                                           {"\\u0061\\/b", "a~1b"},
                                           {"~", "~0"},
                                           {"~1", "~01"},
                                           {"\\\"}", "\"}"},
                                           {"\\\\", "\\"},
                                           {"\xC3\xA9", "\xC3\xA9"},
                                           {"\\u00e9", "\xC3\xA9"},
                                           {"[{,:", "[{,:"}};
        Piece const& piece = pieces[*rc::gen::inRange<std::size_t>(0, std::size(pieces))];
        text += '"' + std::to_string(number) + piece.token + '"';
        return std::to_string(number) + piece.pointer;
    }
    void value(std::string const& pointer, std::size_t keyAt, int depth) {
        bool const isRoot = pointer.empty();
        all.push_back({pointer, text.size(), isRoot ? text.size() : keyAt});
        switch (*rc::gen::inRange(0, depth > 0 ? 4 : 2)) {
        case 0:
            text += *rc::gen::element<std::string>("null", "true", "-1.5e3", "0");
            break;
        case 1:
            text += *rc::gen::element<std::string>("\"\"", "\"}]\\\",{\"", "\"\\\\\"", "\"\xE2\x86\x92\"");
            break;
        case 2: {
            text += '[';
            blanks();
            int const count = *rc::gen::inRange(0, 4);
            for (int i = 0; i < count; ++i) {
                separate(i);
                value(pointer + "/" + std::to_string(i), text.size(), depth - 1);
                blanks();
            }
            text += ']';
            break;
        }
        default: {
            text += '{';
            blanks();
            int const count = *rc::gen::inRange(0, 4);
            for (int i = 0; i < count; ++i) {
                separate(i);
                std::size_t const at = text.size();
                std::string const inner = pointer + "/" + key(i);
                blanks();
                text += ':';
                blanks();
                value(inner, at, depth - 1);
                blanks();
            }
            text += '}';
        }
        }
    }
    void separate(int i) {
        if (i > 0) {
            text += ',';
            blanks();
        }
    }
};

TEST(JsonLocator, FindsEveryValueAndKeyWhereItWasWritten) {
    EXPECT_TRUE(rc::check("where the writer put it", [] {
        NotingWriter writer;
        if (*rc::gen::arbitrary<bool>()) {
            writer.text = "\xEF\xBB\xBF"; // a byte order mark
        }
        writer.document();
        RC_ASSERT(nlohmann::json::accept(writer.text));
        for (Noted const& noted : writer.all) {
            RC_ASSERT(locate(writer.text, noted.pointer) == noted.value);
            RC_ASSERT(locate(writer.text, noted.pointer, Spot::key) == noted.key);
            RC_ASSERT(locate(writer.text, noted.pointer, Spot::lastKey) == noted.key);
        }
    }));
}

TEST(JsonLocator, AMissingValueIsAtTheNearestSurroundingValue) {
    std::string const text = R"({"a": [1, {"b": 2}], "c": 3})";
    EXPECT_EQ(locate(text, "/a/1/x"), text.find("{\"b"));
    EXPECT_EQ(locate(text, "/a/1/x/y/z"), text.find("{\"b"));
    EXPECT_EQ(locate(text, "/a/7"), text.find('['));
    EXPECT_EQ(locate(text, "/a/b"), text.find('[')) << "entries of a list have numbers";
    EXPECT_EQ(locate(text, "/a/-"), text.find('['));
    EXPECT_EQ(locate(text, "/c/0"), text.find('3'));
    EXPECT_EQ(locate(text, "/d", Spot::key), 0U);
    EXPECT_EQ(locate(text, "no pointer"), 0U);
}

TEST(JsonLocator, FindsTheFirstOrTheLastOfDuplicateKeys) {
    std::string const text = R"({"a": {"k": 1, "k": 2}, "a": {"k": 3, "k": 4, "\u006b": 5}})";
    EXPECT_EQ(locate(text, "/a/k"), text.find('1'));
    EXPECT_EQ(locate(text, "/a/k", Spot::key), text.find("\"k\": 1"));
    EXPECT_EQ(locate(text, "/a", Spot::lastKey), text.find("\"a\": {\"k\": 3"));
    EXPECT_EQ(locate(text, "/a/k", Spot::lastKey), text.find("\"k\": 2"))
        << "the last key in the first \"a\"";
    EXPECT_EQ(locate(R"({"k": 4, "\u006b": 5})", "/k", Spot::lastKey), 9U);
}

// Also for incomplete texts, a place never lies beyond the end.
TEST(JsonLocator, APlaceInAnIncompleteTextIsNotBeyondItsEnd) {
    std::string const whole = R"({"a": [1, "x\"y", {"b": [[], {}]}], "c\\": "d"})";
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        std::string const part = whole.substr(0, length);
        for (char const* const pointer : {"", "/a", "/a/1", "/a/2/b/1", "/c\\", "/zzz"}) {
            for (Spot const spot : {Spot::value, Spot::key, Spot::lastKey}) {
                TextPlace const place = placeOf(part, locate(part, pointer, spot));
                EXPECT_EQ(place.line, 1U);
                EXPECT_LE(place.column, length + 1) << part << " " << pointer;
            }
        }
    }
}

TEST(JsonLocator, CountsLinesAndCharactersFromOne) {
    std::string const text = "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80z\n\nq";
    std::size_t line = 1;
    std::size_t column = 1;
    for (std::size_t at = 0; at < text.size(); ++at) {
        TextPlace const place = placeOf(text, at);
        if ((static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U) { // the first byte of a character
            EXPECT_EQ(place.line, line) << at;
            EXPECT_EQ(place.column, column) << at;
            ++column;
        }
        if (text[at] == '\n') {
            ++line;
            column = 1;
        }
    }
    EXPECT_EQ(placeOf(text, text.size() + 10).line, 3U) << "at most the end";
    EXPECT_EQ(placeOf(text, text.size() + 10).column, 2U);
    EXPECT_EQ(placeOf("", 5).column, 1U);
}

// Compared with nlohmann::json's own reading of pointers.
TEST(JsonLocator, PointersLeadToTheirKeys) {
    for (std::string const key : {"", "plain", "a/b", "~", "~1", "~0/~1", "//", "0"}) {
        nlohmann::json const object{{"outer", {{key, 7}}}};
        EXPECT_EQ(object.at(nlohmann::json::json_pointer(pointerTo(pointerTo("", "outer"), key))), 7) << key;
    }
    nlohmann::json const list{{"a", {4, 5, 6}}};
    EXPECT_EQ(list.at(nlohmann::json::json_pointer(pointerTo("/a", std::size_t{2}))), 6);
}

} // namespace
} // namespace json_locator_test
} // namespace trembler
