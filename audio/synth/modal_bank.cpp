#include "audio/synth/modal_bank.hpp"

#include "audio/effect/properties/decibel.hpp"
#include "audio/synth/masking.hpp"
#include "runtime/math/vec2.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

// Calls function(0), function(1) ... with numbers known to the compiler. g++ -O2 does not unroll a loop, and
// so would keep an array that the loop reads in memory instead of in registers.
template <int count, class Function>
[[gnu::always_inline]] inline void forEach(Function&& function) {
    [&]<int... i>(std::integer_sequence<int, i...>) {
        (function(std::integral_constant<int, i>{}), ...);
    }
    (std::make_integer_sequence<int, count>{});
}

// One sample further: z times step.
void rotate(Lanes& re, Lanes& im, Lanes const& stepRe, Lanes const& stepIm) {
    Lanes const next = re * stepRe - im * stepIm;
    im = re * stepIm + im * stepRe;
    re = next;
}

// Modes that a noise drives: each sample of a group depends on the previous one.
template <int count>
void drive(ModalScratch::Group* groups, float const* noise, Lanes* sums, int from, int to) {
    std::array<ModalScratch::Group, count> now;
    forEach<count>([&](auto g) { now[g] = groups[g]; });
    for (int n = from; n < to; ++n) {
        Lanes sum = sums[n];
        forEach<count>([&](auto g) {
            sum += now[g].im;
            rotate(now[g].re, now[g].im, now[g].stepRe, now[g].stepIm);
            now[g].re += now[g].drive * noise[n];
        });
        sums[n] = sum;
    }
    forEach<count>([&](auto g) { groups[g] = now[g]; });
}

// Modes that ring freely. A rotation waits for the result of the one before, which takes longer than the
// arithmetic, so `phases` samples in a row are followed at the same time, each by that many samples in a
// step.
template <int count, int phases>
void ring(ModalScratch::Group* groups, Lanes* sums, int from, int to) {
    std::array<std::array<Lanes, phases>, count> re;
    std::array<std::array<Lanes, phases>, count> im;
    std::array<Lanes, count> strideRe;
    std::array<Lanes, count> strideIm;
    forEach<count>([&](auto g) {
        re[g][0] = groups[g].re;
        im[g][0] = groups[g].im;
        strideRe[g] = groups[g].stepRe;
        strideIm[g] = groups[g].stepIm;
        forEach<phases - 1>([&](auto p) {
            re[g][p + 1] = re[g][p];
            im[g][p + 1] = im[g][p];
            rotate(re[g][p + 1], im[g][p + 1], groups[g].stepRe, groups[g].stepIm);
            rotate(strideRe[g], strideIm[g], groups[g].stepRe, groups[g].stepIm);
        });
    });
    int n = from;
    for (; n + phases <= to; n += phases) {
        forEach<phases>([&](auto p) {
            Lanes sum = sums[n + p];
            forEach<count>([&](auto g) {
                sum += im[g][p];
                rotate(re[g][p], im[g][p], strideRe[g], strideIm[g]);
            });
            sums[n + p] = sum;
        });
    }
    for (; n < to; ++n) {
        forEach<count>([&](auto g) {
            sums[n] += im[g][0];
            rotate(re[g][0], im[g][0], groups[g].stepRe, groups[g].stepIm);
        });
    }
    forEach<count>([&](auto g) {
        groups[g].re = re[g][0];
        groups[g].im = im[g][0];
    });
}

// Calls compute<count>(first) for four groups at a time, and for two and one of the rest.
template <class Compute>
void forGroups(std::vector<ModalScratch::Group>& groups, Compute const& compute) {
    std::size_t at = 0;
    for (; at + 4 <= groups.size(); at += 4) {
        compute.template operator()<4>(&groups[at]);
    }
    for (; at + 2 <= groups.size(); at += 2) {
        compute.template operator()<2>(&groups[at]);
    }
    for (; at < groups.size(); ++at) {
        compute.template operator()<1>(&groups[at]);
    }
}

// Adds the sum of each sample's lanes, for four samples at a time: a transposition by halves.
void addLanes(std::span<Lanes const> sums, std::span<float> out) {
    static_assert(laneCount == 4);
    std::size_t n = 0;
    for (; n + laneCount <= out.size(); n += laneCount) {
        Lanes const& a = sums[n];
        Lanes const& b = sums[n + 1];
        Lanes const& c = sums[n + 2];
        Lanes const& d = sums[n + 3];
        Lanes const ab =
            __builtin_shufflevector(a, b, 0, 2, 4, 6) + __builtin_shufflevector(a, b, 1, 3, 5, 7);
        Lanes const cd =
            __builtin_shufflevector(c, d, 0, 2, 4, 6) + __builtin_shufflevector(c, d, 1, 3, 5, 7);
        Lanes const all =
            __builtin_shufflevector(ab, cd, 0, 2, 4, 6) + __builtin_shufflevector(ab, cd, 1, 3, 5, 7);
        for (std::size_t i = 0; i < laneCount; ++i) {
            out[n + i] += all[i];
        }
    }
    for (; n < out.size(); ++n) {
        Lanes const& sum = sums[n];
        out[n] += (sum[0] + sum[1]) + (sum[2] + sum[3]);
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
        mode.step = 0;
        mode.leapSamples = 0;
        if (frequency >= rate_ / 2) {
            mode.state = 0;
        }
    }
}

