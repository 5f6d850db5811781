// The rings that are drawn around sounding objects.
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

TEST(SoundRings, SpreadFadeAndEnd) {
    Sounds sounds;
    sounds.frame = 1;
    sounds.impacts = {impactAt({1, 2}, 100), impactAt({1, 2}, 70), impactAt({3, 0}, 60),
                      impactAt({5, 0}, 20)};
    SoundRings rings;
    rings.hear(sounds);
    rings.hear(sounds);
    ASSERT_EQ(rings.rings().size(), 2U)
        << "one per place, none for the faint impact, no second one for the same frame";
    EXPECT_GT(rings.rings()[0].strength, rings.rings()[1].strength);
    double const before = rings.rings()[0].strength;
    rings.advance(0.1);
    ASSERT_EQ(rings.rings().size(), 2U);
    EXPECT_NEAR(rings.rings()[0].radius, 0.1 * SoundRings::speed, 1e-12);
    EXPECT_LT(rings.rings()[0].strength, before);
    rings.advance(0.2);
    EXPECT_EQ(rings.rings().size(), 1U) << "the fainter one ends first";
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

Sounds::Body bodyAt(ObjectId object, Vec2 at, double level) {
    Sounds::Body body;
    body.object = object;
    body.at = at;
    body.loudness = meanSquareOf(level);
    return body;
}

TEST(SoundRings, AContinuingSoundMakesRepeatedRings) {
    ObjectId const bell{1};
    ObjectId const gramophone{2};
    ObjectId const feather{3};
    Sounds sounds;
    sounds.bodies = {bodyAt(bell, {0, 1}, 80), bodyAt(feather, {9, 9}, 20)};
    Sounds::Recording recording;
    recording.object = gramophone;
    recording.at = {4, 0};
    recording.loudness = meanSquareOf(90);
    sounds.recordings = {recording};
    SoundRings rings;
    int ofBell = 0;
    int ofGramophone = 0;
    constexpr int framesPerSecond = 60;
    for (int frame = 1; frame <= 10 * framesPerSecond; ++frame) {
        rings.advance(1.0 / framesPerSecond);
        sounds.frame = static_cast<std::uint64_t>(frame);
        rings.hear(sounds);
        for (SoundRing const& ring : rings.rings()) {
            EXPECT_NE(ring.from, feather) << "too soft";
            if (ring.radius == 0) {
                (ring.from == bell ? ofBell : ofGramophone) += 1;
                EXPECT_EQ(ring.at, ring.from == bell ? (Vec2{0, 1}) : (Vec2{4, 0}));
            }
        }
    }
    // A ring of 80 dB(A) is seen for 0.8 s * 35/65 = 0.43 s, of 90 dB(A) for 0.55 s: at every second pulse.
    EXPECT_NEAR(ofBell, 12, 1);
    EXPECT_NEAR(ofGramophone, 12, 1);
}

TEST(SoundRings, AStruckObjectHasOnlyTheRingOfItsImpact) {
    ObjectId const striker{1};
    ObjectId const bell{2};
    Sounds sounds;
    SoundRings rings;
    for (int frame = 1; frame <= 300; ++frame) {
        rings.advance(1.0 / 60);
        sounds.frame = static_cast<std::uint64_t>(frame);
        sounds.bodies = {bodyAt(bell, {0, 1}, 95)};
        sounds.impacts.clear();
        if (frame % 20 == 1) {
            sounds.impacts = {impactAt({0.3, 1}, 100)};
            sounds.impacts[0].object = striker;
            sounds.impacts[0].other = bell;
        }
        rings.hear(sounds);
        for (SoundRing const& ring : rings.rings()) {
            EXPECT_EQ(ring.at, (Vec2{0.3, 1})) << "where it was hit";
        }
    }
    EXPECT_FALSE(rings.rings().empty());
}

} // namespace
} // namespace trembler
