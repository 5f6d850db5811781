// Oscillators compared with the closed form of a damped sine.
#include "audio/effect/properties/decibel.hpp"
#include "audio/synth/modal_bank.hpp"
#include "tests/audio/synth/spectrum.hpp"

#include <gtest/gtest.h>

#include <random>

namespace trembler {
namespace modal_bank_test {
namespace {

constexpr double rate = 48000;
constexpr int block = 800;

std::vector<float> rendered(ModalBank& bank, int blocks, std::span<std::uint8_t const> audible = {}) {
    std::vector<std::uint8_t> const all(bank.size(), 1);
    std::vector<float> out(static_cast<std::size_t>(blocks * block), 0);
    ModalScratch scratch;
    for (int b = 0; b < blocks; ++b) {
        bank.render(std::span(out).subspan(static_cast<std::size_t>(b * block), block),
                    audible.empty() ? all : audible, static_cast<std::uint64_t>(b), scratch);
    }
    return out;
}

std::vector<Sounds::Ring> someRings(int count) {
    std::vector<Sounds::Ring> rings;
    for (int i = 0; i < count; ++i) {
        rings.push_back({.frequency = 60 + 411.7 * i, .decay = 1 + 0.9 * i});
    }
    return rings;
}

TEST(ModalBank, IsTheSumOfDampedSines) {
    for (int const count : {1, 3, 8, 9, 13, 21, 32}) {
        auto const rings = someRings(count);
        ModalBank bank(rate);
        bank.tune(rings, 1, 0);
        std::vector<double> amplitudes;
        for (int i = 0; i < count; ++i) {
            amplitudes.push_back(i % 2 == 0 ? 0.5 / (i + 1) : -0.3 / (i + 1));
        }
        int const start = 137;
        bank.strike(amplitudes, 2, start);
        auto const out = rendered(bank, 60);
        double worst = 0;
        for (std::size_t n = 0; n < out.size(); ++n) {
            double expected = 0;
            double const t = (static_cast<double>(n) - start) / rate;
            for (int i = 0; t >= 0 && i < count; ++i) {
                auto const m = static_cast<std::size_t>(i);
                expected += 2 * amplitudes[m] * std::exp(-rings[m].decay * t) *
                            std::sin(2 * pi * rings[m].frequency * t);
            }
            worst = std::max(worst, std::abs(static_cast<double>(out[n]) - expected));
        }
        EXPECT_LT(worst, 3e-4) << count << " modes: 70 dB below the signal, after a second";
    }
}

TEST(ModalBank, IsSilentUntilStruckAndBeginsWithoutAClick) {
    ModalBank bank(rate);
    bank.tune(someRings(8), 1, 0);
    for (float const s : rendered(bank, 3)) {
        ASSERT_EQ(s, 0);
    }
    std::vector<double> const amplitudes(8, 1);
    bank.strike(amplitudes, 1, 0);
    EXPECT_EQ(rendered(bank, 1)[0], 0) << "the pressure begins at zero";
}

TEST(ModalBank, MaskedModesComeBackInPhase) {
    auto const rings = someRings(4);
    std::vector<double> const amplitudes{1, 0.5, 0.25, 0.125};
    std::vector<std::uint8_t> const some{1, 0, 1, 0};
    ModalBank whole(rate);
    ModalBank part(rate);
    for (ModalBank* bank : {&whole, &part}) {
        bank->tune(rings, 1, 0);
        bank->strike(amplitudes, 1, 55);
    }
    rendered(whole, 7);
    rendered(part, 7, some);
    auto const expected = rendered(whole, 1);
    auto const found = rendered(part, 1);
    for (std::size_t n = 0; n < expected.size(); ++n) {
        ASSERT_NEAR(found[n], expected[n], 2e-4);
    }
}

TEST(ModalBank, ImpactsAddUpWhateverTheirOrder) {
    std::vector<double> const soft{0.1, 0.2, 0.3};
    std::vector<double> const hard{1, -1, 0.5};
    ModalBank forth(rate);
    ModalBank back(rate);
    forth.tune(someRings(3), 1, 0);
    back.tune(someRings(3), 1, 0);
    forth.strike(soft, 1, 100);
    forth.strike(hard, 1, 300);
    back.strike(hard, 1, 300);
    back.strike(soft, 1, 100);
    EXPECT_EQ(rendered(forth, 2), rendered(back, 2));
}

TEST(ModalBank, BanksThatShareScratchSoundAsAlone) {
    std::vector<std::vector<float>> alone;
    std::vector<std::vector<float>> shared;
    ModalScratch scratch;
    std::vector<ModalBank> banks;
    auto const strike = [](ModalBank& bank, int modes) {
        std::vector<double> const amplitudes(static_cast<std::size_t>(modes), 0.3);
        bank.tune(someRings(modes), 1, 0);
        bank.strike(amplitudes, 1, 11 * modes);
        bank.scrape(amplitudes, modes % 2 == 0 ? 1 : 0); // some are driven by a noise
    };
    for (int const modes : {30, 1, 18, 5}) {
        ModalBank bank(rate);
        strike(bank, modes);
        alone.push_back(rendered(bank, 1));
        strike(banks.emplace_back(rate), modes);
    }
    for (ModalBank& bank : banks) {
        std::vector<float>& out = shared.emplace_back(static_cast<std::size_t>(block), 0.F);
        bank.render(out, std::vector<std::uint8_t>(bank.size(), 1), 0, scratch);
    }
    EXPECT_EQ(alone, shared);
}

TEST(ModalBank, ScrapingSettlesWhereDrivingAndDampingBalance) {
    std::vector<Sounds::Ring> const rings{{.frequency = 700, .decay = 30}};
    std::vector<double> const drive{0.8};
    ModalBank bank(rate);
    bank.tune(rings, 1, 0);
    std::vector<std::uint8_t> const all(1, 1);
    ModalScratch scratch;
    double sum = 0;
    int counted = 0;
    for (int b = 0; b < 1200; ++b) {
        std::vector<float> out(block, 0);
        bank.scrape(drive, 1);
        bank.render(out, all, static_cast<std::uint64_t>(b) * 77, scratch);
        if (b > 20) {
            sum += test::meanSquareIn(out);
            ++counted;
        }
    }
    double const expected = 0.8 * 0.8 / (4 * 30);
    EXPECT_NEAR(sum / counted, expected, 0.1 * expected) << "some 600 independent stretches: 6 %";
}

TEST(ModalBank, NothingAboveHalfTheRateAliases) {
    std::vector<Sounds::Ring> const rings{{.frequency = 15000, .decay = 1}};
    ModalBank bank(rate);
    bank.tune(rings, 2, 0); // a Doppler shift to 30 kHz
    std::vector<double> const amplitude{1};
    bank.strike(amplitude, 1, 0);
    for (float const s : rendered(bank, 2)) {
        ASSERT_EQ(s, 0);
    }
}

TEST(ModalBank, TuningKeepsThePhases) {
    std::vector<Sounds::Ring> const rings{{.frequency = 440, .decay = 0.1}};
    ModalBank bank(rate);
    bank.tune(rings, 1, 0);
    std::vector<double> const amplitude{1};
    bank.strike(amplitude, 1, 0);
    std::vector<float> out;
    for (int b = 0; b < 40; ++b) { // glides up, a little every block
        bank.tune(rings, 1 + 0.002 * b, 0);
        auto const next = rendered(bank, 1);
        out.insert(out.end(), next.begin(), next.end());
    }
    for (std::size_t n = 1; n < out.size(); ++n) {
        ASSERT_LT(std::abs(out[n] - out[n - 1]), 2 * pi * 480 / rate) << "no step at the seams";
    }
}

} // namespace
} // namespace modal_bank_test
} // namespace trembler
