// Placed parts keep their identity when another one of their kind is left out.
#include "insight/run/placed_names.hpp"
#include "insight/run/reduced_level.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace placed_names {
namespace {

Placement at(std::string const& part, double x) {
    Placement placement;
    placement.part = part;
    placement.at = {x, 1};
    return placement;
}

/// Stated from right to left; names are numbered from left to right.
std::vector<Placement> const corks{at("cork", 3), at("cork", 2), at("crate", 0), at("cork", 1)};

TEST(PlacedNames, FollowTheNumbersOfTheOthers) {
    PlacedNames const names(firstContact().level(), corks, {1}); // that was "cork 2"
    EXPECT_EQ(names.inReduced("cork 1"), "cork 1");
    EXPECT_EQ(names.inReduced("cork 3"), "cork 2");
    EXPECT_EQ(names.inReduced("cork 3 left end"), "cork 2 left end");
    EXPECT_EQ(names.inReduced("crate 1"), "crate 1");
    EXPECT_EQ(names.inWhole("cork 2"), "cork 3");
    EXPECT_EQ(names.inWhole("cork 2 left end"), "cork 3 left end");
    EXPECT_EQ(names.inWhole("cork 1"), "cork 1");
    EXPECT_TRUE(names.isGone("cork 2"));
    EXPECT_FALSE(names.isGone("cork 3"));
    EXPECT_NE(names.inReduced("cork 2"), "cork 2") << "that is another object now";
    EXPECT_TRUE(PlacedNames().empty());
    EXPECT_EQ(PlacedNames().inWhole("cork 2"), "cork 2");
}

TEST(PlacedNames, WiresAndInputsOfAReducedSolutionNameTheSameObjects) {
    Solution solution;
    solution.placements = corks;
    solution.wires = {{"cork 1", "left contact", "", "wire"}, {"cork 3", "cork 2", "", "wire"}};
    solution.inputs = {{1, PlayerInput::Kind::grab, "cork 3", "", {}, "", 0},
                       {2, PlayerInput::Kind::grab, "cork 1", "", {}, "", 1}};
    Solution const left = reducedSolution(firstContact().level(), solution, {withoutPlacement(3)});
    ASSERT_EQ(left.placements.size(), 3U);
    ASSERT_EQ(left.wires.size(), 1U) << "the wire to it goes with it";
    EXPECT_EQ(left.wires.front().a, "cork 2");
    EXPECT_EQ(left.wires.front().b, "cork 1");
    EXPECT_EQ(left.inputs[0].object, "cork 2");
    EXPECT_EQ(firstContact().level().findObject(left.inputs[1].object), nullptr) << "nobody is grabbed";
    EXPECT_NE(left.inputs[1].object, "cork 1");
}

} // namespace
} // namespace placed_names
} // namespace trembler::insight
