#include "puzzle/goals/conditions/table.hpp"
#include "puzzle/goals/reading/condition_outline.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace trembler {
namespace condition_outline_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(ConditionOutline, SaysHowEachKindContainsConditions) {
    ASSERT_EQ(conditionOutlines().size(), conditionKinds().size());
    for (char const* const key : {"all", "any", "sequence"}) {
        EXPECT_EQ(findOutline(key)->inner, InnerConditions::list) << key;
    }
    EXPECT_EQ(findOutline("not")->inner, InnerConditions::value);
    EXPECT_EQ(findOutline("count")->inner, InnerConditions::member);
    EXPECT_EQ(findOutline("count")->member, "that");
    for (char const* const key : {"inside", "touching", "on", "off", "moved"}) {
        EXPECT_EQ(findOutline(key)->inner, InnerConditions::none) << key;
    }
    for (char const* const key : {"", "for", "id", "text", "that", "object"}) {
        EXPECT_EQ(findOutline(key), nullptr) << key;
    }
}

TEST(ConditionOutline, FindsAllSelectors) {
    Json goals = Json::parse(R"({"id": "a", "text": "b", "for": 2, "all": [
        {"inside": {"object": "c", "area": [0, 0, 1, 1], "called": "d"}},
        {"touching": ["e", ["f", {"part": "g"}]]},
        {"not": {"on": ["h"]}},
        {"sequence": [{"off": "i"}, {"moved": {"object": "j", "by": 1, "towards": "up"}}]},
        {"count": {"of": {"part": "k"}, "at_least": 1, "that": {"any": [{"on": "it"}]}}}]})");
    std::vector<std::string> found;
    forSelectors(goals, [&](Json& selector) {
        found.push_back(selector.dump());
        selector = "changed";
    });
    EXPECT_EQ(found, (std::vector<std::string>{"\"c\"", "\"e\"", R"(["f",{"part":"g"}])", R"(["h"])", "\"i\"",
                                               "\"j\"", R"({"part":"k"})", "\"it\""}));
    EXPECT_EQ(goals["all"][1], Json::parse(R"({"touching": ["changed", "changed"]})"));
    EXPECT_EQ(goals["all"][0]["inside"]["called"], "d");
}

TEST(ConditionOutline, LeavesOutWhatHasAnotherForm) {
    int found = 0;
    for (char const* const text : {"3", "[]", R"({"all": 3})", R"({"all": [3, "x"]})", R"({"not": "x"})",
                                   R"({"inside": "x"})", R"({"touching": "x"})", R"({"surprise": "x"})"}) {
        Json goals = Json::parse(text);
        forSelectors(goals, [&](Json&) { ++found; });
    }
    EXPECT_EQ(found, 0);
}

TEST(ConditionOutline, FindsTheConditionAroundAPlace) {
    Json const goals = Json::parse(R"({"all": [{"on": "a"},
        {"not": {"count": {"of": ["b"], "at_least": 1, "that": {"inside": {"object": "it"}}}}}]})");
    auto const around = [&](char const* place) { return conditionAround(goals, place); };
    EXPECT_EQ(around(""), "");
    EXPECT_EQ(around("/all"), "");
    EXPECT_EQ(around("/all/0"), "/all/0");
    EXPECT_EQ(around("/all/0/on"), "/all/0");
    EXPECT_EQ(around("/all/1/not/count/of/0"), "/all/1/not");
    EXPECT_EQ(around("/all/1/not/count/at_least"), "/all/1/not");
    EXPECT_EQ(around("/all/1/not/count/that/inside/object"), "/all/1/not/count/that");
    EXPECT_EQ(around("/all/7/on"), "") << "there is none";
    EXPECT_EQ(around("/any/0"), "");
    EXPECT_EQ(around("/surprise"), "");
}

} // namespace
} // namespace condition_outline_test
} // namespace trembler
