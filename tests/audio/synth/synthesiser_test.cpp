// Worlds rendered to samples: pitch, loudness, brightness, decay, Doppler, masking, recordings.
#include "audio/effect/properties/acoustic_material.hpp"
#include "audio/synth/synthesiser.hpp"
#include "tests/audio/effect/listening_room.hpp"
#include "tests/audio/synth/spectrum.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace trembler {
namespace synthesiser_test {
namespace {

using test::centroid;
using test::ListeningRoom;
using test::meanSquareIn;
using test::peakNear;

constexpr double rate = 48000;
constexpr SynthesiserOptions plain{.masking = false, .doppler = false, .compression = 1};

/// The samples that the synthesiser makes of one object, or of all.
std::vector<float> listen(ListeningRoom& room, int frames, SynthesiserOptions options = plain,
                          ObjectId only = {}, SampleSource* source = nullptr, Listener listener = {}) {
    Synthesiser synthesiser(options, source);
    std::vector<float> out;
    Subscription const wantedSounds = room.world->want<Sounds>();
    for (int i = 0; i < frames; ++i) {
        room.run(1);
        synthesiser.hear(room.sounds(), listener);
        std::vector<float> mix(static_cast<std::size_t>(options.block), 0);
        for (Voice const& voice : synthesiser.render()) {
            for (std::size_t n = 0; n < mix.size() && (!only.valid() || voice.object == only); ++n) {
                mix[n] += voice.samples[n];
            }
        }
        out.insert(out.end(), mix.begin(), mix.end());
    }
    return out;
}

/// From the first sample that is not zero.
std::span<float const> fromFirst(std::vector<float> const& samples) {
    auto const at = std::find_if(samples.begin(), samples.end(), [](float s) { return s != 0; });
    return std::span(samples).subspan(static_cast<std::size_t>(at - samples.begin()));
}

/// A bar hanging in the air, weightless, that a small ball hits near its end.
struct Xylophone {
    Xylophone(double length, double thickness, Material material, double speed,
              Material beater = Material::steel) {
        room.give(room.world->store().find("world"), GravityField{{0, 0}});
        bar = room.body("bar", material, boxPiece(length, thickness), {0, 0});
        ball = room.body("ball", beater, circlePiece(0.02), {0.46 * length, 0.3});
        room.give(ball, Velocity{{0, -speed}});
        room.give(ball, Density{1000});
    }
    ListeningRoom room;
    ObjectId bar;
    ObjectId ball;
};

TEST(Synthesiser, AStruckBarHasTheFrequenciesOfEulerAndBernoulli) {
    Xylophone x(0.8, 0.02, Material::steel, 4);
    auto const out = listen(x.room, 90, plain, x.bar);
    auto const sound = fromFirst(out).subspan(2000);
    // f = β² / (2π L²) sqrt(E I / (ρ A)), with I/A = h²/12 of a rectangle.
    double const lowest =
        4.73004074 * 4.73004074 / (2 * pi * 0.64) * std::sqrt(200e9 / 7850 * 0.02 * 0.02 / 12);
    double const ratios[] = {1, 2.7565, 5.4039, 8.9330, 13.3443};
    double const measured = peakNear(sound, rate, lowest, 0.1 * lowest);
    EXPECT_NEAR(measured, lowest, 0.002 * lowest);
    for (double const ratio : ratios) {
        double const expected = ratio * lowest;
        EXPECT_NEAR(peakNear(sound, rate, expected, 0.05 * expected) / measured, ratio, 0.002 * ratio);
    }
}

TEST(Synthesiser, TheSameImpactOnHalfTheBarIsTwoOctavesHigher) {
    Xylophone whole(0.8, 0.02, Material::steel, 4);
    Xylophone half(0.4, 0.02, Material::steel, 4);
    auto const low = listen(whole.room, 60, plain, whole.bar);
    auto const high = listen(half.room, 60, plain, half.bar);
    double const f = peakNear(fromFirst(low).subspan(2000), rate, 162, 30);
    EXPECT_NEAR(peakNear(fromFirst(high).subspan(2000), rate, 4 * f, 40) / f, 4, 0.01);
}

TEST(Synthesiser, SilenceIsSilent) {
    ListeningRoom room;
    room.body("bar", Material::steel, boxPiece(1, 0.05), {0, 100});
    for (float const s : listen(room, 30)) {
        ASSERT_EQ(s, 0);
    }
}

TEST(Synthesiser, EqualWorldsMakeEqualSamples) {
    auto const render = [] {
        ListeningRoom room;
        room.fixed("floor", Material::stone, boxPiece(10, 0.4), {0, -0.2});
        for (int i = 0; i < 6; ++i) {
            ObjectId const id =
                room.body("thing " + std::to_string(i), static_cast<Material>(i),
                          i % 2 == 0 ? boxPiece(0.4, 0.1) : circlePiece(0.1), {0.5 * i, 0.4 + 0.3 * i});
            room.give(id, Velocity{{1, 0}});
        }
        return listen(room, 180, {});
    };
    auto const once = render();
    EXPECT_GT(meanSquareIn(once), 0);
    EXPECT_EQ(once, render());
}

TEST(Synthesiser, HarderIsLouderAndBrighter) {
    double louder = 0;
    double brighter = 0;
    for (double const speed : {0.3, 1.0, 3.0}) {
        for (double const compression : {1.0, 0.35}) {
            Xylophone x(0.8, 0.05, Material::steel, speed, Material::plastic);
            SynthesiserOptions options = plain;
            options.compression = compression;
            auto const out = listen(x.room, 90, options, x.bar);
            auto const sound = fromFirst(out).subspan(0, 24000);
            if (compression == 1) {
                EXPECT_GT(meanSquareIn(sound), 4 * louder) << speed;
                EXPECT_GT(centroid(sound, rate), brighter) << speed;
                louder = meanSquareIn(sound);
                brighter = centroid(sound, rate);
            } else {
                EXPECT_LE(meanSquareIn(sound), louder * (1 + 1e-6)) << "compressed";
            }
        }
    }
}

TEST(Synthesiser, MaterialsDieAwayAtTheirOwnPace) {
    struct Tone {
        double frequency = 0;
        double decay = 0;
    };
    auto const lowest = [](Material material) {
        Xylophone x(0.5, 0.02, material, 3);
        x.room.give(x.bar, Density{acousticMaterial(material).density});
        auto const out = listen(x.room, 90, plain, x.bar);
        // After the tenth of a second in which higher modes, and the impact itself, die away.
        auto const sound = fromFirst(out).subspan(4800);
        double const expected =
            x.room.sounding(x.bar) == nullptr ? 0 : x.room.sounding(x.bar)->rings[0].frequency;
        double const f = peakNear(sound.subspan(0, 9600), rate, expected, 0.05 * expected);
        double const early = std::abs(test::toneIn(sound.subspan(0, 9600), rate, f));
        double const late = std::abs(test::toneIn(sound.subspan(9600, 9600), rate, f));
        EXPECT_NEAR(std::log(early / late) / 0.2, x.room.sounding(x.bar)->rings[0].decay,
                    0.02 * x.room.sounding(x.bar)->rings[0].decay);
        return Tone{f, std::log(early / late) / 0.2};
    };
    Tone const steel = lowest(Material::steel);
    Tone const glass = lowest(Material::glass);
    Tone const wood = lowest(Material::wood);
    EXPECT_LT(1.5 * steel.decay, glass.decay);
    EXPECT_LT(1.5 * glass.decay, wood.decay);
    // The material's own damping is π f η. The rest is radiation, ρ c S σ / 2 M, which is less for heavy
    // bodies.
    EXPECT_GT(steel.decay, pi * steel.frequency * 0.0012);
    EXPECT_LT(steel.decay, pi * steel.frequency * 0.0012 + 413 * 0.1 / (2 * 7.85));
}

TEST(Synthesiser, TheSamplesHaveTheLevelOfTheSimulation) {
    // The samples' power and the resolver's bookkeeping must agree, mode by mode.
    Xylophone x(0.8, 0.02, Material::copper, 3);
    auto const out = listen(x.room, 90, plain, x.bar);
    double booked = 0;
    for (Sounds::Ring const& ring : x.room.sounding(x.bar)->rings) {
        booked += ring.meanSquare;
    }
    std::span<float const> const last = std::span(out).last(800);
    EXPECT_NEAR(10 * std::log10(meanSquareIn(last) / booked), 0, 1.0);
}

TEST(Synthesiser, AnApproachingSourceSoundsHigher) {
    for (double const speed : {-30.0, 0.0, 30.0}) {
        ListeningRoom room;
        room.give(room.world->store().find("world"), GravityField{{0, 0}});
        ObjectId const bar = room.body("bar", Material::steel, boxPiece(0.8, 0.02), {-100, 0});
        ObjectId const ball = room.body("ball", Material::steel, circlePiece(0.02), {-99.7, 0.1});
        room.give(bar, Velocity{{speed, 0}});
        room.give(ball, Velocity{{speed, -4}});
        SynthesiserOptions options = plain;
        options.doppler = true;
        auto const out = listen(room, 60, options, bar, nullptr, {{100, 0}, 1, {}});
        double const still = 162.14;
        double const expected = still * 343 / (343 - speed);
        EXPECT_NEAR(peakNear(fromFirst(out).subspan(2000), rate, expected, 20), expected, 0.005 * expected)
            << speed;
    }
}

TEST(Synthesiser, MaskingSavesModesAndCannotBeHeard) {
    auto const crash = [](bool masking, std::size_t* rendered, std::size_t* modes) {
        ListeningRoom room({.threads = 1, .detail = {{"sound", "32-modes"}}, .periods = {}, .trace = false});
        room.fixed("floor", Material::steel, boxPiece(10, 0.4), {0, -0.2});
        for (int i = 0; i < 20; ++i) {
            room.body("bar " + std::to_string(i), i % 2 == 0 ? Material::steel : Material::glass,
                      boxPiece(0.5 + 0.02 * i, 0.3), {-3 + 0.6 * i, 0.3 + 0.02 * i}, 0.1 * i);
        }
        Subscription const wantedSounds = room.world->want<Sounds>();
        SynthesiserOptions options = plain;
        options.masking = masking;
        Synthesiser synthesiser(options);
        std::vector<float> out;
        for (int i = 0; i < 60; ++i) {
            room.run(1);
            synthesiser.hear(room.sounds(), {{0, 0}, 2, {}});
            std::vector<float> mix(800, 0);
            for (Voice const& voice : synthesiser.render()) {
                // As at the listener's ear.
                double const gain = 1 / std::max(1.0, std::hypot(length(voice.at), 2));
                for (std::size_t n = 0; n < mix.size(); ++n) {
                    mix[n] += static_cast<float>(gain) * voice.samples[n];
                }
            }
            *rendered += synthesiser.counts().rendered;
            *modes += synthesiser.counts().modes;
            out.insert(out.end(), mix.begin(), mix.end());
        }
        return out;
    };
    std::size_t rendered = 0;
    std::size_t modes = 0;
    std::size_t all = 0;
    std::size_t unused = 0;
    auto const culled = crash(true, &rendered, &modes);
    auto const whole = crash(false, &all, &unused);
    EXPECT_LT(rendered, modes * 3 / 4) << "masking must save modes";
    EXPECT_EQ(all, unused);
    // Brute force over the samples: in every stretch and every critical band the omitted sound is below the
    // masking threshold of the whole spectrum, or below the threshold of hearing.
    constexpr std::size_t stretch = 4096;
    int checked = 0;
    for (std::size_t at = 0; at + stretch <= whole.size(); at += stretch) {
        std::vector<float> missing(stretch);
        for (std::size_t n = 0; n < stretch; ++n) {
            missing[n] = whole[at + n] - culled[at + n];
        }
        auto const full = test::powerSpectrum(std::span(whole).subspan(at, stretch));
        auto const lost = test::powerSpectrum(missing);
        std::array<double, 26> fullBand{};
        std::array<double, 26> lostBand{};
        std::array<double, 26> threshold{};
        // Parseval, with the window's mean square of 3/8.
        double const scale = 2.0 / (stretch * stretch * 0.375);
        for (std::size_t k = 1; k < full.size(); ++k) {
            double const frequency = static_cast<double>(k) * rate / stretch;
            auto const band = static_cast<std::size_t>(barkOf(frequency));
            fullBand[band] += scale * full[k];
            lostBand[band] += scale * lost[k];
            threshold[band] = std::max(threshold[band], hearingThreshold(frequency));
        }
        for (std::size_t band = 0; band < 25; ++band) {
            double masked = 4 * threshold[band]; // the threshold holds for each quarter of the band
            for (std::size_t from = 0; from < 25; ++from) {
                masked +=
                    fullBand[from] * maskingShare(static_cast<double>(from) + 0.5, levelOf(fullBand[from]),
                                                  static_cast<double>(band) + 0.5);
            }
            // A stretch has five blocks, and the spectrum mixes impacts within it: 3 dB of tolerance.
            EXPECT_LE(lostBand[band], 2 * masked)
                << "band " << band << " at " << static_cast<double>(at) / rate;
            checked += lostBand[band] > 0 ? 1 : 0;
        }
        double const all = std::accumulate(fullBand.begin(), fullBand.end(), 0.0);
        if (levelOf(all) > 60) {
            EXPECT_LT(std::accumulate(lostBand.begin(), lostBand.end(), 0.0), 0.01 * all)
                << "20 dB below the rest";
        }
    }
    EXPECT_GT(checked, 20);
}

class OneSample final : public SampleSource {
public:
    OneSample() {
        auto data = std::make_shared<SampleData>();
        data->rate = 32000;
        for (int n = 0; n < 16000; ++n) {
            data->samples.push_back(static_cast<float>(0.4 * std::sin(2 * pi * 1000 * n / 32000.0)));
        }
        data->finish();
        data_ = data;
    }
    std::shared_ptr<SampleData const> find(std::string const& file) override {
        return file == "beep.wav" ? data_ : nullptr;
    }

private:
    std::shared_ptr<SampleData const> data_;
};

ObjectId addBeeper(ListeningRoom& room, std::string const& file) {
    ObjectId const id = room.world->store().create("beeper");
    room.give(id, Position{{0, 0}});
    room.give(id, Conductor{});
    room.give(id, ElectricalSource{});
    Sample sample;
    sample.file = file;
    sample.cue = SampleCue::powered;
    sample.level = 74;
    room.give(id, sample);
    return id;
}

TEST(Synthesiser, RecordingsPlayAtTheirPitchAndLevel) {
    OneSample source;
    ListeningRoom room;
    ObjectId const beeper = addBeeper(room, "beep.wav");
    auto const out = listen(room, 90, plain, {}, &source);
    auto const sound = fromFirst(out).subspan(800, 48000);
    EXPECT_NEAR(peakNear(sound, rate, 1000, 50), 1000, 1) << "resampled, and looped without a seam";
    EXPECT_NEAR(levelOf(meanSquareIn(sound)), 74, 0.1);
    room.world->store().column<ElectricalSource>().remove(beeper);
    auto const after = listen(room, 90, plain, {}, &source);
    EXPECT_EQ(meanSquareIn(std::span(after).last(4000)), 0) << "it ends when the power fails";
}

TEST(Synthesiser, AMissingRecordingIsSilent) {
    OneSample source;
    ListeningRoom room;
    addBeeper(room, "gone.wav");
    EXPECT_EQ(meanSquareIn(listen(room, 30, plain, {}, &source)), 0);
    EXPECT_EQ(meanSquareIn(listen(room, 30, plain, {}, nullptr)), 0);
}

TEST(Synthesiser, AFrameIsHeardOnceAndSoundsContinueInAPause) {
    Xylophone x(0.8, 0.02, Material::steel, 4);
    Subscription const wantedSounds = x.room.world->want<Sounds>();
    ASSERT_TRUE(x.room.runToImpact());
    Synthesiser once(plain);
    once.hear(x.room.sounds(), {});
    double const first = once.render().front().power;
    once.hear(x.room.sounds(), {}); // the world is paused
    double const second = once.render().front().power;
    EXPECT_GT(second, 0) << "it rings on";
    EXPECT_LT(second, 2 * first) << "but is not struck again";
}

} // namespace
} // namespace synthesiser_test
} // namespace trembler
