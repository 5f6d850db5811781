// The true peak of samples as ITU-R BS.1770-4 measures it, and the steps between them: independent of the
// limiter.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace trembler::test {

/// The greatest amplitude of the signal between the samples, by the fourfold oversampling of Annex 2 with the
/// coefficients of its table.
inline double truePeak(std::span<float const> samples) {
    constexpr std::size_t taps = 12;
    constexpr std::array<std::array<double, taps>, 2> table{
        {{0.0017089843750, 0.0109863281250, -0.0196533203125, 0.0332031250000, -0.0594482421875,
          0.1373291015625, 0.9721679687500, -0.1022949218750, 0.0476074218750, -0.0266113281250,
          0.0148925781250, -0.0083007812500},
         {-0.0291748046875, 0.0292968750000, -0.0517578125000, 0.0891113281250, -0.1665039062500,
          0.4650878906250, 0.7797851562500, -0.2003173828125, 0.1015625000000, -0.0582275390625,
          0.0330810546875, -0.0189208984375}}};
    double peak = 0;
    for (float const sample : samples) {
        peak = std::max(peak, std::abs(static_cast<double>(sample)));
    }
    for (std::size_t n = 0; n + taps <= samples.size(); ++n) {
        std::array<double, 4> points{}; // the third and fourth phase are the mirrored first two
        for (std::size_t k = 0; k < taps; ++k) {
            auto const forwards = static_cast<double>(samples[n + k]);
            auto const backwards = static_cast<double>(samples[n + taps - 1 - k]);
            points[0] += table[0][k] * forwards;
            points[1] += table[1][k] * forwards;
            points[2] += table[1][k] * backwards;
            points[3] += table[0][k] * backwards;
        }
        for (double const point : points) {
            peak = std::max(peak, std::abs(point));
        }
    }
    return peak;
}

/// The greatest difference of two consecutive samples.
inline double greatestStep(std::span<float const> samples) {
    double step = 0;
    for (std::size_t n = 1; n < samples.size(); ++n) {
        step =
            std::max(step, std::abs(static_cast<double>(samples[n]) - static_cast<double>(samples[n - 1])));
    }
    return step;
}

inline double inDecibels(double amplitude) {
    return 20 * std::log10(amplitude);
}

/// One channel of samples that are left and right in turn.
inline std::vector<float> channelOf(std::span<float const> samples, std::size_t channel) {
    std::vector<float> one;
    one.reserve(samples.size() / 2);
    for (std::size_t n = channel; n < samples.size(); n += 2) {
        one.push_back(samples[n]);
    }
    return one;
}

} // namespace trembler::test
