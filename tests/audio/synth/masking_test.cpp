// Sounds that masking omits must be inaudible.
#include "audio/effect/properties/decibel.hpp"
#include "audio/synth/masking.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler {
namespace {

Tone toneOf(double frequency, double level) {
    return {barkOf(frequency), meanSquareOf(level), hearingThreshold(frequency)};
}

TEST(Masking, ScalesAgreeWithPublishedValues) {
    // Zwicker's critical bands end at these frequencies (Hz).
    std::pair<double, double> const edges[] = {{100, 1},   {510, 5},   {1270, 10},
                                               {2700, 15}, {6400, 20}, {12000, 23}};
    for (auto const& [frequency, bark] : edges) {
        EXPECT_NEAR(barkOf(frequency), bark, 0.2) << frequency;
    }
    EXPECT_NEAR(levelOf(hearingThreshold(1000)), 3.4, 0.3);
    EXPECT_LT(levelOf(hearingThreshold(3300)), -4);
    EXPECT_GT(levelOf(hearingThreshold(40)), 40);
}

TEST(Masking, TheTableAgreesWithTheFormulas) {
    for (double f = 60; f < 20000; f *= 1.0137) {
        EXPECT_NEAR(hearingAt(f).bark, barkOf(f), 0.01) << f;
        EXPECT_NEAR(levelOf(hearingAt(f).threshold), levelOf(hearingThreshold(f)), 0.5) << f;
    }
}

TEST(Masking, AQuietToneBesideALoudOneIsDropped) {
    Masker masker;
    std::vector<std::uint8_t> audible;
    std::vector<Tone> const beside{toneOf(1000, 80), toneOf(1060, 45)};
    masker.findAudible(beside, audible);
    EXPECT_EQ(audible, (std::vector<std::uint8_t>{1, 0}));
    std::vector<Tone> const apart{toneOf(1000, 80), toneOf(400, 45)};
    masker.findAudible(apart, audible);
    EXPECT_EQ(audible, (std::vector<std::uint8_t>{1, 1})) << "masking hardly reaches down";
    std::vector<Tone> const alone{toneOf(1060, 45), toneOf(1060, -10)};
    masker.findAudible(alone, audible);
    EXPECT_EQ(audible, (std::vector<std::uint8_t>{1, 0}))
        << "sounds below the threshold of hearing are dropped as well";
}

TEST(Masking, MasksUpwardsMoreThanDownwardsAndMoreWhenLoud) {
    EXPECT_GT(maskingShare(10, 80, 12), maskingShare(10, 80, 8));
    EXPECT_GT(maskingShare(10, 90, 14), maskingShare(10, 50, 14));
    for (double z = 0; z < 24; z += 0.1) {
        EXPECT_LT(maskingShare(12, 80, z), 0.25) << "never more than the masker";
    }
}

TEST(Masking, DroppedSoundsAreMaskedByTheRemainingOnes) {
    EXPECT_TRUE(
        rc::check("per quarter Bark, all that is dropped lies below what the kept mask or below hearing", [] {
            int const count = *rc::gen::inRange(1, 200);
            std::vector<Tone> tones;
            for (int i = 0; i < count; ++i) {
                tones.push_back(toneOf(*rc::gen::inRange(30, 16000), *rc::gen::inRange(-20, 110)));
            }
            Masker masker;
            std::vector<std::uint8_t> audible;
            masker.findAudible(tones, audible);
            RC_ASSERT(audible.size() == tones.size());
            for (int bin = 0; bin < Masker::bins; ++bin) {
                double dropped = 0;
                double highest = 0;
                double covered = 0;
                double const centre = (bin + 0.5) / Masker::binsPerBark;
                for (std::size_t i = 0; i < tones.size(); ++i) {
                    if (audible[i] != 0) {
                        covered +=
                            tones[i].power * maskingShare(tones[i].bark, levelOf(tones[i].power), centre);
                    } else if (static_cast<int>(tones[i].bark * Masker::binsPerBark) == bin) {
                        dropped += tones[i].power;
                        highest = std::max(highest, tones[i].threshold);
                    }
                }
                RC_ASSERT(dropped <= std::max(covered / Masker::binsPerBark, highest) * (1 + 1e-9));
            }
        }));
}

TEST(Masking, TheLoudestIsAlwaysHeard) {
    EXPECT_TRUE(rc::check("if it can be heard at all", [] {
        std::vector<Tone> tones;
        int const count = *rc::gen::inRange(1, 50);
        for (int i = 0; i < count; ++i) {
            tones.push_back(toneOf(*rc::gen::inRange(200, 8000), *rc::gen::inRange(30, 110)));
        }
        Masker masker;
        std::vector<std::uint8_t> audible;
        masker.findAudible(tones, audible);
        std::size_t loudest = 0;
        for (std::size_t i = 1; i < tones.size(); ++i) {
            loudest = tones[i].power > tones[loudest].power ? i : loudest;
        }
        RC_ASSERT(audible[loudest] == 1);
    }));
}

} // namespace
} // namespace trembler
