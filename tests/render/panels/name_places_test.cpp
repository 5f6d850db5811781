// Names stand on large objects, and beside small ones without hiding them or one another.
#include "render/panels/name_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::render::test {
namespace {

constexpr Point wideScreen{1280, 720};

/// Whether two rectangles of these middles and sizes have a point in common.
bool meet(Point a, Point sizeA, Point b, Point sizeB) {
    return std::abs(a.x - b.x) < 0.5 * (sizeA.x + sizeB.x) && std::abs(a.y - b.y) < 0.5 * (sizeA.y + sizeB.y);
}

NamedBox boxAt(Point middle, Point half, Point name) {
    return {middle - half, middle + half, name};
}

TEST(NamePlaces, AreOnLargeObjects) {
    std::vector<NamedBox> const one{boxAt({400, 300}, {100, 40}, {80, 20})};
    EXPECT_EQ(namePlaces(one, wideScreen).front(), (Point{400, 300}));
}

TEST(NamePlaces, AreBelowASmallObject) {
    std::vector<NamedBox> const one{boxAt({400, 300}, {10, 10}, {80, 20})};
    Point const place = namePlaces(one, wideScreen).front();
    EXPECT_DOUBLE_EQ(place.x, 400);
    EXPECT_GT(place.y, 320);
}

TEST(NamePlaces, HideNeitherOneAnotherNorSmallObjects) {
    std::vector<NamedBox> row; // closer than their names are wide
    for (int i = 0; i < 5; ++i) {
        row.push_back(boxAt({400.0 + 40 * i, 300}, {12, 12}, {90, 20}));
    }
    auto const places = namePlaces(row, wideScreen);
    ASSERT_EQ(places.size(), row.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
        for (std::size_t j = 0; j < row.size(); ++j) {
            if (i != j) {
                EXPECT_FALSE(meet(places[i], row[i].size, places[j], row[j].size)) << i << " and " << j;
            }
            EXPECT_FALSE(meet(places[i], row[i].size, 0.5 * (row[j].low + row[j].high), {24, 24}))
                << "the name of " << i << " on " << j;
        }
    }
}

TEST(NamePlaces, StayOnTheScreen) {
    std::vector<NamedBox> const corner{boxAt({1275, 715}, {5, 5}, {90, 20})};
    Point const place = namePlaces(corner, wideScreen).front();
    EXPECT_LE(place.x + 45, wideScreen.x);
    EXPECT_LE(place.y + 10, wideScreen.y);
}

} // namespace
} // namespace trembler::render::test
