#include "audio/synth/masking.hpp"

#include "audio/effect/properties/decibel.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trembler {
namespace {

constexpr double reachBelow = 3; // Bark, over which a tone masks lower ones
constexpr double reachAbove = 8;

int binOf(double bark) {
    return std::clamp(static_cast<int>(bark * Masker::binsPerBark), 0, Masker::bins - 1);
}
double barkOfBin(int bin) {
    return (bin + 0.5) / Masker::binsPerBark;
}

} // namespace

double barkOf(double frequency) {
    double const khz = frequency / 1000;
    return 13 * std::atan(0.76 * khz) + 3.5 * std::atan(khz * khz / (7.5 * 7.5));
}

double hearingThreshold(double frequency) {
    double const khz = std::max(0.02, frequency / 1000);
    double const decibels = 3.64 * std::pow(khz, -0.8) - 6.5 * std::exp(-0.6 * (khz - 3.3) * (khz - 3.3)) +
                            1e-3 * khz * khz * khz * khz;
    return meanSquareOf(std::min(decibels, 120.0));
}

double maskingShare(double masker, double level, double bark) {
    double const dz = bark - masker;
    if (dz < -reachBelow || dz >= reachAbove) {
        return 0;
    }
    double const loud = std::clamp(level, 0.0, 100.0);
    double const index = -6.025 - 0.275 * masker;
    double spread = 0;
    if (dz < -1) {
        spread = 17 * (dz + 1) - (0.4 * loud + 6);
    } else if (dz < 0) {
        spread = (0.4 * loud + 6) * dz;
    } else if (dz < 1) {
        spread = -17 * dz;
    } else {
        spread = -(dz - 1) * (17 - 0.15 * loud) - 17;
    }
    return powerOf(index + spread);
}

Hearing hearingAt(double frequency) {
    constexpr double step = 4; // Hz
    constexpr std::size_t steps = 6001;
    static std::vector<Hearing> const table = [] {
        std::vector<Hearing> made;
        for (std::size_t i = 0; i < steps; ++i) {
            double const f = static_cast<double>(i) * step;
            made.push_back({barkOf(f), hearingThreshold(f)});
        }
        return made;
    }();
    double const at = std::clamp(frequency / step, 0.0, steps - 1.001);
    auto const i = static_cast<std::size_t>(at);
    double const t = at - static_cast<double>(i);
    return {table[i].bark + t * (table[i + 1].bark - table[i].bark),
            table[i].threshold + t * (table[i + 1].threshold - table[i].threshold)};
}

// Adds the power that a tone masks in every bin. In decibels maskingShare() is piecewise linear, so from bin
// to bin its share changes by a constant factor.
void Masker::mask(Tone const& tone) {
    double const level = levelOf(tone.power);
    int const last = binOf(tone.bark + reachAbove);
    int bin = binOf(tone.bark - reachBelow);
    bin += barkOfBin(bin) - tone.bark < -reachBelow ? 1 : 0;
    while (bin <= last) {
        double const first = barkOfBin(bin) - tone.bark;
        double const end = first < -1 ? -1 : first < 0 ? 0 : first < 1 ? 1 : reachAbove;
        double share = maskingShare(tone.bark, level, barkOfBin(bin));
        double const next = maskingShare(tone.bark, level, barkOfBin(bin + 1));
        double const factor = share > 0 && first + 1.0 / binsPerBark < end ? next / share : 0;
        do {
            masked_[static_cast<std::size_t>(bin)] += tone.power * share;
            share *= factor;
            ++bin;
        } while (bin <= last && barkOfBin(bin) - tone.bark < end);
    }
}

void Masker::findAudible(std::span<Tone const> tones, std::vector<std::uint8_t>& audible) {
    audible.assign(tones.size(), 0);
    masked_.fill(0);
    dropped_.fill(0);
    order_.resize(tones.size());
    std::iota(order_.begin(), order_.end(), 0U);
    // Ties are ordered by index, so that the result does not depend on the sorting algorithm.
    auto const louder = [&](std::uint32_t a, std::uint32_t b) {
        return tones[a].power != tones[b].power ? tones[a].power > tones[b].power : a < b;
    };
    std::size_t const maskers = std::min(mostMaskers, tones.size());
    auto const middle = order_.begin() + static_cast<std::ptrdiff_t>(maskers);
    std::nth_element(order_.begin(), middle, order_.end(), louder);
    std::sort(order_.begin(), middle, louder);
    std::sort(middle, order_.end());
    // From the loudest tone down: a tone that is audible beside those already kept is kept, too.
    for (std::size_t n = 0; n < order_.size(); ++n) {
        Tone const& tone = tones[order_[n]];
        auto const bin = static_cast<std::size_t>(binOf(tone.bark));
        // The ear hears a critical band as a whole, so each of its quarters may lose a quarter of the masked
        // power.
        if (dropped_[bin] + tone.power <= std::max(masked_[bin] / binsPerBark, tone.threshold)) {
            dropped_[bin] += tone.power;
            continue;
        }
        audible[order_[n]] = 1;
        if (n < maskers) {
            mask(tone);
        }
    }
}

} // namespace trembler
