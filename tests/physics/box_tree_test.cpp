#include "physics/box_tree.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <random>

namespace trembler {
namespace {

TEST(BoxTree, FindsWhatBruteForceFinds) {
    rc::check([] {
        std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
        auto const number = [&](int below) {
            return static_cast<double>(random() % static_cast<unsigned>(below));
        };
        auto const box = [&] { // on a coarse grid, so that many touch and some are equal or have no area
            Vec2 const lower{number(20), number(20)};
            return Bounds{lower, lower + Vec2{number(4), number(4)}};
        };
        std::vector<Bounds> boxes(random() % 60);
        for (Bounds& each : boxes) {
            each = box();
        }
        BoxTree const tree(boxes);
        for (int i = 0; i < 10; ++i) {
            Bounds const where = box();
            std::vector<std::uint32_t> expected;
            for (std::uint32_t k = 0; k < boxes.size(); ++k) {
                if (boxes[k].meets(where)) {
                    expected.push_back(k);
                }
            }
            std::vector<std::uint32_t> found{7}; // what was found before is forgotten
            tree.find(where, found);
            RC_ASSERT(found == expected);
        }
    });
}

} // namespace
} // namespace trembler
