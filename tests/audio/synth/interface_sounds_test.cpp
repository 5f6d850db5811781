// The sounds of the interface are soft and short, and begin and end in silence.
#include "audio/synth/interface_sounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

TEST(InterfaceSounds, AreSoftAndEndInSilence) {
    for (InterfaceSound const sound : {InterfaceSound::pickUp, InterfaceSound::place, InterfaceSound::refuse,
                                       InterfaceSound::run, InterfaceSound::solved, InterfaceSound::click}) {
        std::vector<float> const samples = samplesOf(sound, 48000);
        ASSERT_FALSE(samples.empty());
        EXPECT_LE(samples.size(), 1.2 * 48000);
        float loudest = 0;
        for (float const sample : samples) {
            loudest = std::max(loudest, std::abs(sample));
        }
        EXPECT_GT(loudest, 0.01F) << "no louder than whispering";
        EXPECT_LT(loudest, 0.3F) << "louder than a voice";
        EXPECT_LT(std::abs(samples.front()), 0.02F);
        EXPECT_EQ(samples.back(), 0.F);
        EXPECT_EQ(samples, samplesOf(sound, 48000));
    }
}

} // namespace
} // namespace trembler
