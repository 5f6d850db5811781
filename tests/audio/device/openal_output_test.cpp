// OpenAL output, rendered into memory.
#include "audio/device/openal_output.hpp"
#include "tests/audio/synth/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler {
namespace openal_output_test {
namespace {

using test::meanSquareIn;

constexpr SynthesiserOptions format;

struct Tone {
    Vec2 at;
    double frequency = 440;
    double pressure = 0.2; // Pa
};

struct Heard {
    std::vector<float> left;
    std::vector<float> right;
};

/// Plays tones for `blocks` blocks, then silence for `after` blocks.
Heard hear(std::vector<Tone> const& tones, int blocks, Listener const& listener, OutputSettings settings = {},
           RoomAcoustics const& room = {}, int after = 0) {
    std::string why;
    auto const output = OpenAlOutput::loopback(format, why);
    if (!output) {
        ADD_FAILURE() << why;
        return {};
    }
    output->set(settings);
    output->set(room);
    Heard heard;
    for (int b = 0; b < blocks + after; ++b) {
        std::vector<std::vector<float>> samples;
        std::vector<Voice> voices;
        for (std::size_t i = 0; b < blocks && i < tones.size(); ++i) {
            std::vector<float> block;
            for (int n = 0; n < format.block; ++n) {
                double const t = (b * format.block + n) / 48000.0;
                block.push_back(
                    static_cast<float>(tones[i].pressure * std::sin(2 * pi * tones[i].frequency * t)));
            }
            samples.push_back(std::move(block));
        }
        for (std::size_t i = 0; i < samples.size(); ++i) {
            voices.push_back({i + 1, {}, tones[i].at, {}, samples[i], meanSquareIn(samples[i])});
        }
        output->play(voices, listener);
        for (std::size_t n = 0; n + 1 < output->rendered().size(); n += 2) {
            heard.left.push_back(output->rendered()[n]);
            heard.right.push_back(output->rendered()[n + 1]);
        }
    }
    EXPECT_EQ(output->slips(), 0U) << "no stream has run out of samples";
    return heard;
}

double levelDifference(std::vector<float> const& a, std::vector<float> const& b) {
    return 10 * std::log10(meanSquareIn(a) / meanSquareIn(b));
}

TEST(OpenAlOutput, ASoundOnTheLeftIsLouderOnTheLeft) {
    for (bool const hrtf : {false, true}) {
        OutputSettings settings;
        settings.hrtf = hrtf;
        Heard const left = hear({{{-2, 0}}}, 30, {{0, 0}, 2, {}}, settings);
        EXPECT_GT(levelDifference(left.left, left.right), 3) << hrtf;
        Heard const right = hear({{{2, 0}}}, 30, {{0, 0}, 2, {}}, settings);
        EXPECT_LT(levelDifference(right.left, right.right), -3) << hrtf;
        Heard const middle = hear({{{0, 0}}}, 30, {{0, 0}, 2, {}}, settings);
        EXPECT_NEAR(levelDifference(middle.left, middle.right), 0, 0.5) << hrtf;
        Heard const moved = hear({{{5, 3}}}, 30, {{7, 3}, 2, {}}, settings);
        EXPECT_GT(levelDifference(moved.left, moved.right), 3) << "left of the listener, at any place";
    }
}

TEST(OpenAlOutput, HeadphonesGetOtherSamplesThanLoudspeakers) {
    OutputSettings settings;
    settings.hrtf = true;
    EXPECT_NE(hear({{{-2, 0}}}, 20, {{0, 0}, 2, {}}, settings).left,
              hear({{{-2, 0}}}, 20, {{0, 0}, 2, {}}).left);
}

TEST(OpenAlOutput, TwiceAsFarIsSixDecibelsLess) {
    double before = 0;
    for (double const height : {1.0, 2.0, 4.0, 8.0}) {
        double const power = meanSquareIn(hear({{{0, 0}}}, 30, {{0, 0}, height, {}}).left);
        if (before > 0) {
            EXPECT_NEAR(10 * std::log10(before / power), 6.02, 0.1);
        }
        before = power;
    }
}

TEST(OpenAlOutput, KeepsThePitch) {
    Heard const heard = hear({{{1, 0}, 1000}}, 60, {{0, 0}, 2, {}});
    std::span<float const> const steady = std::span(heard.left).subspan(4000);
    EXPECT_NEAR(test::peakNear(steady, 48000, 1000, 30), 1000, 0.2);
    // The seams between blocks cannot be heard: at most a thousandth of the power is outside the tone.
    double const tone = std::norm(test::toneIn(steady, 48000, 1000)) / 2;
    EXPECT_NEAR(meanSquareIn(steady) / tone, 1, 1e-3);
}

TEST(OpenAlOutput, SilenceIsSilent) {
    Heard const heard = hear({}, 20, {});
    EXPECT_EQ(meanSquareIn(heard.left), 0);
    EXPECT_EQ(meanSquareIn(heard.right), 0);
    Heard const ended = hear({{{0, 0}}}, 20, {}, {}, {}, 20);
    EXPECT_EQ(meanSquareIn(std::span(ended.left).last(8000)), 0) << "so is a tone that has ended";
}

TEST(OpenAlOutput, EqualStreamsMakeEqualSamples) {
    std::vector<Tone> tones;
    for (int i = 0; i < 40; ++i) {
        tones.push_back({{0.3 * i - 5, 0.1 * i}, 200.0 + 57 * i, 0.02});
    }
    RoomAcoustics room;
    room.volume = 100;
    room.surface = 140;
    room.reverberation = 2;
    room.echo = 1;
    for (bool const hrtf : {false, true}) {
        OutputSettings settings;
        settings.hrtf = hrtf;
        Heard const once = hear(tones, 40, {{0, 0}, 3, {}}, settings, room, 20);
        Heard const again = hear(tones, 40, {{0, 0}, 3, {}}, settings, room, 20);
        EXPECT_EQ(once.left, again.left);
        EXPECT_EQ(once.right, again.right);
    }
}

TEST(OpenAlOutput, StreamsBeyondTheLimitAreMixedAndHeard) {
    auto const power = [](std::size_t count) {
        std::vector<Tone> tones;
        for (std::size_t i = 0; i < count; ++i) {
            tones.push_back({{0, 0}, 300.0 + 61 * static_cast<double>(i), 0.01});
        }
        return meanSquareIn(hear(tones, 40, {{0, 0}, 2, {}}).left);
    };
    double const places = power(OpenAlOutput::mostPlaces);
    double const more = power(2 * OpenAlOutput::mostPlaces);
    EXPECT_NEAR(10 * std::log10(more / places), 3.01, 0.3);
}

TEST(OpenAlOutput, StoneEchoesLongerThanCarpet) {
    RoomAcoustics room;
    room.volume = 118;
    room.surface = 146;
    room.echo = 1;
    OutputSettings dry;
    dry.reverb = false;
    auto const tail = [&](double seconds, OutputSettings const& settings = {}) {
        room.reverberation = seconds;
        return hear({{{0, 0}, 700}}, 60, {{0, 0}, 2, {}}, settings, room, 60).left;
    };
    std::vector<float> const stone = tail(4);
    std::vector<float> const carpet = tail(0.4);
    std::size_t const end = 62 * 800; // the tone has left the queue
    double const early = meanSquareIn(std::span(stone).subspan(end + 2400, 4800));
    double const late = meanSquareIn(std::span(stone).subspan(end + 2400 + 24000, 4800));
    EXPECT_NEAR(10 * std::log10(early / late), 60 * 0.5 / 4, 4) << "60 dB in 4 s, over half a second";
    EXPECT_LT(meanSquareIn(std::span(carpet).subspan(end + 24000, 4800)), 0.001 * late);
    std::vector<float> const none = tail(4, dry);
    EXPECT_EQ(meanSquareIn(std::span(none).subspan(end + 2400, 4800)), 0);
}

TEST(OpenAlOutput, VolumeTurnsItDown) {
    OutputSettings half;
    half.volume = 0.4;
    OutputSettings off;
    off.volume = 0;
    double const full = meanSquareIn(hear({{{0, 0}}}, 20, {}).left); // 0.8
    EXPECT_NEAR(full / meanSquareIn(hear({{{0, 0}}}, 20, {}, half).left), 4, 0.05);
    EXPECT_EQ(meanSquareIn(hear({{{0, 0}}}, 20, {}, off).left), 0);
}

TEST(OpenAlOutput, ReportsWhyThereIsNoDevice) {
    std::string why;
    EXPECT_EQ(OpenAlOutput::open(format, why), nullptr) << "silent_machine.cpp disables all drivers";
    EXPECT_FALSE(why.empty());
}

} // namespace
} // namespace openal_output_test
} // namespace trembler
