// Goals that cannot be reached are rejected with their place. The reasons are tested for each kind, in
// conditions/.
#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

TEST(NeverHolds, IsFoundInsideOtherConditions) {
    EXPECT_TRUE(isRefused(R"({"all": [{"on": "lamp"}, {"not": {"touching": ["crate", "crate"]}}]})",
                          "/goals/all/1/not: can never hold: nothing touches itself; "
                          "expected two different objects"));
    EXPECT_TRUE(isRefused(R"({"count": {"of": "crate", "at_least": 1,
                              "that": {"any": [{"moved": {"object": "floor", "by": 1}}]}}})",
                          "/goals/count/that/any/0: can never hold"));
}

TEST(NeverHolds, IsReportedForEveryCondition) {
    std::string const refusal = refusalOf(R"({"all": [{"moved": {"object": "floor", "by": 1}},
        {"touching": ["crate", "crate"]}, {"moved": {"object": "floor", "by": 2}}]})");
    for (char const* const place : {"/goals/all/0:", "/goals/all/1:", "/goals/all/2:"}) {
        EXPECT_NE(refusal.find(place), std::string::npos) << refusal;
    }
}

} // namespace
} // namespace trembler
