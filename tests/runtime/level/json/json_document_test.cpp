#include "runtime/level/json/json_document.hpp"
#include "runtime/level/json/limits.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler {
namespace {

std::vector<Diagnostic> problemsOf(std::string text) {
    try {
        (void)JsonDocument::parse(std::move(text), "f.json");
        return {};
    } catch (InputError const& error) {
        return error.diagnostics();
    }
}

TEST(JsonDocument, ReportsThePlaceOfSyntaxErrors) {
    auto const problems = problemsOf("{\n  \"a\": 1,\n  \"b\" 2\n}");
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].line, 3U);
    EXPECT_EQ(problems[0].column, 7U);
    EXPECT_NE(problems[0].print().find("f.json:3:7: syntax error"), std::string::npos) << problems[0].print();
}

TEST(JsonDocument, RefusesTextsThatAreNotOneFiniteJsonValue) {
    for (std::string const text : {"", " ", "{", "[1,]", "{} {}", "[1] x", "NaN", "[Infinity]", "[1e999]",
                                   "[-1e999]", "{\"a\": \"\xff\"}", "// c\n1", "{a: 1}", "[01]", "'x'"}) {
        EXPECT_EQ(problemsOf(text).size(), 1U) << text;
    }
}

TEST(JsonDocument, ReportsDuplicateKeysAtTheirSecondPlace) {
    auto const problems = problemsOf("{\"a\": 1,\n \"b\": {\"c\": 1,\n  \"c\": 2},\n \"a\": 3}");
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(problems[0].path, "/b/c");
    EXPECT_EQ(problems[0].line, 3U);
    EXPECT_EQ(problems[0].column, 3U);
    EXPECT_EQ(problems[1].path, "/a");
    EXPECT_EQ(problems[1].line, 4U);
}

TEST(JsonDocument, RefusesDeepNestingWithoutDescending) {
    std::string deep(200000, '[');
    auto const problems = problemsOf(deep);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].column, limits::depth + 1);
    EXPECT_EQ(problems[0].message, "nested too deeply");
    EXPECT_TRUE(problemsOf(std::string(limits::depth, '[') + std::string(limits::depth, ']')).empty());
}

TEST(JsonDocument, DiagnosticsAreOneHarmlessLine) {
    auto const problems = problemsOf("{\"a\\n\\u001b[2J\\u202e\": 1, \"a\\n\\u001b[2J\\u202e\": 2}");
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].print(), "f.json:1:27: /a<U+000A><U+001B>[2J<U+202E>: the key "
                                   "'a<U+000A><U+001B>[2J<U+202E>' is repeated; expected every key once");
}

TEST(JsonDocument, DiagnosticsAreNotAsLongAsTheirFile) {
    std::string const longText(std::size_t{1} << 20U, 'x');
    for (std::string const& text : {"\"" + longText, "{\"" + longText + "\": 1, \"" + longText + "\": 2}"}) {
        auto const problems = problemsOf(text);
        ASSERT_EQ(problems.size(), 1U);
        EXPECT_LT(problems[0].print().size(), 10'000U);
    }
}

TEST(JsonDocument, FilesThatCannotBeReadAreReportedWithTheReason) {
    auto const whyNot = [](char const* file) {
        try {
            (void)JsonDocument::load(file);
            return std::string();
        } catch (InputError const& error) {
            return std::string(error.what());
        }
    };
    EXPECT_EQ(whyNot("/no/such.json"), "/no/such.json: cannot be read: No such file or directory");
    EXPECT_EQ(whyNot("/dev/null/x.json"), "/dev/null/x.json: cannot be read: Not a directory");
    EXPECT_EQ(whyNot("/proc"), "/proc: is a folder; expected a file");
}

TEST(JsonDocument, CountsColumnsInCharacters) {
    auto const document = JsonDocument::parse("{\"ä→\": \"ö\", \"b\": 1}", "f.json");
    EXPECT_EQ(document->diagnostic("/b", "", "").column, 18U);
    EXPECT_EQ(document->diagnostic("/b", "", "", Spot::key).column, 13U);
}

TEST(JsonDocument, MissingValuesArePlacedAtTheSurroundingValue) {
    auto const document = JsonDocument::parse("[1,\n {\"x\": [5, 6]}]", "f.json");
    EXPECT_EQ(document->diagnostic("/1/x/7", "", "").column, 8U);
    EXPECT_EQ(document->diagnostic("/1/nothing/here", "", "").column, 2U);
    EXPECT_EQ(document->diagnostic("/9", "", "").column, 1U);
}

TEST(JsonDocument, ReportsMissingFilesAndFolders) {
    EXPECT_THROW((void)JsonDocument::load("/nowhere/at/all.json"), InputError);
    EXPECT_THROW((void)JsonDocument::load("/"), InputError);
}

nlohmann::json anyJson(int depth) {
    int const kind = *rc::gen::inRange(0, depth > 0 ? 7 : 5);
    switch (kind) {
    case 0:
        return nullptr;
    case 1:
        return *rc::gen::arbitrary<bool>();
    case 2:
        return *rc::gen::arbitrary<int>();
    case 3:
        return *rc::gen::element<std::string>("", "plain", "with \"quotes\"", "]}{[", "back\\slash", "\n\t",
                                              "ä→€");
    case 4:
        return *rc::gen::map(rc::gen::arbitrary<int>(), [](int i) { return i / 7.0; });
    case 5: {
        nlohmann::json list = nlohmann::json::array();
        for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
            list.push_back(anyJson(depth - 1));
        }
        return list;
    }
    default: {
        nlohmann::json object = nlohmann::json::object();
        for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
            object[*rc::gen::element<std::string>("a", "b/c", "~", "\"", "long key", "é", "")] =
                anyJson(depth - 1);
        }
        return object;
    }
    }
}

/// Every value, found through its pointer in the text, must parse to itself.
void checkPlaces(std::string const& text, nlohmann::json const& value, std::string const& path) {
    std::size_t const at = locate(text, path);
    std::string const token = value.dump();
    if (value.is_primitive()) {
        RC_ASSERT(text.substr(at, token.size()) == token);
    } else {
        RC_ASSERT(text[at] == token[0]);
    }
    if (value.is_object()) {
        for (auto const& [key, member] : value.items()) {
            std::string const inner = pointerTo(path, key);
            std::string const keyToken = nlohmann::json(key).dump();
            RC_ASSERT(text.substr(locate(text, inner, Spot::key), keyToken.size()) == keyToken);
            checkPlaces(text, member, inner);
        }
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            checkPlaces(text, value[i], pointerTo(path, i));
        }
    }
}

TEST(JsonDocument, ReadsAndFindsAnyValue) {
    EXPECT_TRUE(rc::check("every value of any document is read as it is and found by its pointer", [] {
        nlohmann::json const value = anyJson(4);
        std::string const text = value.dump(*rc::gen::inRange(-1, 3));
        auto const document = JsonDocument::parse(text, "f.json");
        RC_ASSERT(document->root() == value);
        checkPlaces(text, value, "");
    }));
}

} // namespace
} // namespace trembler