// The sine and the exponential are computed in float, in half the time: whole turns are removed in double
// before, and the rotations of a block are carried out in float as well.
std::complex<double> ModalBank::turned(Oscillator const& mode, double samples) const {
    double const turns = mode.frequency * samples / rate_;
    auto const angle = static_cast<float>(2 * pi * (turns - std::nearbyint(turns)));
    auto const magnitude = std::exp(static_cast<float>(-mode.decay * samples / rate_));
    return {static_cast<double>(magnitude * std::cos(angle)),
            static_cast<double>(magnitude * std::sin(angle))};
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
    double amplitude = std::sqrt(std::norm(oscillator.state)); // std::abs would guard against overflow
    for (Impact const& impact : impacts_) {
        amplitude += std::abs(impact.amplitudes[mode]);
    }
    double const settled = oscillator.drive * oscillator.drive / (4 * oscillator.decay);
    return amplitude * amplitude / 2 + settled;
}

void ModalBank::pack(std::span<std::uint8_t const> audible, ModalScratch& scratch) {
    std::vector<ModalScratch::Group>& groups = scratch.groups;
    std::vector<std::uint32_t>& packed = scratch.packed;
    packed.clear();
    for (std::uint32_t i = 0; i < modes_.size(); ++i) {
        if (audible[i] != 0) {
            packed.push_back(i);
        }
    }
    groups.assign((packed.size() + laneCount - 1) / laneCount, ModalScratch::Group{});
    for (std::size_t i = 0; i < packed.size(); ++i) {
        Oscillator& mode = modes_[packed[i]];
        if (mode.step == 0.0) {
            mode.step = turned(mode, 1);
        }
        ModalScratch::Group& group = groups[i / laneCount];
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

std::size_t ModalBank::render(std::span<float> out, std::span<std::uint8_t const> audible, std::uint64_t seed,
                              ModalScratch& scratch) {
    auto const samples = static_cast<int>(out.size());
    pack(audible, scratch);
    std::vector<ModalScratch::Group>& groups = scratch.groups;
    std::vector<std::uint32_t> const& packed = scratch.packed;
    std::vector<Lanes>& sums = scratch.sums;
    std::vector<float>& noise = scratch.noise;
    if (!groups.empty()) {
        sums.assign(out.size(), Lanes{});
        if (driven_) {
            noise.resize(out.size());
            fillNoise(noise, seed);
        }
        int at = 0;
        auto const runTo = [&](int to) {
            if (driven_) {
                forGroups(groups, [&]<int count>(ModalScratch::Group* first) {
                    drive<count>(first, noise.data(), sums.data(), at, to);
                });
            } else {
                forGroups(groups, [&]<int count>(ModalScratch::Group* first) {
                    // Four rotations at a time use the processor's registers.
                    ring<count, 4 / count>(first, sums.data(), at, to);
                });
            }
            at = to;
        };
        for (Impact const& impact : impacts_) {
            runTo(std::clamp(impact.sample, at, samples));
            for (std::size_t i = 0; i < packed.size(); ++i) {
                groups[i / laneCount].re[i % laneCount] += static_cast<float>(impact.amplitudes[packed[i]]);
            }
        }
        runTo(samples);
        addLanes(sums, out);
    }
    bool const disturbed = driven_ || !impacts_.empty();
    std::size_t next = 0; // of packed
    for (std::uint32_t i = 0; i < modes_.size(); ++i) {
        Oscillator& mode = modes_[i];
        bool const rendered = next < packed.size() && packed[next] == i;
        if (rendered && disturbed) {
            ModalScratch::Group const& group = groups[next / laneCount];
            mode.state = {static_cast<double>(group.re[next % laneCount]),
                          static_cast<double>(group.im[next % laneCount])};
        } else if (rendered) {
            leap(mode, samples);
        } else {
            skip(mode, i, samples);
        }
        next += rendered ? 1 : 0;
        mode.drive = 0;
        if (std::norm(mode.state) < nothing) {
            mode.state = 0;
        }
    }
    impacts_.clear();
    driven_ = false;
    return packed.size();
}

} // namespace trembler
