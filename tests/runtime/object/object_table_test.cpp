// Ids: the lowest free index first, a new generation for every reuse, compared with a model of plain sets.
#include "runtime/object/object_table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

namespace trembler {
namespace {

TEST(ObjectTable, UsesTheLowestFreeIndexFirst) {
    ObjectTable table;
    for (std::uint32_t i = 0; i < 5; ++i) {
        EXPECT_EQ(table.create(), (ObjectId{i, 0}));
    }
    EXPECT_TRUE(table.destroy({3, 0}));
    EXPECT_TRUE(table.destroy({1, 0}));
    EXPECT_TRUE(table.destroy({4, 0}));
    EXPECT_EQ(table.size(), 2U);
    EXPECT_EQ(table.create(), (ObjectId{1, 1}));
    EXPECT_EQ(table.create(), (ObjectId{3, 1}));
    EXPECT_EQ(table.create(), (ObjectId{4, 1}));
    EXPECT_EQ(table.create(), (ObjectId{5, 0}));
    EXPECT_EQ(table.indexBound(), 6U);
}

TEST(ObjectTable, RecognisesStaleAndInvalidIds) {
    ObjectTable table;
    ObjectId const first = table.create();
    EXPECT_TRUE(table.alive(first));
    EXPECT_TRUE(table.destroy(first));
    EXPECT_FALSE(table.alive(first));
    EXPECT_FALSE(table.destroy(first)) << "a second destruction has no effect";
    EXPECT_FALSE(table.at(0).valid());
    ObjectId const second = table.create();
    EXPECT_FALSE(table.alive(first)) << "a stale id does not name the next object with its index";
    EXPECT_TRUE(table.alive(second));
    EXPECT_EQ(table.at(0), second);
    EXPECT_FALSE(table.destroy(first));
    EXPECT_TRUE(table.alive(second));
    EXPECT_FALSE(table.alive({}));
    EXPECT_FALSE(table.alive({7, 0}));
    EXPECT_FALSE(table.destroy({7, 0}));
    EXPECT_FALSE(table.at(7).valid());
}

TEST(ObjectTable, FollowsItsModelThroughAnySequence) {
    EXPECT_TRUE(rc::check([](std::vector<std::uint16_t> const& deeds) {
        ObjectTable table;
        std::map<std::uint32_t, std::uint32_t>
            generations; // of every used index: the generation of its living or next object
        std::set<std::uint32_t> living;
        for (std::uint16_t const deed : deeds) {
            if (deed % 3 != 0 || generations.empty()) {
                std::uint32_t lowest = 0;
                while (living.contains(lowest)) {
                    ++lowest;
                }
                ObjectId const expected{lowest, generations[lowest]};
                RC_ASSERT(table.create() == expected);
                living.insert(lowest);
            } else {
                auto const index = static_cast<std::uint32_t>(deed / 3 % generations.size());
                ObjectId const id{index, generations[index]};
                RC_ASSERT(table.destroy(id) == living.contains(index));
                if (living.erase(index) == 1) {
                    ++generations[index];
                }
            }
            RC_ASSERT(table.size() == living.size());
            RC_ASSERT(table.indexBound() == generations.size());
            for (auto const& [index, generation] : generations) {
                RC_ASSERT(table.alive({index, generation}) == living.contains(index));
                RC_ASSERT(!table.alive({index, generation + 1}));
                RC_ASSERT(table.at(index).valid() == living.contains(index));
            }
        }
    }));
}

TEST(ObjectId, IsOrderedByIndexFirstAndPackedWithoutLoss) {
    EXPECT_LT((ObjectId{1, 9}), (ObjectId{2, 0}));
    EXPECT_LT((ObjectId{1, 0}), (ObjectId{1, 1}));
    EXPECT_FALSE(ObjectId{}.valid());
    EXPECT_EQ(packed({0x01234567U, 0x89abcdefU}), 0x89abcdef01234567ULL);
}

} // namespace
} // namespace trembler
