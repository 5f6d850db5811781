#include "audio/synth/masking.hpp"

#include "audio/effect/decibel.hpp"

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
    return std::pow(10.0, (index + spread) / 10);
}

void Masker::findAudible(std::span<Tone const> tones, std::vector<std::uint8_t>& audible) {
    audible.assign(tones.size(), 0);
    masked_.fill(0);
    dropped_.fill(0);
    order_.resize(tones.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return tones[a].power != tones[b].power ? tones[a].power > tones[b].power : a < b;
    });
    // From the loudest down: whoever stands out from what is kept already is kept, too.
    for (std::uint32_t const i : order_) {
        Tone const& tone = tones[i];
        auto const bin = static_cast<std::size_t>(binOf(tone.bark));
        // A critical band hears its quarters together, so each may lose a quarter of what is masked.
        if (dropped_[bin] + tone.power <= std::max(masked_[bin] / binsPerBark, tone.threshold)) {
            dropped_[bin] += tone.power;
            continue;
        }
        audible[i] = 1;
        double const level = levelOf(tone.power);
        int const from = binOf(tone.bark - reachBelow);
        int const to = binOf(tone.bark + reachAbove);
        for (int b = from; b <= to; ++b) {
            masked_[static_cast<std::size_t>(b)] += tone.power * maskingShare(tone.bark, level, barkOfBin(b));
        }
    }
}

} // namespace trembler
