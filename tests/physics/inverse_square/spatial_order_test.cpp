// An order along a curve, compared with interleaving single bits.
#include "physics/inverse_square/spatial_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <set>

namespace trembler::inverse_square {
namespace spatial_order_test {
namespace {

/// Whether a comes before b on Morton's curve, found by halving the square, y first, until they are in
/// different halves.
bool before(Vec2 a, Vec2 b, Vec2 low, double extent) {
    for (int level = 0; level < 32; ++level) {
        extent /= 2;
        bool const aUp = a.y >= low.y + extent;
        bool const bUp = b.y >= low.y + extent;
        bool const aRight = a.x >= low.x + extent;
        bool const bRight = b.x >= low.x + extent;
        if (aUp != bUp) {
            return bUp;
        }
        if (aRight != bRight) {
            return bRight;
        }
        low += {aRight ? extent : 0, aUp ? extent : 0};
    }
    return false;
}

TEST(SpatialOrder, IsThatOfRepeatedlyHalvedSquares) {
    EXPECT_TRUE(rc::check("the same as by halving", [] {
        // Whole numbers in a square of 1024, whose halves are exact.
        Points points;
        points.add({0, 0}, 1, 0);
        points.add({1024, 1024}, 1, 1);
        for (int i = *rc::gen::inRange(0, 30); i > 0; --i) {
            double const x = *rc::gen::inRange(0, 1024);
            points.add({x, static_cast<double>(*rc::gen::inRange(0, 1024))}, 1, 1 + i);
        }
        std::vector<Ordered> order;
        orderAlongCurve(points, order);
        RC_ASSERT(order.size() == points.size());
        std::set<std::uint32_t> rows;
        for (std::size_t i = 0; i < order.size(); ++i) {
            rows.insert(order[i].row);
            if (i > 0) {
                RC_ASSERT(order[i - 1].key <= order[i].key);
                RC_ASSERT(!before(points.at(order[i].row), points.at(order[i - 1].row), {0, 0}, 1024));
            }
        }
        RC_ASSERT(rows.size() == points.size()); // each once
        Points ordered;
        copyInOrder(points, order, ordered);
        for (std::size_t i = 0; i < order.size(); ++i) {
            RC_ASSERT(ordered.at(i) == points.at(order[i].row));
            RC_ASSERT(ordered.owner[i] == points.owner[order[i].row]);
            RC_ASSERT(ordered.weight[i] == points.weight[order[i].row]);
        }
    }));
}

TEST(SpatialOrder, DoesNotDependOnTheOrderOfPoints) {
    EXPECT_TRUE(rc::check("sorted points are the same points", [] {
        std::vector<std::array<int, 4>> all =
            *rc::gen::container<std::vector<std::array<int, 4>>>(rc::gen::apply(
                [](int x, int y, int weight, int owner) {
                    return std::array<int, 4>{x, y, weight, owner};
                },
                rc::gen::inRange(-3, 3), rc::gen::inRange(-3, 3), rc::gen::inRange(0, 3),
                rc::gen::inRange(0, 3)));
        auto const ordered = [&] {
            Points points;
            for (auto const& [x, y, weight, owner] : all) {
                points.add({x / 3.0, y / 3.0}, weight, owner);
            }
            std::vector<Ordered> order;
            orderAlongCurve(points, order);
            Points made;
            copyInOrder(points, order, made);
            return made;
        };
        Points const first = ordered();
        std::reverse(all.begin(), all.end());
        Points const again = ordered();
        RC_ASSERT(first.x == again.x && first.y == again.y);
        RC_ASSERT(first.weight == again.weight && first.owner == again.owner);
    }));
}

TEST(SpatialOrder, AcceptsNoPointOnePointAndNonFiniteNumbers) {
    std::vector<Ordered> order{{7, 7}};
    orderAlongCurve({}, order);
    EXPECT_TRUE(order.empty());
    Points heap;
    for (int i = 5; i-- > 0;) {
        heap.add({2, 2}, 1, i);
    }
    orderAlongCurve(heap, order);
    ASSERT_EQ(order.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(heap.owner[order[i].row], static_cast<double>(i))
            << "ordered by owner if all else is equal";
    }
    Points line;
    for (int i = 0; i < 100; ++i) {
        line.add({5, static_cast<double>((i * 37) % 100)}, 1, i);
    }
    orderAlongCurve(line, order);
    for (std::size_t i = 1; i < order.size(); ++i) {
        EXPECT_LT(line.y[order[i - 1].row], line.y[order[i].row]);
    }
}

} // namespace
} // namespace spatial_order_test
} // namespace trembler::inverse_square
