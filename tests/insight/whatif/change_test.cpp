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

} // namespace
} // namespace trembler::insight
