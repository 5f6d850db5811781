#include "audio/synth/modal_bank.hpp"

#include "audio/effect/properties/decibel.hpp"
#include "audio/synth/masking.hpp"
#include "runtime/math/vec2.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

// Below this a mode is set to zero, Pa²: 40 dB below the threshold of hearing.
constexpr double nothing = 1e-4 * referencePressure * referencePressure;

// White noise of unit power. The generator is Marsaglia's xorshift64 (2003).
void fillNoise(std::span<float> noise, std::uint64_t seed) {
    std::uint64_t x = seed * 0x9E3779B97F4A7C15U + 0x632BE59BD9B4E019U;
    x = x == 0 ? 1 : x;
    for (float& sample : noise) {
        x ^= x << 13U;
        x ^= x >> 7U;
        x ^= x << 17U;
        double const unit = static_cast<double>(x >> 11U) * 0x1p-53; // [0, 1)
        sample = static_cast<float>((2 * unit - 1) * std::sqrt(3.0));
    }
}

template <int count, bool driven, class Group>
void turn(Group* groups, float const* noise, Lanes* sums, int from, int to) {
    Lanes re[count];
    Lanes im[count];
    for (int g = 0; g < count; ++g) {
        re[g] = groups[g].re;
        im[g] = groups[g].im;
    }
    for (int n = from; n < to; ++n) {
        Lanes sum = sums[n];
        for (int g = 0; g < count; ++g) {
            sum += im[g];
            Lanes next = re[g] * groups[g].stepRe - im[g] * groups[g].stepIm;
            im[g] = re[g] * groups[g].stepIm + im[g] * groups[g].stepRe;
            if constexpr (driven) {
                next += groups[g].drive * noise[n];
            }
            re[g] = next;
        }
        sums[n] = sum;
    }
    for (int g = 0; g < count; ++g) {
        groups[g].re = re[g];
        groups[g].im = im[g];
    }
}

// Computes several groups at a time, as each sample of a group depends on the previous one.
template <bool driven, class Group>
void turnAll(std::vector<Group>& groups, float const* noise, Lanes* sums, int from, int to) {
    std::size_t at = 0;
    for (; at + 4 <= groups.size(); at += 4) {
        turn<4, driven>(&groups[at], noise, sums, from, to);
    }
    for (; at + 2 <= groups.size(); at += 2) {
        turn<2, driven>(&groups[at], noise, sums, from, to);
    }
    for (; at < groups.size(); ++at) {
        turn<1, driven>(&groups[at], noise, sums, from, to);
    }
}

} // namespace

void ModalBank::tune(std::span<Sounds::Ring const> rings, double pitch, double damping) {
    modes_.resize(rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i) {
        Oscillator& mode = modes_[i];
        double const frequency = rings[i].frequency * pitch;
        double const decay = rings[i].decay + damping;
        if (mode.frequency == frequency && mode.decay == decay) {
            continue;
        }
        mode.frequency = frequency;
        mode.decay = decay;
        Hearing const hearing = hearingAt(frequency);
        mode.bark = hearing.bark;
        mode.threshold = hearing.threshold;
        mode.step = turned(mode, 1);
        mode.leapSamples = 0;
        if (frequency >= rate_ / 2) {
            mode.state = 0;
        }
    }
}

std::complex<double> ModalBank::turned(Oscillator const& mode, double samples) const {
    return std::polar(std::exp(-mode.decay * samples / rate_), 2 * pi * mode.frequency * samples / rate_);
}

void ModalBank::strike(std::span<double const> amplitudes, double scale, int sample) {
    auto at = std::lower_bound(impacts_.begin(), impacts_.end(), sample,
                               [](Impact const& other, int s) { return other.sample < s; });
    if (at == impacts_.end() || at->sample != sample) {
        at = impacts_.insert(at, Impact{sample, std::vector<double>(modes_.size(), 0)});
    }
    for (std::size_t i = 0; i < std::min(modes_.size(), amplitudes.size()); ++i) {
        at->amplitudes[i] += modes_[i].frequency < rate_ / 2 ? scale * amplitudes[i] : 0;
    }
}

void ModalBank::scrape(std::span<double const> amplitudes, double scale) {
    for (std::size_t i = 0; i < std::min(modes_.size(), amplitudes.size()); ++i) {
        if (modes_[i].frequency < rate_ / 2) {
            // Independent noises: their powers add up.
            modes_[i].drive = std::hypot(modes_[i].drive, scale * amplitudes[i]);
            driven_ = true;
        }
    }
}

