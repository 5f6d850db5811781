// Contacts by a tree and Box2D's routines, against the gaps of all pairs by every corner and side.
#include "physics/dynamics/engines/substepped/touch_finder.hpp"
#include "physics/dynamics/engines/substepped/touch_record.hpp"
#include "tests/physics/buoyancy/generators.hpp"
#include "tests/physics/dynamics/brute_gap.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <deque>
#include <set>

namespace trembler::test {
namespace touch_finder_test {
namespace {

constexpr double scale = 10;
constexpr double skin = 0.01 / scale; // of polygons, each

auto const everybody = [](SlotIndex, SlotIndex) { return true; };

/// Bodies in a finder, and their places.
class Scatter {
public:
    void add(ShapePiece const& piece, Vec2 at, double angle) {
        auto const slot = static_cast<SlotIndex>(shapes.size());
        shapes.push_back(Shape{{piece}});
        places.push_back({at, angle});
        BodySpec spec;
        spec.object = {slot, 0};
        spec.shape = &shapes.back();
        spec.spread.centre = {}; // the frame's origin: places are those of the frame
        spec.motion.centre = at;
        spec.motion.angle = angle;
        finder.add(slot, spec);
    }
    void place(SlotIndex slot, Vec2 at, double angle) {
        places[slot] = {at, angle};
        finder.place(slot, at, angle);
    }
    [[nodiscard]] double gap(SlotIndex a, SlotIndex b) const {
        return bruteGap({shapes[a], places[a].first, places[a].second},
                        {shapes[b], places[b].first, places[b].second}, skin);
    }
    std::vector<FoundTouch> find(std::vector<SlotIndex> const& slots) {
        std::vector<FoundTouch> found;
        finder.find(slots, everybody, found);
        return found;
    }

