// The limiter, measured by the true peak of ITU-R BS.1770, which it does not compute itself.
#include "audio/synth/limiter.hpp"
#include "runtime/math/vec2.hpp"
#include "tests/audio/synth/true_peak.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace trembler {
namespace limiter_test {
namespace {

using test::channelOf;
using test::greatestStep;
using test::inDecibels;
using test::truePeak;

using Samples = std::vector<float>; // left and right in turn

// What leaves the limiter, with the samples that it still holds at the end, in blocks of `block` pairs.
Samples limited(Samples samples, std::size_t block = 800, Limiter limiter = Limiter()) {
    samples.resize(samples.size() + 2 * static_cast<std::size_t>(limiter.latency()), 0.F);
    for (std::size_t at = 0; at < samples.size(); at += 2 * block) {
        limiter.process(std::span(samples).subspan(at, std::min(2 * block, samples.size() - at)));
    }
    return samples;
}

double truePeakOf(Samples const& samples) {
    return std::max(truePeak(channelOf(samples, 0)), truePeak(channelOf(samples, 1)));
}

double stepOf(Samples const& samples) {
    return std::max(greatestStep(channelOf(samples, 0)), greatestStep(channelOf(samples, 1)));
}

template <class Signal>
Samples made(std::size_t pairs, Signal const& signal) {
    Samples samples;
    for (std::size_t n = 0; n < pairs; ++n) {
        auto const [left, right] = signal(static_cast<double>(n) / 48000);
        samples.push_back(static_cast<float>(left));
        samples.push_back(static_cast<float>(right));
    }
    return samples;
}

Samples tone(double frequency, double amplitude, std::size_t pairs = 9600) {
    return made(pairs, [&](double t) {
        double const value = amplitude * std::sin(2 * pi * frequency * t + pi / 4);
        return std::pair(value, 0.5 * value);
    });
}

// Struck modes and clicks at random times, up to 40 dB above full scale, over quiet noise.
Samples impacts(unsigned seed, std::size_t pairs = 24000) {
    std::mt19937 random(seed);
    auto const unit = [&] { return static_cast<double>(random() >> 8U) * 0x1p-24; };
    Samples samples(2 * pairs, 0.F);
    for (int i = 0; i < 40; ++i) {
        double const frequency = 20 * std::pow(1000.0, unit());
        double const decay = 3 * std::pow(1000.0, unit());
        double const amplitude = 0.01 * std::pow(1e4, unit());
        double const pan = unit();
        auto const begin = static_cast<std::size_t>(unit() * static_cast<double>(pairs));
        double const phase = unit() < 0.5 ? 0 : pi / 2; // half of them begin with a step
        for (std::size_t n = begin; n < pairs; ++n) {
            double const t = static_cast<double>(n - begin) / 48000;
            double const value = amplitude * std::exp(-decay * t) * std::sin(2 * pi * frequency * t + phase);
            samples[2 * n] += static_cast<float>(pan * value);
            samples[2 * n + 1] += static_cast<float>((1 - pan) * value);
        }
    }
    return samples;
}

TEST(Limiter, TheMeasureFindsPeaksBetweenTheSamples) {
    // At a quarter of the rate, with this phase, each sample is 3 dB below the peak of the tone.
    Samples const between = channelOf(tone(12000, 1), 0);
    double sampled = 0;
    for (float const sample : between) {
        sampled = std::max(sampled, static_cast<double>(std::abs(sample)));
    }
    EXPECT_NEAR(sampled, std::sqrt(0.5), 1e-3);
    EXPECT_NEAR(inDecibels(truePeak(std::span(between).subspan(100, 4000))), 0, 0.4);
}

TEST(Limiter, AQuietMixOnlyLeavesLater) {
    Limiter const model;
    std::mt19937 random(36);
    Samples const noise = made(6000, [&](double) {
        auto const unit = [&] { return static_cast<double>(random() >> 8U) * 0x1p-24 - 0.5; };
        return std::pair(0.44 * unit(), 0.44 * unit());
    });
    Samples const loud = made(6000, [](double t) {
        double const value = 0.84 * std::sin(2 * pi * 1000 * t);
        return std::pair(value, -value);
    });
    for (Samples const& quiet : {noise, loud}) {
        Samples const out = limited(quiet);
        auto const delay = 2 * static_cast<std::size_t>(model.latency());
        ASSERT_EQ(out.size(), quiet.size() + delay);
        EXPECT_TRUE(std::equal(quiet.begin(), quiet.end(), out.begin() + static_cast<std::ptrdiff_t>(delay)))
            << "bit for bit";
        EXPECT_EQ(std::count(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(delay), 0.F),
                  static_cast<std::ptrdiff_t>(delay));
    }
    EXPECT_EQ(model.latency(), 83) << "1.7 ms at 48 kHz";
}

TEST(Limiter, NoTruePeakExceedsOneDecibelBelowFullScale) {
    for (double const frequency : {30.0, 440.0, 997.0, 1999.0, 4000.0, 8000.0, 12000.0, 15999.0, 19000.0}) {
        for (double const amplitude : {0.9, 1.5, 10.0, 1000.0}) {
            EXPECT_LE(inDecibels(truePeakOf(limited(tone(frequency, amplitude)))), -1)
                << frequency << " Hz at " << amplitude;
        }
    }
    double loudest = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        Samples const mix = impacts(seed);
        EXPECT_GT(truePeakOf(mix), 1) << seed;
        double const peak = truePeakOf(limited(mix));
        EXPECT_LE(inDecibels(peak), -1) << seed;
        loudest = std::max(loudest, peak);
    }
    EXPECT_GE(inDecibels(loudest), -2) << "and it takes no more than it must";
}

TEST(Limiter, NoStepExceedsHalfOfFullScale) {
    for (double const frequency : {5000.0, 10000.0, 15000.0, 23000.0}) {
        double const step = stepOf(limited(tone(frequency, 0.9)));
        EXPECT_LE(step, 0.5) << frequency;
        EXPECT_GE(step, 0.4) << frequency << ": no quieter than necessary";
    }
    for (unsigned seed = 0; seed < 12; ++seed) {
        Samples const mix = impacts(seed);
        EXPECT_GT(stepOf(mix), 0.5) << seed;
        EXPECT_LE(stepOf(limited(mix)), 0.5) << seed;
    }
    // A step from one extreme to the other, which stays there.
    Samples const square =
        made(4000, [](double t) { return std::pair(t < 0.04 ? -9.0 : 9.0, t < 0.04 ? -0.3 : 0.3); });
    EXPECT_LE(stepOf(limited(square)), 0.5);
}

TEST(Limiter, ASinglePeakIsMetAtOnceAndLetGoSlowly) {
    LimiterOptions const options;
    Samples steady = tone(1000, 0.1, 62000);
    std::size_t const at = 10000;
    steady[2 * at] = 4;
    Samples const out = limited(steady);
    Limiter const model;
    auto const gainAt = [&](std::size_t n) { // of the right channel, which has no peak of its own
        double in = 0;
        double after = 0;
        for (std::size_t i = n; i < n + 48; ++i) { // one period
            in = std::max(in, static_cast<double>(std::abs(steady[2 * i + 1])));
            after = std::max(after, static_cast<double>(std::abs(
                                        out[2 * (i + static_cast<std::size_t>(model.latency())) + 1])));
        }
        return after / in;
    };
    double const least = options.step / 4; // the peak begins and ends with a step
    EXPECT_EQ(gainAt(at - 200), 1) << "before the look-ahead nothing changes";
    EXPECT_NEAR(gainAt(at), least, 0.02) << "both channels have the same gain";
    for (double const seconds : {0.05, 0.1, 0.2, 0.4}) {
        double const expected = 1 - (1 - least) * std::exp(-seconds / options.release);
        EXPECT_NEAR(gainAt(at + static_cast<std::size_t>(seconds * 48000)), expected, 0.02) << seconds;
    }
    EXPECT_EQ(gainAt(at + 48000), 1) << "after a second nothing is left of it";
}

TEST(Limiter, BlocksOfAnySizeMakeTheSameSamples) {
    Samples const mix = impacts(7, 6000);
    Samples const whole = limited(mix, 1000000);
    for (std::size_t const block : {1U, 7U, 83U, 800U}) {
        EXPECT_EQ(limited(mix, block), whole) << block;
    }
}

TEST(Limiter, ClearForgetsEverything) {
    Limiter used;
    Samples loud = tone(200, 50);
    used.process(loud);
    EXPECT_NE(limited(impacts(3, 4000), 800, used), limited(impacts(3, 4000)));
    used.clear();
    EXPECT_EQ(limited(impacts(3, 4000), 800, used), limited(impacts(3, 4000)));
}

TEST(Limiter, NumbersThatAreNotFiniteAreSilence) {
    Samples broken = tone(500, 0.5);
    broken[4000] = std::numeric_limits<float>::infinity();
    broken[4001] = -std::numeric_limits<float>::infinity();
    broken[6000] = std::numeric_limits<float>::quiet_NaN();
    broken[8000] = std::numeric_limits<float>::max();
    for (float const sample : limited(broken)) {
        ASSERT_TRUE(std::isfinite(sample));
        ASSERT_LE(std::abs(sample), 0.8913F);
    }
}

TEST(Limiter, WorksAtOtherRates) {
    for (int const rate : {8000, 44100, 96000, 192000}) {
        LimiterOptions options;
        options.rate = rate;
        Limiter const limiter(options);
        EXPECT_NEAR(limiter.latency(), 0.0015 * rate + 11, 1) << rate;
        EXPECT_LE(inDecibels(truePeakOf(limited(impacts(5, 8000), 800, limiter))), -1) << rate;
    }
}

} // namespace
} // namespace limiter_test
} // namespace trembler
