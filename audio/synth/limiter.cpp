#include "audio/synth/limiter.hpp"

#include "runtime/math/vec2.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace trembler {
namespace {

// The modified Bessel function of order 0, by its power series.
double bessel(double x) {
    double sum = 1;
    double term = 1;
    for (int k = 1; k < 40; ++k) {
        term *= x * x / (4.0 * k * k);
        sum += term;
    }
    return sum;
}

// A sinc function in Kaiser's window of `reach` samples on either side.
double windowedSinc(double x, double reach) {
    constexpr double beta = 6; // side lobes below -60 dB
    double const share = x / reach;
    if (std::abs(share) >= 1) {
        return 0;
    }
    double const window = bessel(beta * std::sqrt(1 - share * share)) / bessel(beta);
    return window * (x == 0 ? 1 : std::sin(pi * x) / (pi * x));
}

std::size_t samplesIn(double seconds, int rate) {
    return static_cast<std::size_t>(std::max(1L, std::lround(seconds * rate)));
}

} // namespace

Limiter::Limiter(LimiterOptions const& options)
    : ceiling_(options.ceiling), step_(options.step),
      recovery_(1 - std::exp(-1 / (options.release * options.rate))),
      attack_(samplesIn(options.attack, options.rate)) {
    std::size_t const length = std::bit_ceil(attack_ + 2 * static_cast<std::size_t>(reach) + 1);
    mask_ = length - 1;
    signal_.resize(2 * length);
    double greatest = 1; // the factor by which a point may exceed all samples around it
    for (int point = 1; point < points; ++point) {
        double sum = 0;
        for (int k = 1 - reach; k <= reach; ++k) {
            double const tap = windowedSinc(static_cast<double>(point) / points - k, reach);
            taps_.push_back(static_cast<float>(tap));
            sum += std::abs(tap);
        }
        greatest = std::max(greatest, sum);
    }
    loudest_ = ceiling_ / (1.001 * greatest);
    double sum = 0;
    for (std::size_t i = 0; i < attack_; ++i) { // Hann's window
        double const root = std::sin(pi * (static_cast<double>(i) + 0.5) / static_cast<double>(attack_));
        weights_.push_back(root * root);
        sum += weights_.back();
    }
    for (double& weight : weights_) {
        weight /= sum;
    }
    demands_.resize(attack_);
    gains_.resize(attack_);
    clear();
}

void Limiter::clear() {
    std::fill(signal_.begin(), signal_.end(), 0.F);
    std::fill(gains_.begin(), gains_.end(), 1.0);
    now_ = static_cast<std::size_t>(2 * reach) + attack_; // so that no index is negative
    loudAt_ = 0;
    peakBefore_ = stepBefore_ = 0;
    first_ = waiting_ = 0;
    gain_ = 1;
    reduced_ = 0;
}

int Limiter::latency() const {
    return reach + static_cast<int>(attack_) - 1;
}

// The greatest of the points between this sample and the next one, of both channels.
double Limiter::peakAfter(std::size_t sample) const {
    float greatest = 0;
    float const* tap = taps_.data();
    for (int point = 1; point < points; ++point) {
        float left = 0;
        float right = 0;
        std::size_t at = sample + 1 - static_cast<std::size_t>(reach);
        for (int k = 0; k < 2 * reach; ++k, ++tap, ++at) {
            left += *tap * signal_[2 * (at & mask_)];
            right += *tap * signal_[2 * (at & mask_) + 1];
        }
        greatest = std::max({greatest, std::abs(left), std::abs(right)});
    }
    return static_cast<double>(greatest);
}

// The greater difference to the next sample of both channels.
double Limiter::stepAfter(std::size_t sample) const {
    float greatest = 0;
    for (std::size_t channel = 0; channel < 2; ++channel) {
        greatest = std::max(greatest, std::abs(signal_[2 * ((sample + 1) & mask_) + channel] -
                                               signal_[2 * (sample & mask_) + channel]));
    }
    return static_cast<double>(greatest);
}

// The least of the last `attack_` gains that were asked for. Only gains that are less than all later ones are
// kept, so the oldest is the least.
double Limiter::leastAhead(double gain) {
    std::size_t const sample = now_;
    if (waiting_ > 0 && demands_[first_].sample + attack_ <= sample) {
        first_ = (first_ + 1) % attack_;
        --waiting_;
    }
    while (waiting_ > 0 && demands_[(first_ + waiting_ - 1) % attack_].gain >= gain) {
        --waiting_;
    }
    demands_[(first_ + waiting_) % attack_] = {sample, gain};
    ++waiting_;
    return demands_[first_].gain;
}

double Limiter::smoothed(double gain) {
    constexpr double unheard = 1e-5; // of gain: -100 dB
    gain_ = std::min(gain, gain_ + recovery_ * (1 - gain_));
    if (gain_ > 1 - unheard && gain >= 1) {
        gain_ = 1;
    }
    double& slot = gains_[now_ % attack_];
    reduced_ += (gain_ < 1 ? 1U : 0U) - (slot < 1 ? 1U : 0U);
    slot = gain_;
    if (reduced_ == 0) {
        return 1;
    }
    double sum = 0;
    std::size_t at = (now_ + 1) % attack_; // the oldest one
    for (double const weight : weights_) {
        sum += weight * gains_[at];
        at = at + 1 == attack_ ? 0 : at + 1;
    }
    return sum;
}

void Limiter::process(std::span<float> samples) {
    auto const back = static_cast<std::size_t>(reach);
    for (std::size_t n = 0; n + 1 < samples.size(); n += 2, ++now_) {
        for (std::size_t channel = 0; channel < 2; ++channel) {
            float const sample = samples[n + channel];
            float const valid = std::isfinite(sample) ? sample : 0;
            signal_[2 * (now_ & mask_) + channel] = valid;
            if (static_cast<double>(std::abs(valid)) > loudest_) {
                loudAt_ = now_ + 1;
            }
        }
        // Of the sample `reach` ago all points around it are known.
        std::size_t const sample = now_ - back;
        double peak = 0;
        double after = 0;
        if (loudAt_ + 2 * back > now_) {
            after = peakAfter(sample);
            peak = std::max({peakBefore_, after, static_cast<double>(std::abs(signal_[2 * (sample & mask_)])),
                             static_cast<double>(std::abs(signal_[2 * (sample & mask_) + 1]))});
        }
        peakBefore_ = after;
        double const next = stepAfter(sample);
        double const step = std::max(std::exchange(stepBefore_, next), next);
        double const needed =
            std::min(peak > ceiling_ ? ceiling_ / peak : 1, step > step_ ? step_ / step : 1);
        double const gain = smoothed(leastAhead(needed));
        std::size_t const out = (now_ - back - (attack_ - 1)) & mask_;
        for (std::size_t channel = 0; channel < 2; ++channel) {
            float const sample = signal_[2 * out + channel];
            samples[n + channel] = gain < 1 ? static_cast<float>(gain * static_cast<double>(sample)) : sample;
        }
    }
}

} // namespace trembler
