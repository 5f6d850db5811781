// Analysis of rendered samples: amplitudes of single tones, power spectra, levels.
#pragma once

#include "runtime/math/vec2.hpp"

#include <cmath>
#include <complex>
#include <span>
#include <vector>

namespace trembler::test {

/// The complex amplitude of a tone in Hann-windowed samples (Goertzel's sum, written out).
inline std::complex<double> toneIn(std::span<float const> samples, double rate, double frequency) {
    std::complex<double> sum = 0;
    double window = 0;
    auto const n = static_cast<double>(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double const t = static_cast<double>(i);
        double const w = 0.5 - 0.5 * std::cos(2 * pi * (t + 0.5) / n);
        sum += w * static_cast<double>(samples[i]) * std::polar(1.0, -2 * pi * frequency * t / rate);
        window += w;
    }
    return 2.0 * sum / window;
}

/// The frequency near `guess` at which the tone is strongest, by golden section within `span` on either side.
inline double peakNear(std::span<float const> samples, double rate, double guess, double span) {
    double from = guess - span;
    double to = guess + span;
    double best = guess;
    double strongest = 0;
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i) { // a coarse search first, because there may be several maxima
        double const f = from + (to - from) * i / steps;
        if (double const a = std::abs(toneIn(samples, rate, f)); a > strongest) {
            strongest = a;
            best = f;
        }
    }
    double const step = (to - from) / steps;
    from = best - step;
    to = best + step;
    for (int i = 0; i < 30; ++i) {
        double const a = from + 0.382 * (to - from);
        double const b = from + 0.618 * (to - from);
        if (std::abs(toneIn(samples, rate, a)) > std::abs(toneIn(samples, rate, b))) {
            to = b;
        } else {
            from = a;
        }
    }
    return (from + to) / 2;
}

/// In-place radix-2 transform; the size must be a power of two.
inline void transform(std::vector<std::complex<double>>& x) {
    std::size_t const n = x.size();
    for (std::size_t i = 1, j = 0; i < n; ++i) {
        std::size_t bit = n >> 1U;
        for (; (j & bit) != 0; bit >>= 1U) {
            j ^= bit;
        }
        j ^= bit;
        if (i < j) {
            std::swap(x[i], x[j]);
        }
    }
    for (std::size_t size = 2; size <= n; size *= 2) {
        std::complex<double> const turn = std::polar(1.0, -2 * pi / static_cast<double>(size));
        for (std::size_t from = 0; from < n; from += size) {
            std::complex<double> w = 1;
            for (std::size_t k = 0; k < size / 2; ++k) {
                std::complex<double> const a = x[from + k];
                std::complex<double> const b = w * x[from + k + size / 2];
                x[from + k] = a + b;
                x[from + k + size / 2] = a - b;
                w *= turn;
            }
        }
    }
}

/// Power by frequency: element k belongs to k rate / size, up to half the rate. Hann-windowed, padded with
/// zeros.
inline std::vector<double> powerSpectrum(std::span<float const> samples) {
    std::size_t size = 1;
    while (size < samples.size()) {
        size *= 2;
    }
    std::vector<std::complex<double>> x(size);
    auto const n = static_cast<double>(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        x[i] = static_cast<double>(samples[i]) *
               (0.5 - 0.5 * std::cos(2 * pi * (static_cast<double>(i) + 0.5) / n));
    }
    transform(x);
    std::vector<double> power(size / 2);
    for (std::size_t k = 0; k < power.size(); ++k) {
        power[k] = std::norm(x[k]);
    }
    return power;
}

/// The power-weighted mean frequency, Hz: a measure of brightness.
inline double centroid(std::span<float const> samples, double rate) {
    std::vector<double> const power = powerSpectrum(samples);
    double sum = 0;
    double moment = 0;
    for (std::size_t k = 0; k < power.size(); ++k) {
        sum += power[k];
        moment += power[k] * static_cast<double>(k) * rate / (2 * static_cast<double>(power.size()));
    }
    return sum > 0 ? moment / sum : 0;
}

inline double meanSquareIn(std::span<float const> samples) {
    double sum = 0;
    for (float const s : samples) {
        sum += static_cast<double>(s) * static_cast<double>(s);
    }
    return samples.empty() ? 0 : sum / static_cast<double>(samples.size());
}

} // namespace trembler::test
