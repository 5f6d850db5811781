#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "physics/dynamics/rules/crowd_rules.hpp"
#include "runtime/placement.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <random>

namespace trembler {
namespace {

class Bodies {
public:
    ObjectId add(Shape shape, Vec2 at, double angle = 0) {
        ObjectId const id = store.create("body " + std::to_string(names_++));
        store.column<Shape>().set(id, std::move(shape));
        store.column<Position>().set(id, {at});
        store.column<Rotation>().set(id, {angle});
        return id;
    }
    Store store;

private:
    int names_ = 0;
};

struct Extent {
    ObjectId body;
    Vec2 lower;
    Vec2 upper;
};

// Compares all pieces with each other.
std::size_t nearPairs(Store const& store) {
    std::vector<Extent> all;
    auto const& shapes = *store.findColumn<Shape>();
    for (ObjectId const id : shapes.owners()) {
        for (ShapePiece const& piece : shapes.find(id)->pieces) {
            Shape const alone{{piece}};
            auto const [lower, upper] = extentOf({alone, store.findColumn<Position>()->find(id)->value,
                                                  store.findColumn<Rotation>()->find(id)->angle});
            all.push_back({id, lower, upper});
        }
    }
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            pairs += all[i].lower.x <= all[j].upper.x && all[j].lower.x <= all[i].upper.x &&
                             all[i].lower.y <= all[j].upper.y && all[j].lower.y <= all[i].upper.y
                         ? 1
                         : 0;
        }
    }
    return pairs;
}

TEST(CrowdRules, AgreeWithComparingAllPairs) {
    EXPECT_TRUE(rc::check([] {
        std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
        auto const number = [&](double most) { return most * static_cast<double>(random() % 1000) / 1000; };
        Bodies bodies;
        double const room = number(10);
        std::size_t const count = 2 + random() % 30;
        for (std::size_t i = 0; i < count; ++i) {
            Shape shape{{boxPiece(0.1 + number(1), 0.1 + number(1))}};
            if (random() % 3 == 0) {
                shape.pieces.push_back(circlePiece(0.1 + number(0.5), {number(2), 0}));
            }
            bodies.add(std::move(shape), {number(room), number(room)}, number(3));
        }
        std::size_t const pairs = nearPairs(bodies.store);
        RC_ASSERT(checkCrowds(bodies.store, pairs).empty());
        if (pairs > 0) {
            RC_ASSERT(checkCrowds(bodies.store, pairs - 1).size() == 1U);
        }
    }));
}

TEST(CrowdRules, NameTheBodyNearTheMostOthers) {
    Bodies bodies;
    for (int i = 0; i < 4; ++i) {
        bodies.add({{boxPiece(1, 1)}}, {2.0 * i, 0});
    }
    ObjectId const floor = bodies.add({{boxPiece(10, 1)}}, {3, -1});
    auto const faults = checkCrowds(bodies.store, 3);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults.front().object, floor);
    EXPECT_EQ(faults.front().text, "too many bodies lie in one place: the box around one of its pieces meets "
                                   "those around 4 others; expected at most 3 "
                                   "pairs of pieces of which the surrounding boxes meet");
}

TEST(CrowdRules, LeaveOutObjectsWithoutABody) {
    Bodies bodies;
    for (int i = 0; i < 10; ++i) {
        ObjectId const id = bodies.add({{boxPiece(1, 1)}}, {0, 0});
        if (i % 2 == 0) {
            bodies.store.column<Liquid>().set(id, {});
        } else if (i > 1) {
            bodies.store.column<Position>().remove(id);
        }
    }
    EXPECT_TRUE(checkCrowds(bodies.store, 0).empty());
    EXPECT_TRUE(checkCrowds(Store(), 0).empty());
}

// A hundred thousand bodies in one place would make engines look at five billion pairs.
TEST(CrowdRules, RefuseACrowdWithoutComparingAllPairs) {
    Bodies few;
    Bodies many;
    for (int i = 0; i < 100'000; ++i) {
        if (i < 6'000) {
            few.add({{boxPiece(1, 1)}}, {0, 0});
        }
        many.add({{boxPiece(1, 1)}}, {0, 0});
    }
    EXPECT_TRUE(checkCrowds(few.store).empty());
    EXPECT_EQ(checkCrowds(many.store).size(), 1U);
}

TEST(CrowdRules, AllowManyThatLieSideBySide) {
    Bodies bodies;
    for (int i = 0; i < 100'000; ++i) {
        bodies.add({{boxPiece(1, 1)}}, {1.0 * (i % 400), 1.0 * (i / 400)});
    }
    bodies.add({{boxPiece(1e3, 1e3)}}, {0, 0}); // all of them in front of a board
    EXPECT_TRUE(checkCrowds(bodies.store).empty());
}

} // namespace
} // namespace trembler
