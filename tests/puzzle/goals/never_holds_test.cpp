// Goals that nothing can reach are refused where they stand.
#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

#define EXPECT_NEVER(goals, why) EXPECT_PRED_FORMAT2(testing::IsSubstring, why, refusalOf(goals))
#define EXPECT_FINE(goals) EXPECT_EQ(refusalOf(goals), "")

TEST(NeverHolds, NothingTouchesItself) {
    EXPECT_NEVER(R"({"touching": ["crate", "crate"]})", "/goals: can never hold: nothing touches itself");
    EXPECT_NEVER(R"({"touching": [["crate"], ["crate", "crate"]]})", "nothing touches itself");
    EXPECT_NEVER(R"({"all": [{"on": "lamp"}, {"not": {"touching": ["crate", "crate"]}}]})",
                 "/goals/all/1/not:");
    EXPECT_FINE(R"({"touching": [["crate", "floor"], "crate"]})");
    EXPECT_FINE(R"({"touching": [{"part": "iron ball"}, {"part": "iron ball"}]})");
    EXPECT_NEVER(
        R"({"count": {"of": ["crate", "floor"], "at_least": 1, "that": {"touching": ["it", "it"]}}})",
        "nothing touches itself");
    EXPECT_FINE(
        R"({"count": {"of": ["crate", "floor"], "at_least": 1, "that": {"touching": ["it", "crate"]}}})");
}

TEST(NeverHolds, WhatIsFixedStaysWhereItIs) {
    EXPECT_NEVER(R"({"moved": {"object": "floor", "by": 1}})", "what is fixed never moves");
    EXPECT_NEVER(R"({"moved": {"object": ["floor", "electromagnet"], "by": 1}})",
                 "what is fixed never moves");
    EXPECT_FINE(R"({"moved": {"object": ["floor", "crate"], "by": 1}})");
    EXPECT_NEVER(R"({"inside": {"object": "floor", "area": [5, 5, 1, 1]}})",
                 "what is fixed never gets there");
    EXPECT_FINE(R"({"inside": {"object": "floor", "area": [-1, -2, 2, 2]}})") << "it is there";
}

TEST(NeverHolds, NoMoreThanThereCanBe) {
    std::string const that = R"(, "that": {"moved": {"object": "it", "by": 1}}}})";
    EXPECT_NEVER(R"({"count": {"of": "crate", "at_least": 3)" + that, "wants 3 of what there can be 1 of");
    EXPECT_NEVER(R"({"count": {"of": ["crate", "crate", "object 1"], "exactly": 3)" + that,
                 "there can be 2 of");
    EXPECT_NEVER(R"({"count": {"of": {"part": "iron ball"}, "at_least": 3)" + that, "there can be 2 of");
    EXPECT_FINE(R"({"count": {"of": {"part": "iron ball"}, "at_least": 2)" + that);
    EXPECT_FINE(R"({"count": {"of": "crate", "at_most": 3)" + that);
}

TEST(NeverHolds, NothingIsInsideAFlatArea) {
    for (char const* const corners : {"[[0, 0], [1, 1], [2, 2]]", "[[0, 0], [0, 0], [0, 0]]",
                                      "[[0, 0], [5, 0.0001], [9, 0]]", "[[0, 0], [3, 0], [1, 0], [2, 0]]"}) {
        EXPECT_NEVER(R"({"inside": {"object": "crate", "area": )" + std::string(corners) + "}}", "is flat");
    }
    EXPECT_FINE(R"({"inside": {"object": "crate", "area": [[0, 0], [2, 0], [0, 2], [2, 2]]}})")
        << "a bow tie";
}

} // namespace
} // namespace trembler
