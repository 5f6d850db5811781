// The checked reads of one value: the accepted values, and the messages for all others.
#include "runtime/level/json/json_node.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <limits>

namespace trembler {
namespace json_node_test {
namespace {

/// A document, its root, and the reported problems.
struct Text {
    explicit Text(std::string const& text)
        : document(JsonDocument::parse(text, "f.json")),
          root(*document, document->root(), std::string(), problems) {}
    std::vector<std::string> said() const {
        std::vector<std::string> lines;
        try {
            problems.throwIfAny();
        } catch (InputError const& error) {
            for (Diagnostic const& one : error.diagnostics()) {
                lines.push_back(one.print());
            }
        }
        return lines;
    }
    std::string only() const {
        auto const lines = said();
        return lines.size() == 1 ? lines[0] : std::to_string(lines.size()) + " problems";
    }

    std::shared_ptr<JsonDocument const> document;
    Problems problems;
    JsonNode root;
};

std::string const everyType = R"([null, true, 7, 1.5, "text", [1], {"a": 1}])";

TEST(JsonNode, EachReadTakesOneTypeAndReportsOthersWithTheirPlace) {
    struct Read {
        std::vector<std::size_t> takes; ///< elements of the list of all types
        bool (*works)(JsonNode const&);
    };
    std::vector<Read> const reads{
        {{1}, [](JsonNode const& n) { return n.boolean().has_value(); }},
        {{4}, [](JsonNode const& n) { return n.text().has_value(); }},
        {{4}, [](JsonNode const& n) { return n.name("a name").has_value(); }},
        {{2, 3}, [](JsonNode const& n) { return n.number(-100, 100).has_value(); }},
        {{2}, [](JsonNode const& n) { return n.integer(-100, 100).has_value(); }},
        {{}, [](JsonNode const& n) { return n.vector(-100, 100).has_value(); }},
        {{5}, [](JsonNode const& n) { return n.isArray("a list"); }},
        {{5}, [](JsonNode const& n) { return n.isList("a list", 1); }},
        {{6}, [](JsonNode const& n) { return n.isObject("an object"); }},
    };
    for (std::size_t r = 0; r < reads.size(); ++r) {
        for (std::size_t i = 0; i < 7; ++i) {
            Text const text(everyType);
            bool const wanted =
                std::find(reads[r].takes.begin(), reads[r].takes.end(), i) != reads[r].takes.end();
            EXPECT_EQ(reads[r].works(text.root.element(i)), wanted) << r << " " << i;
            EXPECT_EQ(text.problems.count(), wanted ? 0U : 1U) << r << " " << i;
            if (!wanted) {
                EXPECT_NE(text.only().find(": /" + std::to_string(i) + ": is "), std::string::npos)
                    << text.only();
            }
        }
    }
}

TEST(JsonNode, NumbersAreTakenWithinTheirRangeEndsIncluded) {
    EXPECT_TRUE(rc::check("a number is taken if and only if it is in range", [] {
        double const low = *rc::gen::inRange(-50, 50) / 4.0;
        double const high = low + *rc::gen::inRange(0, 50) / 4.0;
        double const number = *rc::gen::element(low, high, std::nextafter(low, -HUGE_VAL),
                                                std::nextafter(high, HUGE_VAL), (low + high) / 2, -0.0);
        Text const text("[" + shown(number) + "]");
        auto const read = text.root.element(0).number(low, high);
        RC_ASSERT(read.has_value() == (number >= low && number <= high));
        RC_ASSERT(!read || *read == number);
        RC_ASSERT(text.problems.empty() == read.has_value());
    }));
    constexpr double all = std::numeric_limits<double>::max();
    struct Range {
        double low;
        double high;
        char const* says;
    };
    for (Range const& range :
         {Range{-all, all, "a number"}, Range{2, all, "a number of at least 2"},
          Range{-all, 0.1, "a number of at most 0.1"}, Range{0.25, 1e6, "a number from 0.25 to 1000000"}}) {
        Text const text("\n  \"x\"");
        EXPECT_FALSE(text.root.number(range.low, range.high));
        EXPECT_EQ(text.only(), std::string("f.json:2:3: is \"x\"; expected ") + range.says);
    }
}

TEST(JsonNode, WholeNumbersMayBeWrittenInAnyWayIfADoubleIsExact) {
    struct Case {
        char const* text;
        std::optional<std::int64_t> value;
    };
    constexpr std::int64_t exact = std::int64_t{1} << 53U;
    for (Case const& c :
         {Case{"3", 3}, Case{"3.0", 3}, Case{"3e2", 300}, Case{"-0.0", 0}, Case{"3.5", std::nullopt},
          Case{"1e-9", std::nullopt}, Case{"9007199254740992", exact}, Case{"-9007199254740992", -exact},
          Case{"9007199254740994", std::nullopt}, Case{"1e300", std::nullopt}, Case{"\"3\"", std::nullopt},
          Case{"18446744073709551615", std::nullopt}, Case{"-9223372036854775808", std::nullopt}}) {
        Text const text(c.text);
        EXPECT_EQ(text.root.integer(std::numeric_limits<std::int64_t>::min(),
                                    std::numeric_limits<std::int64_t>::max()),
                  c.value)
            << c.text;
        EXPECT_EQ(text.problems.count(), c.value ? 0U : 1U) << c.text;
    }
    Text const text("[0, 1, 5, 6]");
    EXPECT_FALSE(text.root.element(0).integer(1, 5));
    EXPECT_EQ(text.root.element(1).integer(1, 5), 1);
    EXPECT_EQ(text.root.element(2).integer(1, 5), 5);
    EXPECT_FALSE(text.root.element(3).integer(1, 5));
    EXPECT_EQ(text.said()[1], "f.json:1:11: /3: is 6; expected a whole number from 1 to 5");
}

TEST(JsonNode, VectorsReportTheWrongCoordinate) {
    Text const text("[[1, 2], [1], [1, 2, 3], [1, \"y\"], [11, -11]]");
    EXPECT_EQ(text.root.element(0).vector(-10, 10), (Vec2{1, 2}));
    for (std::size_t i = 1; i < 5; ++i) {
        EXPECT_FALSE(text.root.element(i).vector(-10, 10)) << i;
    }
    EXPECT_EQ(text.said(), (std::vector<std::string>{
                               "f.json:1:10: /1: is a list of 1; expected a list [x, y] of two numbers",
                               "f.json:1:15: /2: is a list of 3; expected a list [x, y] of two numbers",
                               "f.json:1:30: /3/1: is \"y\"; expected a number from -10 to 10",
                               "f.json:1:37: /4/0: is 11; expected a number from -10 to 10",
                               "f.json:1:41: /4/1: is -11; expected a number from -10 to 10"}));
}

TEST(JsonNode, ChoicesAreNumberedAndMisspeltOnesGetASuggestion) {
    std::array<std::string_view, 3> const names{"circle", "box", "capsule"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        Text const text("\"" + std::string(names[i]) + "\"");
        EXPECT_EQ(text.root.choice(names), i);
        EXPECT_TRUE(text.problems.empty());
    }
    Text const misspelt("\"cirlce\"");
    EXPECT_FALSE(misspelt.root.choice(names));
    EXPECT_EQ(misspelt.only(), "f.json:1:1: is \"cirlce\" (did you mean 'circle'?); expected 'circle', 'box' "
                               "or 'capsule'");
    Text const number("1");
    EXPECT_FALSE(number.root.choice(names)) << "a file states a choice by name, not by number";
}

TEST(JsonNode, NamesAreOneLineOfOneToAHundredBytes) {
    auto const taken = [](std::string const& name) {
        Text const text(nlohmann::json(name).dump());
        auto const read = text.root.name("a name");
        EXPECT_EQ(text.problems.empty(), read.has_value());
        return read == name;
    };
    EXPECT_TRUE(taken("a"));
    EXPECT_TRUE(taken("two words"));
    EXPECT_TRUE(taken(std::string(100, 'x')));
    EXPECT_TRUE(taken("\xC3\xA9t\xC3\xA9"));
    for (std::string const& bad : {std::string(), std::string(101, 'x'), std::string(" a"), std::string("a "),
                                   std::string("a\nb"), std::string("a\x7f"), std::string("a\0b", 3)}) {
        EXPECT_FALSE(taken(bad)) << bad;
    }
}

TEST(JsonNode, LongTextsAreCutBetweenCharacters) {
    for (int pad = 0; pad < 4; ++pad) {
        std::string accents(static_cast<std::size_t>(pad), 'x');
        for (int i = 0; i < 60; ++i) {
            accents += "\xC3\xA9";
        }
        Text const text("\"" + accents + "\"");
        EXPECT_FALSE(text.root.boolean());
        std::string const said = text.only();
        EXPECT_NE(said.find("\xC3\xA9...; expected true or false"), std::string::npos) << said;
        EXPECT_LT(said.size(), 120U);
        EXPECT_EQ(said.find('<'), std::string::npos) << "an incomplete character would be shown as a byte";
    }
}

TEST(JsonNode, ListsThatAreTooLongAreRefused) {
    Text const text("[1, 2, 3]");
    EXPECT_TRUE(text.root.isList("a list", 3));
    EXPECT_FALSE(text.root.isList("a list", 2));
    EXPECT_EQ(text.only(), "f.json:1:1: has 3 entries; expected at most 2");
}

TEST(MemberReader, ReportsMissingAndUnknownMembers) {
    Text const text(R"({"mass": 2, "densty": 1, "read elsewhere": 0, "": 3})");
    MemberReader reader(text.root, "an object");
    ASSERT_TRUE(reader.valid());
    auto const mass = reader.required("mass", "a number");
    ASSERT_TRUE(mass);
    EXPECT_EQ(mass->path(), "/mass");
    EXPECT_EQ(mass->number(0, 9), 2);
    EXPECT_FALSE(reader.optional("density"));
    EXPECT_FALSE(reader.required("at", "a place"));
    reader.know("read elsewhere");
    reader.finish();
    EXPECT_EQ(text.said(), (std::vector<std::string>{
                               "f.json:1:1: 'at' is missing; expected a place",
                               "f.json:1:13: /densty: unknown key 'densty' (did you mean 'density'?); "
                               "expected 'at', 'density', 'mass' or 'read elsewhere'",
                               "f.json:1:47: /: unknown key ''; expected 'at', 'density', 'mass' or 'read "
                               "elsewhere'"}));
}

TEST(MemberReader, ReportsOnceThatAValueIsNotAnObject) {
    Text const text("[1]");
    MemberReader reader(text.root, "a part");
    EXPECT_FALSE(reader.valid());
    EXPECT_FALSE(reader.required("a", "anything"));
    EXPECT_FALSE(reader.optional("b"));
    reader.finish();
    EXPECT_EQ(text.only(), "f.json:1:1: is a list of 1; expected a part");
}

TEST(JsonNode, ShownNumbersAreTheShortestThatReadBack) {
    EXPECT_TRUE(rc::check("reads back as the same double", [] {
        double const number = *rc::gen::arbitrary<double>();
        RC_PRE(std::isfinite(number));
        RC_ASSERT(std::stod(shown(number)) == number);
    }));
    EXPECT_EQ(shown(0.1), "0.1");
    EXPECT_EQ(shown(2), "2");
}

} // namespace
} // namespace json_node_test
} // namespace trembler
