// Keeps the true peak of a stereo mix, and its steps, below a ceiling.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trembler {

struct LimiterOptions {
    int rate = 48000; ///< Hz
    /// The greatest true peak, as an amplitude: -1.4 dB of full scale. Less than -1 dB, because estimates of
    /// true peaks differ by some tenths of a decibel.
    double ceiling = 0.851;
    /// The greatest difference of two consecutive samples: a loud step is a click. Below 2 kHz a tone reaches
    /// the ceiling first, at 10 kHz an amplitude of 0.37.
    double step = 0.45;
    double attack = 0.0015; ///< s, in which the gain falls before a peak: the look-ahead
    double release = 0.08;  ///< s, time constant in which the gain returns to 1
};

/// A look-ahead limiter. The true peak, that of the continuous signal between the samples, is estimated by
/// interpolating seven points between each two samples (ITU-R BS.1770-4, Annex 2, asks for three). The gain
/// is the same for both channels, so that no sound changes its direction. It falls along a smooth curve
/// within the attack, reaches the necessary value before the peak does, and returns exponentially. A signal
/// that stays below the limits leaves unchanged, bit for bit, but later.
///
/// Deterministic; process() allocates no memory and takes the same samples in blocks of any sizes. Used by
/// one thread at a time.
class Limiter {
public:
    explicit Limiter(LimiterOptions const& options = {});

    /// Replaces the samples, left and right in turn, by those of latency() earlier, limited. Samples that are
    /// no finite numbers count as 0.
    void process(std::span<float> samples);
    /// As if no sample had ever been processed.
    void clear();

    /// The delay, in samples of one channel: 1.7 ms.
    [[nodiscard]] int latency() const;

private:
    static constexpr int points = 8; ///< per sample of the interpolated signal
    static constexpr int reach = 12; ///< samples on either side that an interpolated point depends on

    [[nodiscard]] double peakAfter(std::size_t sample) const;
    [[nodiscard]] double leastAhead(double gain);
    [[nodiscard]] double smoothed(double gain);

    [[nodiscard]] double stepAfter(std::size_t sample) const;

    double ceiling_;
    double step_;
    double recovery_;             // share of the missing gain that returns with each sample
    std::size_t attack_;          // samples
    std::size_t mask_;            // of indices into signal_
    double loudest_ = 0;          // a sample up to this cannot be part of a true peak above the ceiling
    std::vector<float> taps_;     // of the points between two samples, by point
    std::vector<double> weights_; // of the smoothing, sum 1
    std::vector<float> signal_;   // the last samples, left and right in turn, cyclic
    struct Demand {
        std::size_t sample = 0;
        double gain = 1;
    };
    std::vector<Demand> demands_; // the least gains of the look-ahead, ascending by sample and gain, cyclic
    std::vector<double> gains_;   // the last gains before smoothing, cyclic

    std::size_t now_ = 0;     // samples so far
    std::size_t loudAt_ = 0;  // the last sample above loudest_, plus 1
    double peakBefore_ = 0;   // the greatest interpolated point before the newest one
    double stepBefore_ = 0;   // likewise
    std::size_t first_ = 0;   // of demands_
    std::size_t waiting_ = 0; // number of valid demands_
    double gain_ = 1;         // before smoothing
    std::size_t reduced_ = 0; // number of gains_ below 1
};

} // namespace trembler
