// Levels that start with so many bodies in one place that frames take long.
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/crowd.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "runtime/placement.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

class CrowdStore {
public:
    ObjectId add(Shape shape, Vec2 at, bool fixed = false) {
        ObjectId const id = store.create("body " + std::to_string(names_++));
        store.column<Shape>().set(id, std::move(shape));
        store.column<Position>().set(id, {at});
        if (fixed) {
            store.column<Fixed>().set(id, {});
        }
        return id;
    }
    Store store;

private:
    int names_ = 0;
};

TEST(CrowdedStart, IsAThousandBodiesInOnePlaceAndNotTwoHundred) {
    CrowdStore few;
    CrowdStore many;
    for (int i = 0; i < 1000; ++i) {
        many.add({{boxPiece(0.5, 0.5)}}, {1, 2});
        if (i < 200) {
            few.add({{boxPiece(0.5, 0.5)}}, {1, 2});
        }
    }
    EXPECT_FALSE(crowdedStart(few.store));
    auto const crowd = crowdedStart(many.store);
    ASSERT_TRUE(crowd);
    EXPECT_EQ(crowd->pairs, 499'500U) << "1000 * 999 / 2";
    EXPECT_EQ(crowd->nearest, 999U);
    EXPECT_EQ(crowd->usual, 36'000U);
    EXPECT_EQ(many.store.nameOf(crowd->body).substr(0, 4), "body");
    EXPECT_NE(inWords(*crowd, "box 7").find("499500 pairs"), std::string::npos);
}

TEST(CrowdedStart, CountsAFixedBodyAndAMovableOneOnceAndFixedOnesNever) {
    CrowdStore bodies;
    for (int i = 0; i < 300; ++i) {
        bodies.add({{boxPiece(1, 1)}}, {0, 0}, true);
    }
    EXPECT_FALSE(crowdedStart(bodies.store)) << "walls in front of each other";
    for (int i = 0; i < 150; ++i) {
        bodies.add({{boxPiece(1, 1)}}, {0, 0});
    }
    auto const crowd = crowdedStart(bodies.store);
    ASSERT_TRUE(crowd);
    EXPECT_EQ(crowd->pairs, 150U * 300U + 150U * 149U / 2U);
}

TEST(CrowdedStart, LeavesOutThePiecesOfOneBody) {
    CrowdStore bodies;
    Shape wheel;
    for (int i = 0; i < 250; ++i) {
        wheel.pieces.push_back(boxPiece(1, 0.01, {}, i * 0.0125));
    }
    bodies.add(wheel, {0, 0});
    EXPECT_FALSE(crowdedStart(bodies.store)) << "250 spokes";
    bodies.add(wheel, {0, 0});
    EXPECT_EQ(crowdedStart(bodies.store).value_or(CrowdedStart{}).pairs, 62'500U) << "two such wheels";
}

// The levels of bench_growth's rows, up to the greatest number.
TEST(CrowdedStart, IsNoHeapOfVeryMany) {
    CrowdStore bodies;
    for (int i = 0; i < 50'000; ++i) {
        bodies.add({{boxPiece(1, 1)}}, {1.0 * (i % 250), 1.0 * (i / 250)});
    }
    bodies.add({{boxPiece(1e3, 1e3)}}, {0, 0}, true); // all of them in front of a board
    EXPECT_FALSE(crowdedStart(bodies.store));
}

} // namespace
} // namespace trembler
