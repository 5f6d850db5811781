// Rings for the eye.
#include "audio/effect/hearing/rings.hpp"
#include "audio/effect/properties/decibel.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

Sounds::Impact impactAt(Vec2 at, double level) {
    Sounds::Impact impact;
    impact.at = at;
    impact.meanSquare = meanSquareOf(level);
    return impact;
}

TEST(SoundRings, SpreadFadeAndGo) {
    Sounds sounds;
    sounds.frame = 1;
    sounds.impacts = {impactAt({1, 2}, 100), impactAt({1, 2}, 70), impactAt({3, 0}, 60),
                      impactAt({5, 0}, 20)};
    SoundRings rings;
    rings.hear(sounds);
    rings.hear(sounds);
    ASSERT_EQ(rings.rings().size(), 2U) << "one per place, none for what is too faint, none twice";
    EXPECT_GT(rings.rings()[0].strength, rings.rings()[1].strength);
    double const before = rings.rings()[0].strength;
    rings.advance(0.1);
    ASSERT_EQ(rings.rings().size(), 2U);
    EXPECT_NEAR(rings.rings()[0].radius, 0.1 * SoundRings::speed, 1e-12);
    EXPECT_LT(rings.rings()[0].strength, before);
    rings.advance(0.2);
    EXPECT_EQ(rings.rings().size(), 1U) << "the fainter goes first";
    rings.advance(SoundRings::life);
    EXPECT_TRUE(rings.rings().empty());
}

TEST(SoundRings, KeepTheStrongest) {
    Sounds sounds;
    sounds.frame = 1;
    for (int i = 0; i < 200; ++i) {
        sounds.impacts.push_back(impactAt({1.0 * i, 0}, 50 + (i * 37) % 50));
    }
    SoundRings rings;
    rings.hear(sounds);
    ASSERT_EQ(rings.rings().size(), SoundRings::mostRings);
    for (SoundRing const& ring : rings.rings()) {
        EXPECT_GE(ring.strength,
                  (50 + 50 - 17 - SoundRings::faintest) / (SoundRings::loudest - SoundRings::faintest));
    }
}

} // namespace
} // namespace trembler
