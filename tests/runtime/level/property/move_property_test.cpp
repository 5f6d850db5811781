// Properties that are turned, shifted and mirrored by their descriptions alone.
#include "runtime/level/property/move_property.hpp"
#include "runtime/level/property/property_writer.hpp"
#include "runtime/placement.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>

namespace trembler {
namespace move_property_test {
namespace {

constexpr PieceFrame mirror{{}, 0, true};

/// One field of every kind.
struct Everything {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Everything", "test_everything", "One field of every geometry."};
    Vec2 own{1, 2};
    std::vector<Vec2> outline{{0, 0}, {2, 0}, {1, 3}};
    double turn = 0.5;
    double lower = -0.25;
    double upper = 1;
    Vec2 place{3, 4};
    Vec2 way{1, 0};
    Vec2 axis{1, 0};
    double heading = 0.125;
    Vec2 same{5, 6};
    double plain = 7;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        using enum FieldGeometry;
        auto const field = [&](std::string_view key, auto& value, FieldGeometry geometry) {
            visit(FieldInfo{.key = key, .unit = "", .meaning = "for tests", .geometry = geometry}, value);
        };
        field("own", self.own, ownVector);
        field("outline", self.outline, ownOutline);
        field("turn", self.turn, turning);
        field("lower", self.lower, turningLower);
        field("upper", self.upper, turningUpper);
        field("place", self.place, worldPoint);
        field("way", self.way, worldVector);
        field("axis", self.axis, worldAxis);
        field("heading", self.heading, FieldGeometry::heading);
        field("same", self.same, invariant);
        field("plain", self.plain, unstated);
    }
};

Everything moved(PieceFrame const& outer, bool mirrored, Everything const& from = {}) {
    ValueOf<Everything> value(from);
    moveProperty(value, outer, mirrored);
    return value.value;
}

bool sameBits(Everything const& a, Everything const& b) {
    auto const text = [](Everything const& everything) {
        return writeProperty(ValueOf<Everything>(everything)).dump();
    };
    return text(a) == text(b);
}

TEST(MoveProperty, AnObjectIsMirroredInItsOwnFrame) {
    Everything const image = moved({}, true);
    EXPECT_EQ(image.own, (Vec2{-1, 2}));
    EXPECT_EQ(image.outline, (std::vector<Vec2>{{0, 0}, {-1, 3}, {-2, 0}})) << "still anticlockwise";
    EXPECT_EQ(image.turn, -0.5);
    EXPECT_EQ(image.lower, -1);
    EXPECT_EQ(image.upper, 0.25);
    EXPECT_EQ(image.place, (Vec2{3, 4})) << "it stays where it is";
    EXPECT_EQ(image.heading, 0.125);
    EXPECT_EQ(image.way, (Vec2{-1, 0}));
    EXPECT_EQ(image.axis, (Vec2{1, 0})) << "mirrored and reversed";
    EXPECT_EQ(image.same, (Vec2{5, 6}));
    EXPECT_EQ(image.plain, 7);
}

TEST(MoveProperty, APieceMovesWithItsComposite) {
    Everything const turned = moved({{10, 20}, pi / 2, false}, false);
    EXPECT_EQ(turned.own, (Vec2{1, 2}));
    EXPECT_EQ(turned.turn, 0.5);
    EXPECT_NEAR(turned.place.x, 6, 1e-12);
    EXPECT_NEAR(turned.place.y, 23, 1e-12);
    EXPECT_NEAR(turned.way.y, 1, 1e-12);
    EXPECT_NEAR(turned.axis.y, 1, 1e-12);
    EXPECT_DOUBLE_EQ(turned.heading, 0.125 + pi / 2);
}

TEST(MoveProperty, APieceOfAMirroredCompositeIsMirroredToo) {
    Everything const image = moved(mirror, false);
    EXPECT_EQ(image.own, (Vec2{-1, 2}));
    EXPECT_EQ(image.place, (Vec2{-3, 4}));
    EXPECT_EQ(image.heading, -0.125);
    EXPECT_EQ(image.way, (Vec2{-1, 0}));
    Everything const twice = moved(mirror, true);
    EXPECT_EQ(twice.own, (Vec2{1, 2})) << "a mirrored piece of a mirrored composite";
    EXPECT_EQ(twice.place, (Vec2{-3, 4}));
    EXPECT_EQ(twice.turn, 0.5);
}

TEST(MoveProperty, TheSignOfZeroStays) {
    Everything zero;
    zero.own = {0, 1};
    zero.turn = 0;
    zero.lower = zero.upper = 0;
    Everything const image = moved({}, true, zero);
    EXPECT_TRUE(sameBits(image, [&] {
        Everything expected = moved({}, true);
        expected.own = {0, 1};
        expected.turn = expected.lower = expected.upper = 0;
        return expected;
    }()));
}

TEST(MoveProperty, MirroredTwiceItIsTheSameToTheLastBit) {
    EXPECT_TRUE(rc::check("random numbers", [] {
        auto const number = [] { return *rc::gen::inRange(-1000000, 1000001) / 977.0; };
        Everything any;
        any.own = {number(), number()};
        any.outline.clear();
        for (int corners = *rc::gen::inRange(0, 9); corners > 0; --corners) {
            any.outline.push_back({number(), number()});
        }
        any.turn = number();
        any.lower = number();
        any.upper = number();
        any.way = {number(), number()};
        any.axis = {number(), number()};
        any.place = {number(), number()};
        RC_ASSERT(sameBits(moved({}, true, moved({}, true, any)), any));
        RC_ASSERT(sameBits(moved(mirror, false, moved(mirror, false, any)), any));
    }));
}

TEST(MoveProperty, ListsOfStructsAreMoved) {
    sample::Cake cake;
    cake.toppings.resize(2);
    cake.toppings[1].turn = 0.25;
    cake.toppings[1].spots = {{1, 0}, {0, 1}, {-2, 0}};
    ValueOf<sample::Cake> value(cake);
    moveProperty(value, {}, true);
    EXPECT_EQ(value.value.middle, (Vec2{-1, 2}));
    EXPECT_EQ(value.value.toppings[1].turn, -0.25);
    EXPECT_EQ(value.value.toppings[1].spots, (std::vector<Vec2>{{-1, 0}, {2, 0}, {0, 1}}));
}

TEST(PieceFrame, OfAFrameInsideAnother) {
    EXPECT_TRUE(rc::check("random numbers", [] {
        auto const number = [] { return *rc::gen::inRange(-1000, 1001) / 97.0; };
        auto const any = [&] {
            return PieceFrame{{number(), number()}, number(), *rc::gen::arbitrary<bool>()};
        };
        PieceFrame const outer = any();
        PieceFrame const inner = any();
        Vec2 const point{number(), number()};
        Vec2 const direct = outer.of(inner).point(point);
        Vec2 const inSteps = outer.point(inner.point(point));
        RC_ASSERT(length(direct - inSteps) < 1e-9);
        RC_ASSERT(std::abs(outer.of(inner).heading(0.5) - outer.heading(inner.heading(0.5))) < 1e-9);
    }));
}

} // namespace
} // namespace move_property_test
} // namespace trembler
