#include "physics/dynamics/core/slots.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <random>
#include <set>

namespace trembler {
namespace {

TEST(SlotBook, TakesTheLowestFreeSlotWhateverTheOrderOfReleases) {
    EXPECT_TRUE(rc::check([] {
        std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
        SlotBook book;
        std::set<SlotIndex> free; // the reference: an ordered set
        std::map<SlotIndex, ObjectId> taken;
        SlotIndex slots = 0;
        std::uint32_t objects = 0;
        for (int i = 0; i < 200; ++i) {
            if (taken.empty() || random() % 5 < 2) {
                SlotIndex const expected = free.empty() ? slots++ : *free.begin();
                free.erase(expected);
                ObjectId const object{objects++, 3};
                RC_ASSERT(book.take(object) == expected);
                taken[expected] = object;
            } else {
                auto const which =
                    std::next(taken.begin(), static_cast<std::ptrdiff_t>(random() % taken.size()));
                book.release(which->first);
                RC_ASSERT(book.find(which->second) == noSlot);
                free.insert(which->first);
                taken.erase(which);
            }
            for (auto const& [slot, object] : taken) {
                RC_ASSERT(book.find(object) == slot);
                RC_ASSERT(book.objects()[slot] == object);
            }
        }
    }));
}

} // namespace
} // namespace trembler
