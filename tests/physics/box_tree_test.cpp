#include "physics/box_tree.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <optional>
#include <random>

namespace trembler {
namespace {

// Boxes on a coarse grid, so that many touch and some are equal or have no area.
class RandomBoxes {
public:
    RandomBoxes() : random_(*rc::gen::arbitrary<std::uint64_t>()), room_(number(2) > 0 ? 20 : 5) {}

    [[nodiscard]] double number(int below) {
        return static_cast<double>(random_() % static_cast<unsigned>(below));
    }
    [[nodiscard]] Bounds one() {
        Vec2 const lower{number(room_), number(room_)};
        return Bounds{lower, lower + Vec2{number(4), number(4)}};
    }
    [[nodiscard]] std::vector<Bounds> some() {
        std::vector<Bounds> boxes(random_() % 60);
        for (Bounds& each : boxes) {
            each = one();
        }
        return boxes;
    }
    [[nodiscard]] static std::vector<std::uint32_t> meeting(std::vector<Bounds> const& boxes,
                                                            Bounds const& where) {
        std::vector<std::uint32_t> found;
        for (std::uint32_t k = 0; k < boxes.size(); ++k) {
            if (boxes[k].meets(where)) {
                found.push_back(k);
            }
        }
        return found;
    }

private:
    std::mt19937_64 random_;
    int room_; // width of the field; in a field of 5 nearly all boxes meet
};

TEST(BoxTree, AgreesWithBruteForce) {
    EXPECT_TRUE(rc::check([] {
        RandomBoxes random;
        std::vector<Bounds> const boxes = random.some();
        BoxTree const tree(boxes);
        for (int i = 0; i < 10; ++i) {
            Bounds const where = random.one();
            std::vector<std::uint32_t> const expected = RandomBoxes::meeting(boxes, where);
            std::vector<std::uint32_t> found{7}; // earlier results are removed
            tree.find(where, found);
            RC_ASSERT(found == expected);
            RC_ASSERT(tree.count(where) == expected.size());
        }
    }));
}

TEST(BoxTree, TestsInAscendingOrderUntilTheFirstThatHolds) {
    EXPECT_TRUE(rc::check([] {
        RandomBoxes random;
        std::vector<Bounds> const boxes = random.some();
        BoxTree const tree(boxes);
        for (int i = 0; i < 10; ++i) {
            Bounds const where = random.one();
            auto const first = static_cast<std::uint32_t>(random.number(30));
            auto const end = static_cast<std::uint32_t>(random.number(70));
            auto const wanted = static_cast<std::uint32_t>(random.number(5));
            auto const holds = [&](std::uint32_t box) { return box % 5 == wanted; };
            std::vector<std::uint32_t> expected;
            std::optional<std::uint32_t> answer;
            for (std::uint32_t const box : RandomBoxes::meeting(boxes, where)) {
                if (box >= first && box < end && !answer) {
                    expected.push_back(box);
                    answer = holds(box) ? std::optional(box) : std::nullopt;
                }
            }
            std::vector<std::uint32_t> asked;
            auto const found = tree.findFirst(where, first, end, [&](std::uint32_t box) {
                asked.push_back(box);
                return holds(box);
            });
            RC_ASSERT(found == answer);
            RC_ASSERT(asked == expected);
        }
    }));
}

TEST(BoxTree, CountsEqualBoxesInConstantTime) {
    constexpr std::uint32_t many = 100'000;
    Bounds const place{{1, 2}, {3, 4}};
    BoxTree const tree(std::vector<Bounds>(many, place));
    std::size_t asked = 0;
    for (std::uint32_t i = 1; i < many; ++i) { // each in constant time, else this would take very long
        ASSERT_EQ(tree.count(place), many);
        ASSERT_EQ(tree.findFirst(place, 0, i, [&](std::uint32_t) { return ++asked > 0; }), 0U);
    }
    EXPECT_EQ(asked, many - 1);
}

} // namespace
} // namespace trembler
