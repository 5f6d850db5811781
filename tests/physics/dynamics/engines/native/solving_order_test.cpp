// Every used contact once, upwards from what is fixed.
#include "physics/dynamics/engines/native/solving_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>

namespace trembler::native {
namespace solving_order_test {
namespace {

struct Case {
    std::vector<BodyEntry> bodies;
    std::vector<Contact> contacts;
    std::vector<SlotIndex> movable;
    std::vector<std::uint32_t> indices;

    [[nodiscard]] Island island() const { return {movable, indices, {}}; }
    void contact(SlotIndex a, SlotIndex b) {
        Contact& made = contacts.emplace_back();
        made.a = std::min(a, b);
        made.b = std::max(a, b);
        made.used = true;
        indices.push_back(static_cast<std::uint32_t>(contacts.size() - 1));
    }
};

TEST(SolvingOrder, HasEachUsedContactOnce) {
    EXPECT_TRUE(rc::check([] {
        Case scene;
        std::size_t const bodies = *rc::gen::inRange<std::size_t>(2, 20);
        scene.bodies.resize(bodies);
        scene.bodies[0].fixed = *rc::gen::arbitrary<bool>();
        for (SlotIndex slot = 0; slot < bodies; ++slot) {
            if (!scene.bodies[slot].fixed) {
                scene.movable.push_back(slot);
            }
        }
        int const contacts = *rc::gen::inRange(0, 60);
        for (int i = 0; i < contacts; ++i) {
            SlotIndex const a = *rc::gen::inRange<SlotIndex>(0, static_cast<SlotIndex>(bodies));
            SlotIndex const b = *rc::gen::inRange<SlotIndex>(0, static_cast<SlotIndex>(bodies));
            if (a != b) {
                scene.contact(a, b);
                scene.contacts.back().used = *rc::gen::inRange(0, 4) > 0;
            }
        }
        SolvingOrder order;
        auto const found = order.of(scene.island(), scene.contacts, scene.bodies);
        std::vector<std::uint32_t> sorted(found.begin(), found.end());
        std::sort(sorted.begin(), sorted.end());
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < scene.contacts.size(); ++i) {
            if (scene.contacts[i].used) {
                expected.push_back(i);
            }
        }
        RC_ASSERT(sorted == expected);
    }));
}

TEST(SolvingOrder, GoesUpwardsFromTheFloorWhateverTheSlots) {
    Case scene;
    scene.bodies.resize(6);
    scene.bodies[5].fixed = true; // the floor; the stack above it is 3, 1, 4, 0, 2
    scene.movable = {0, 1, 2, 3, 4};
    scene.contact(0, 2);
    scene.contact(4, 0);
    scene.contact(1, 4);
    scene.contact(3, 1);
    scene.contact(5, 3);
    SolvingOrder order;
    auto const found = order.of(scene.island(), scene.contacts, scene.bodies);
    EXPECT_EQ(std::vector<std::uint32_t>(found.begin(), found.end()),
              (std::vector<std::uint32_t>{4, 3, 2, 1, 0}));
}

} // namespace
} // namespace solving_order_test
} // namespace trembler::native