    std::deque<Shape> shapes;
    std::vector<std::pair<Vec2, double>> places;
    TouchFinder finder{scale};
};

ShapePiece anyPiece() {
    // Pieces without offsets: a body's frame is its centre. Capsules become several of the engine's shapes.
    switch (*rc::gen::inRange(0, 3)) {
    case 0:
        return circlePiece(*number(0.05, 0.5));
    case 1:
        return boxPiece(*number(0.05, 1), *number(0.05, 1));
    default:
        return capsulePiece(*number(0.5, 1), *number(0.05, 0.2));
    }
}

TEST(TouchFinder, FindsExactlyTheTouchingPairs) {
    EXPECT_TRUE(rc::check("as the gaps say", [] {
        Scatter scatter;
        auto const count = *rc::gen::inRange<SlotIndex>(2, 8);
        for (SlotIndex slot = 0; slot < count; ++slot) {
            scatter.add(anyPiece(), *point(1), *number(-3, 3));
        }
        for (SlotIndex slot = 0; slot < count; slot += 2) { // the tree must follow
            scatter.place(slot, *point(1), *number(-3, 3));
        }
        std::vector<SlotIndex> slots;
        for (SlotIndex slot = 0; slot < count; ++slot) {
            slots.push_back(slot);
        }
        auto const found = scatter.find(slots);
        std::set<std::pair<SlotIndex, SlotIndex>> pairs;
        for (std::size_t i = 0; i < found.size(); ++i) {
            FoundTouch const& touch = found[i];
            RC_ASSERT(touch.a < touch.b);
            if (i > 0) { // the macro evaluates both sides of an "or"
                RC_ASSERT(found[i - 1].key < touch.key);
            }
            RC_ASSERT(std::abs(length(touch.normal) - 1) < 1e-9);
            pairs.emplace(touch.a, touch.b);
        }
        constexpr double rounding = 2e-4; // of single precision, and of Box2D's rounded corners
        for (SlotIndex a = 0; a < count; ++a) {
            for (SlotIndex b = a + 1; b < count; ++b) {
                double const gap = scatter.gap(a, b);
                if (pairs.contains({a, b})) {
                    RC_ASSERT(gap < 2 * skin + rounding);
                } else {
                    RC_ASSERT(gap > -2 * skin - rounding);
                }
            }
        }
    }));
}

TEST(TouchFinder, PlaceNormalAndDepthOfABallOnAFloor) {
    for (bool const floorFirst : {true, false}) {
        Scatter scatter;
        auto const floor = [&] { scatter.add(boxPiece(4, 1), {0, -0.5}, 0); };
        auto const ball = [&] { scatter.add(circlePiece(0.25), {0.7, 0.24}, 0); };
        floorFirst ? floor() : ball();
        floorFirst ? ball() : floor();
        auto const found = scatter.find({0, 1});
        ASSERT_EQ(found.size(), 1U);
        FoundTouch const& touch = found[0];
        EXPECT_EQ(touch.count, 1);
        EXPECT_NEAR(touch.normal.y, floorFirst ? 1 : -1, 1e-5) << "from a to b";
        EXPECT_NEAR(touch.points[0].x, 0.7, 1e-5);
        EXPECT_NEAR(touch.points[0].y, 0, 0.011);
        EXPECT_NEAR(touch.depth[0], 0.01 + skin, 1e-4) << "the floor's skin included";
    }
    Scatter scatter;
    scatter.add(boxPiece(4, 1), {0, -0.5}, 0);
    scatter.add(boxPiece(1, 1), {0.5, 0.5}, 0);
    auto const edge = scatter.find({1});
    ASSERT_EQ(edge.size(), 1U);
    EXPECT_EQ(edge[0].count, 2) << "two parallel sides touch at two points";
    EXPECT_NEAR(std::abs(edge[0].points[0].x - edge[0].points[1].x), 1, 0.01);
}

TEST(TouchFinder, SearchesOnlyRequestedAndAllowedPairs) {
    Scatter scatter;
    scatter.add(circlePiece(1), {0, 0}, 0);
    scatter.add(circlePiece(1), {1, 0}, 0);
    scatter.add(circlePiece(1), {0, 1}, 0);
    EXPECT_EQ(scatter.find({0}).size(), 2U);
    EXPECT_EQ(scatter.find({}).size(), 0U);
    EXPECT_EQ(scatter.find({0, 1, 2}).size(), 3U) << "each pair once";
    std::vector<FoundTouch> found;
    std::vector<SlotIndex> const all{0, 1, 2};
    scatter.finder.find(
        all,
        [](SlotIndex a, SlotIndex b) {
            EXPECT_LT(a, b);
            return a == 0 && b == 2;
        },
        found);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].b, 2U);
    scatter.finder.remove(2);
    EXPECT_EQ(scatter.find({0, 1}).size(), 1U);
    std::vector<FoundTouch> more = scatter.find({0});
    scatter.finder.find(std::vector<SlotIndex>{1}, everybody, more);
    EXPECT_EQ(more.size(), 2U) << "results are appended";
}

TEST(TouchFinder, ADiscMovesUpToTheFirstObstacle) {
    Scatter scatter;
    scatter.add(boxPiece(0.2, 10), {5, 0}, 0); // its near face at 4.9
    auto const stops = [](SlotIndex) { return true; };
    // The face less the disc's radius, and both skins.
    EXPECT_NEAR(scatter.finder.freeShare({}, 0.3, {10, 0}, stops), 0.46, 0.005);
    EXPECT_NEAR(scatter.finder.freeShare({0, 4}, 0.3, {10, -3}, stops), 0.46, 0.005) << "aslant";
    EXPECT_EQ(scatter.finder.freeShare({}, 0.3, {4, 0}, stops), 1) << "its path ends before the block";
    EXPECT_EQ(scatter.finder.freeShare({}, 0.3, {-10, 0}, stops), 1) << "its path leads away from the block";
    EXPECT_EQ(scatter.finder.freeShare({0, 9}, 0.3, {10, 0}, stops), 1) << "its path passes above the block";
    EXPECT_EQ(scatter.finder.freeShare({}, 0.3, {10, 0}, [](SlotIndex) { return false; }), 1);
    EXPECT_EQ(scatter.finder.freeShare({5, 0}, 0.05, {10, 0}, stops), 1) << "it starts inside the block";
    scatter.add(circlePiece(0.5), {2, 0}, 0);
    EXPECT_NEAR(scatter.finder.freeShare({}, 0.3, {10, 0}, stops), 0.12, 0.005) << "the nearest counts";
}

} // namespace
} // namespace touch_finder_test
} // namespace trembler::test
