#include "insight/whatif/apply.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace {

TEST(WhatIfChanges, ALaterOneOfTheSameThingReplacesTheEarlier) {
    WhatIf what{10, {}};
    what.add({.kind = Change::Kind::place, .object = "ball", .at = {1, 2}});
    what.add({.kind = Change::Kind::place, .object = "ball", .at = {3, 4}});
    what.add({.kind = Change::Kind::field, .object = "ball", .property = "mass", .field = "value"});
    what.add({.kind = Change::Kind::field, .object = "ball", .property = "friction", .field = "value"});
    what.add({.kind = Change::Kind::cut, .object = "a", .other = "b"});
    what.add({.kind = Change::Kind::cut, .object = "a", .other = "c"});
    ASSERT_EQ(what.changes.size(), 5U);
    EXPECT_EQ(what.changes.front().at, (Vec2{3, 4}));
    what.add({.kind = Change::Kind::remove, .object = "ball"});
    EXPECT_EQ(what.changes.size(), 3U);
}

TEST(WhatIfChanges, WithoutAGrabNeitherItsMovesNorItsReleaseCome) {
    std::vector<RecordedInput> inputs(7);
    using Kind = PlayerInput::Kind;
    Kind const kinds[] = {Kind::grab, Kind::move, Kind::release, Kind::grab,
                          Kind::move, Kind::cut,  Kind::release};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        inputs[i].kind = kinds[i];
        inputs[i].frame = 10 * (i + 1);
    }
    WhatIf const what{15, {{.kind = Change::Kind::input, .index = 3}}};
    std::vector<RecordedInput> const left = inputsLeft(inputs, what);
    ASSERT_EQ(left.size(), 4U);
    EXPECT_EQ(left.back().kind, Kind::cut);
    WhatIf const past{45, {{.kind = Change::Kind::input, .index = 3}}};
    EXPECT_EQ(inputsLeft(inputs, past).size(), inputs.size()) << "it has come already";
}

RecordedInput ofHand(PlayerInput::Kind kind, std::uint64_t frame, int hand) {
    RecordedInput input;
    input.kind = kind;
    input.frame = frame;
    input.hand = hand;
    return input;
}

// No other input uses the hand of a what-if's grab while it lasts.
TEST(WhatIfChanges, AGrabHasAHandForItself) {
    using Kind = PlayerInput::Kind;
    WhatIf const what{20, {{.kind = Change::Kind::grab, .object = "ball", .frames = 30}}};
    EXPECT_EQ(handOfGrab({}, what), 1);
    std::vector<RecordedInput> const second{ofHand(Kind::grab, 5, 1), ofHand(Kind::move, 15, 1),
                                            ofHand(Kind::release, 40, 1)};
    EXPECT_EQ(handOfGrab(second, what), 0) << "it holds something";
    EXPECT_EQ(inputsLeft(second, what, 0).size(), second.size());
    std::vector<RecordedInput> const before{ofHand(Kind::grab, 5, 1), ofHand(Kind::release, 20, 1)};
    EXPECT_EQ(handOfGrab(before, what), 1) << "it has let go";
    std::vector<RecordedInput> const later{ofHand(Kind::grab, 30, 1), ofHand(Kind::release, 35, 1)};
    EXPECT_EQ(handOfGrab(later, what), 0) << "it will hold something";
    std::vector<RecordedInput> const afterwards{ofHand(Kind::grab, 60, 1)};
    EXPECT_EQ(handOfGrab(afterwards, what), 1);
    std::vector<RecordedInput> const first{ofHand(Kind::grab, 5, 0), ofHand(Kind::grab, 30, 1)};
    EXPECT_EQ(handOfGrab(first, what), 1) << "the one that is empty at the moment";
    for (RecordedInput const& own : inputsOfGrabs(what, 0)) {
        EXPECT_EQ(own.hand, 0);
    }
}

// Of two hands that are both busy the second one lets go, until it grabs something later.
TEST(WhatIfChanges, AGrabTakesTheSecondHandIfBothAreBusy) {
    using Kind = PlayerInput::Kind;
    WhatIf const what{20, {{.kind = Change::Kind::grab, .object = "ball", .frames = 30}}};
    std::vector<RecordedInput> const both{
        ofHand(Kind::grab, 2, 0),  ofHand(Kind::grab, 3, 1),     ofHand(Kind::move, 25, 0),
        ofHand(Kind::move, 25, 1), ofHand(Kind::release, 30, 1), ofHand(Kind::grab, 40, 1),
        ofHand(Kind::move, 60, 1), ofHand(Kind::grab, 70, 1),    ofHand(Kind::release, 80, 1)};
    ASSERT_EQ(handOfGrab(both, what), 1);
    std::vector<RecordedInput> const left = inputsLeft(both, what, 1);
    std::vector<std::uint64_t> frames;
    for (RecordedInput const& input : left) {
        frames.push_back(input.frame);
    }
    EXPECT_EQ(frames, (std::vector<std::uint64_t>{2, 3, 25, 70, 80}));
}

} // namespace
} // namespace trembler::insight
