#include "insight/kind/kind_difference.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace {

TEST(KindDifference, IsWhatOnlyOneOfTwoGraphsHas) {
    CauseGraph const lever{true, {"lever", "stone ball"}, {}, {{"Dynamics", "Goals"}}};
    CauseGraph const fuse{true, {"lever"}, {"grab"}, {{"Dynamics", "Goals"}, {"Electricity", "Dynamics"}}};
    KindDifference const found = differenceOf(lever, fuse);
    EXPECT_EQ(found.here.parts, std::vector<std::string>{"stone ball"});
    EXPECT_TRUE(found.here.deeds.empty());
    EXPECT_TRUE(found.here.links.empty());
    EXPECT_TRUE(found.there.parts.empty());
    EXPECT_EQ(found.size(), 3U);
    EXPECT_EQ(inWords(found.here), "stone ball");
    EXPECT_EQ(inWords(found.there), "grab; Electricity leads to Dynamics");
    EXPECT_EQ(differenceOf(lever, lever).size(), 0U);
    EXPECT_EQ(inWords(differenceOf(lever, lever).here), "");
}

} // namespace
} // namespace trembler::insight
