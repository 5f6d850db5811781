// Switching: on one frame after the call, off over as many frames as the coil needs to cool down; permanent
// magnets need no calls.
#include "tests/physics/magnetism/magnet_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler {
namespace {

using namespace test;

double level(MagnetWorld& magnets, ObjectId id) {
    return magnets.world.find<Magnet>(id)->level;
}
bool on(MagnetWorld& magnets, ObjectId id) {
    return magnets.world.find<Magnet>(id)->on;
}
void flip(MagnetWorld& magnets, ObjectId id, bool state) {
    magnets.world.store().column<Switch>().set(id, {state});
}

TEST(Magnetics, PermanentMagnetsAreOnFromTheStart) {
    MagnetWorld magnets;
    ObjectId const bar = magnets.magnet({0, 0}, 0, 100, barPoles(0.2));
    ObjectId const iron = magnets.soft({1, 0}, 10);
    ObjectId const coil = magnets.electromagnet({2, 0}, 4);
    magnets.run(1);
    EXPECT_TRUE(on(magnets, bar));
    EXPECT_EQ(level(magnets, bar), 1);
    EXPECT_EQ(magnets.world.find<Magnet>(iron), nullptr) << "an object without poles is not a magnet";
    EXPECT_FALSE(on(magnets, coil));
    EXPECT_EQ(level(magnets, coil), 0) << "off without electricity";
    magnets.run(100);
    EXPECT_EQ(level(magnets, bar), 1);
}

TEST(Magnetics, AnElectromagnetIsOnOneFrameAfterTheCall) {
    MagnetWorld magnets;
    ObjectId const coil = magnets.electromagnet({0, 0}, 4);
    ObjectId const iron = magnets.soft({0, 1}, 10);
    magnets.run(2);
    flip(magnets, coil, true);
    magnets.run(1); // the interaction calls at the end of this frame
    EXPECT_FALSE(on(magnets, coil));
    EXPECT_EQ(magnets.force(iron), (Vec2{0, 0}));
    magnets.run(1);
    EXPECT_TRUE(on(magnets, coil));
    EXPECT_EQ(level(magnets, coil), 1);
    EXPECT_LT(magnets.force(iron).y, 0) << "the force is computed in the same frame";
    magnets.run(50); // the call is held while its interaction sleeps
    EXPECT_TRUE(on(magnets, coil));
    EXPECT_EQ(level(magnets, coil), 1);
}

TEST(Magnetics, CoolingDownTakesExactlyTheFramesOfTheCoil) {
    for (int frames = 1; frames <= 600; ++frames) {
        MagnetWorld magnets;
        ObjectId const coil = magnets.electromagnet({0, 0}, frames);
        flip(magnets, coil, true);
        magnets.run(2);
        ASSERT_EQ(level(magnets, coil), 1);
        flip(magnets, coil, false);
        magnets.run(1); // no further calls
        ASSERT_EQ(level(magnets, coil), 1);
        for (int left = frames - 1; left >= 0; --left) {
            magnets.run(1);
            ASSERT_FALSE(on(magnets, coil));
            ASSERT_NEAR(level(magnets, coil), static_cast<double>(left) / frames, 1e-12) << frames;
            if (left > 0) {
                ASSERT_GT(level(magnets, coil), 0) << left << " of " << frames;
            }
        }
        ASSERT_EQ(level(magnets, coil), 0) << frames;
        magnets.run(2);
        ASSERT_EQ(level(magnets, coil), 0) << frames;
    }
}

TEST(Magnetics, TheForceFallsWithTheLevel) {
    MagnetWorld magnets;
    ObjectId const coil = magnets.electromagnet({0, 0}, 4);
    ObjectId const iron = magnets.soft({0, 1}, 10);
    flip(magnets, coil, true);
    magnets.run(2);
    double const full = magnets.force(iron).y;
    ASSERT_LT(full, 0);
    flip(magnets, coil, false);
    magnets.run(1);
    for (double const share : {0.75, 0.5, 0.25}) {
        magnets.run(1);
        EXPECT_NEAR(magnets.force(iron).y, share * full, 1e-15);
    }
    magnets.run(1);
    EXPECT_TRUE(magnets.forces().empty());
}

TEST(Magnetics, SwitchingOnWhileCoolingRestoresFullStrengthAtOnce) {
    MagnetWorld magnets;
    ObjectId const coil = magnets.electromagnet({0, 0}, 10);
    flip(magnets, coil, true);
    magnets.run(2);
    flip(magnets, coil, false);
    magnets.run(5);
    EXPECT_LT(level(magnets, coil), 1);
    flip(magnets, coil, true);
    magnets.run(2);
    EXPECT_TRUE(on(magnets, coil));
    EXPECT_EQ(level(magnets, coil), 1);
}

TEST(Magnetics, SleepsOnceAllMagnetsHaveCooledDown) {
    MagnetWorld magnets;
    ObjectId const coil = magnets.electromagnet({0, 0}, 4);
    flip(magnets, coil, true);
    magnets.run(2);
    flip(magnets, coil, false);
    magnets.run(10);
    auto const updates = [&] {
        std::uint64_t sum = 0;
        for (ComponentStatus const& status : magnets.world.status()) {
            sum += status.info->text.effect == "magnetism" ? status.updates : 0;
        }
        return sum;
    };
    std::uint64_t const before = updates();
    magnets.run(20);
    EXPECT_EQ(updates(), before);
}

} // namespace
} // namespace trembler
