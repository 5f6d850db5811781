#include "audio/synth/interface_sounds.hpp"

#include "audio/synth/modal_bank.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace trembler {
namespace {

/// A mode that is struck once.
struct TouchStrike {
    double frequency = 0; // Hz
    double decay = 0;     // 1/s
    double pressure = 0;  // Pa
    double at = 0;        // s
};

constexpr TouchStrike pickUpStrikes[] = {{620, 70, 0.05, 0}, {1240, 110, 0.03, 0}};
constexpr TouchStrike placeStrikes[] = {{190, 45, 0.12, 0}, {520, 80, 0.05, 0}};
constexpr TouchStrike refuseStrikes[] = {{160, 40, 0.12, 0}, {140, 40, 0.12, 0.09}};
constexpr TouchStrike clickStrikes[] = {{900, 160, 0.04, 0}, {1500, 220, 0.02, 0}};
constexpr TouchStrike runStrikes[] = {{440, 30, 0.04, 0}, {660, 30, 0.04, 0.07}};
constexpr TouchStrike solvedStrikes[] = {
    {523.25, 7, 0.04, 0}, {659.26, 7, 0.04, 0.09}, {783.99, 7, 0.04, 0.18}, {1046.5, 6, 0.04, 0.27}};

std::span<TouchStrike const> touchStrikesOf(InterfaceSound sound) {
    switch (sound) {
    case InterfaceSound::pickUp:
        return pickUpStrikes;
    case InterfaceSound::place:
        return placeStrikes;
    case InterfaceSound::refuse:
        return refuseStrikes;
    case InterfaceSound::run:
        return runStrikes;
    case InterfaceSound::click:
        return clickStrikes;
    case InterfaceSound::solved:
        break;
    }
    return solvedStrikes;
}

} // namespace

std::vector<float> samplesOf(InterfaceSound sound, int rate) {
    constexpr double quiet = 6; // decay times after which nothing is heard
    constexpr double longest = 1.2;
    std::span<TouchStrike const> const strikes = touchStrikesOf(sound);
    std::vector<Sounds::Ring> rings;
    double length = 0; // s
    for (TouchStrike const& strike : strikes) {
        rings.push_back({.frequency = strike.frequency, .decay = strike.decay});
        length = std::max(length, strike.at + quiet / strike.decay);
    }
    length = std::min(length, longest);
    ModalBank bank(rate);
    bank.tune(rings, 1, 0);
    for (std::size_t i = 0; i < strikes.size(); ++i) {
        std::vector<double> amplitudes(strikes.size(), 0);
        amplitudes[i] = strikes[i].pressure;
        bank.strike(amplitudes, 1, static_cast<int>(std::lround(strikes[i].at * rate)));
    }
    std::vector<float> samples(static_cast<std::size_t>(std::lround(length * rate)), 0.F);
    std::vector<std::uint8_t> const audible(strikes.size(), 1);
    ModalScratch scratch;
    (void)bank.render(samples, audible, 0, scratch);
    // It ends without a step.
    std::size_t const fade = std::min<std::size_t>(samples.size(), static_cast<std::size_t>(rate) / 200);
    for (std::size_t i = 0; i < fade; ++i) {
        samples[samples.size() - 1 - i] *= static_cast<float>(i) / static_cast<float>(fade);
    }
    return samples;
}

} // namespace trembler
