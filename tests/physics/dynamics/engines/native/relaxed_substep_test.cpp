// Joints that contradict each other, or of which there are too many: nothing gains energy, and they still
// hold.
#include "tests/physics/dynamics/engines/native/small_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace trembler::test {
namespace relaxed_substep_test {
namespace {

// A chain as long as the distance of its pins cannot sag: its equations are singular.
TEST(RelaxedSubstep, AChainWithoutRoomToSagBearsAWeight) {
    SmallWorld world;
    constexpr int links = 20;
    SlotIndex last = noSlot;
    std::vector<SlotIndex> chain;
    for (int i = 0; i < links; ++i) {
        SlotIndex const link = world.add(boxShape(0.2, 0.05), {.at = {0.2 * (i + 0.5), 0}, .mass = 2});
        world.hinge(link, last, {0.2 * i, 0});
        last = link;
        chain.push_back(link);
    }
    world.hinge(last, noSlot, {0.2 * links, 0});
    SlotIndex const weight = world.add(boxShape(0.5, 0.5), {.at = {0.1 * links, 0.6}, .mass = 50});
    for (int i = 0; i < 300; ++i) {
        world.step();
        for (SlotIndex const link : chain) {
            ASSERT_LT(std::abs(world.motions[link].centre.y), 0.5) << i;
        }
    }
    EXPECT_GT(world.motions[weight].centre.y, 0.1);
    for (SlotIndex const link : chain) {
        EXPECT_GT(world.motions[link].centre.y, -0.3);
        EXPECT_LT(world.motions[link].centre.y, 0.1);
    }
}

// Two pins in a body that are nearer to each other than the places of the world that they hold to.
TEST(RelaxedSubstep, PinsThatContradictEachOtherStayBetweenTheirPlaces) {
    SmallWorld world;
    SlotIndex const plank = world.add(boxShape(2, 0.1), {.at = {0, 0}, .mass = 1});
    SlotIndex const left = world.add(boxShape(0.1, 0.1), {.at = {-1.5, 0}, .fixed = true, .group = -1});
    SlotIndex const right = world.add(boxShape(0.1, 0.1), {.at = {1.5, 0}, .fixed = true, .group = -1});
    world.join(JointForm::hinge, plank, left, {-1, 0}, {-1.5, 0});
    world.join(JointForm::hinge, plank, right, {1, 0}, {1.5, 0});
    double fastest = 0;
    for (int i = 0; i < 300; ++i) {
        world.step();
        fastest = std::max(fastest, length(world.motions[plank].velocity));
    }
    EXPECT_LT(fastest, 2);
    EXPECT_NEAR(world.motions[plank].centre.x, 0, 0.51);
    EXPECT_NEAR(world.motions[plank].centre.y, 0, 0.1);
}

} // namespace
} // namespace relaxed_substep_test
} // namespace trembler::test
