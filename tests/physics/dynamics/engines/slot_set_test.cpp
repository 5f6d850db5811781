#include "physics/dynamics/engines/slot_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace trembler::test {
namespace {

TEST(SlotSet, AgreesWithASetOfTheStandardLibrary) {
    std::mt19937 random(3);
    SlotSet slots;
    std::set<SlotIndex> expected;
    for (int i = 0; i < 20000; ++i) {
        auto const slot = static_cast<SlotIndex>(random() % 200);
        if (random() % 2 == 0) {
            slots.insert(slot);
            expected.insert(slot);
        } else {
            slots.erase(slot);
            expected.erase(slot);
        }
        ASSERT_EQ(slots.contains(slot), expected.contains(slot));
        std::vector<SlotIndex> members = slots.members();
        std::sort(members.begin(), members.end());
        ASSERT_TRUE(std::equal(members.begin(), members.end(), expected.begin(), expected.end())) << i;
    }
}

TEST(SlotSet, DoesNotContainSlotsThatWereNeverAdded) {
    SlotSet slots;
    EXPECT_FALSE(slots.contains(0));
    EXPECT_FALSE(slots.contains(noSlot));
    slots.erase(7);
    EXPECT_TRUE(slots.members().empty());
    slots.insert(7);
    slots.insert(7);
    EXPECT_EQ(slots.members(), std::vector<SlotIndex>{7});
    EXPECT_FALSE(slots.contains(6));
    slots.erase(7);
    EXPECT_TRUE(slots.members().empty());
}

} // namespace
} // namespace trembler::test