double ModalBank::power(std::size_t mode) const {
    Oscillator const& oscillator = modes_[mode];
    double amplitude = std::abs(oscillator.state);
    for (Impact const& impact : impacts_) {
        amplitude += std::abs(impact.amplitudes[mode]);
    }
    double const settled = oscillator.drive * oscillator.drive / (4 * oscillator.decay);
    return amplitude * amplitude / 2 + settled;
}

void ModalBank::pack(std::span<std::uint8_t const> audible) {
    packed_.clear();
    for (std::uint32_t i = 0; i < modes_.size(); ++i) {
        if (audible[i] != 0) {
            packed_.push_back(i);
        }
    }
    groups_.assign((packed_.size() + laneCount - 1) / laneCount, Group{});
    for (std::size_t i = 0; i < packed_.size(); ++i) {
        Oscillator const& mode = modes_[packed_[i]];
        Group& group = groups_[i / laneCount];
        std::size_t const lane = i % laneCount;
        group.re[lane] = static_cast<float>(mode.state.real());
        group.im[lane] = static_cast<float>(mode.state.imag());
        group.stepRe[lane] = static_cast<float>(mode.step.real());
        group.stepIm[lane] = static_cast<float>(mode.step.imag());
        group.drive[lane] = static_cast<float>(mode.drive / std::sqrt(rate_));
    }
}

// The change of a mode over a block in which nothing excites it. Exact, so that rounding does not add up over
// blocks.
void ModalBank::leap(Oscillator& mode, int samples) const {
    if (mode.leapSamples != samples) {
        mode.leapSamples = samples;
        mode.leap = turned(mode, samples);
    }
    mode.state *= mode.leap;
}

// Advances an inaudible mode to the end of the block without computing the samples in between.
void ModalBank::skip(Oscillator& mode, std::size_t index, int samples) const {
    if (mode.state != 0.0) {
        leap(mode, samples);
    }
    for (Impact const& impact : impacts_) {
        if (impact.amplitudes[index] != 0) {
            mode.state += impact.amplitudes[index] * turned(mode, samples - impact.sample);
        }
    }
}

std::size_t ModalBank::render(std::span<float> out, std::span<std::uint8_t const> audible,
                              std::uint64_t seed) {
    auto const samples = static_cast<int>(out.size());
    pack(audible);
    if (!groups_.empty()) {
        sums_.assign(out.size(), Lanes{});
        if (driven_) {
            noise_.resize(out.size());
            fillNoise(noise_, seed);
        }
        int at = 0;
        auto const runTo = [&](int to) {
            if (driven_) {
                turnAll<true>(groups_, noise_.data(), sums_.data(), at, to);
            } else {
                turnAll<false>(groups_, nullptr, sums_.data(), at, to);
            }
            at = to;
        };
        for (Impact const& impact : impacts_) {
            runTo(std::clamp(impact.sample, at, samples));
            for (std::size_t i = 0; i < packed_.size(); ++i) {
                groups_[i / laneCount].re[i % laneCount] += static_cast<float>(impact.amplitudes[packed_[i]]);
            }
        }
        runTo(samples);
        for (std::size_t n = 0; n < out.size(); ++n) {
            Lanes const& sum = sums_[n];
            out[n] += (sum[0] + sum[1]) + (sum[2] + sum[3]);
        }
    }
    bool const disturbed = driven_ || !impacts_.empty();
    std::size_t packed = 0;
    for (std::uint32_t i = 0; i < modes_.size(); ++i) {
        Oscillator& mode = modes_[i];
        bool const rendered = packed < packed_.size() && packed_[packed] == i;
        if (rendered && disturbed) {
            Group const& group = groups_[packed / laneCount];
            mode.state = {static_cast<double>(group.re[packed % laneCount]),
                          static_cast<double>(group.im[packed % laneCount])};
        } else if (rendered) {
            leap(mode, samples);
        } else {
            skip(mode, i, samples);
        }
        packed += rendered ? 1 : 0;
        mode.drive = 0;
        if (std::norm(mode.state) < nothing) {
            mode.state = 0;
        }
    }
    impacts_.clear();
    driven_ = false;
    return packed_.size();
}

} // namespace trembler
