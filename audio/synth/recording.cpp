#include "audio/synth/recording.hpp"

#include <cmath>

namespace trembler {

void SampleData::finish() {
    double sum = 0;
    for (float const sample : samples) {
        sum += static_cast<double>(sample) * static_cast<double>(sample);
    }
    rootMeanSquare = samples.empty() ? 0 : std::sqrt(sum / static_cast<double>(samples.size()));
}

float SamplePlayer::at(std::ptrdiff_t index) const {
    auto const size = static_cast<std::ptrdiff_t>(data_->samples.size());
    if (looping_) {
        index = (index % size + size) % size;
    } else if (index < 0 || index >= size) {
        return 0;
    }
    return data_->samples[static_cast<std::size_t>(index)];
}

void SamplePlayer::render(std::span<float> out, double rate, double pressure, double pitch, bool fade) {
    if (ended_ || data_ == nullptr || !(data_->rootMeanSquare > 0)) {
        ended_ = true;
        return;
    }
    auto const size = static_cast<double>(data_->samples.size());
    double const step = data_->rate / rate * pitch;
    double const gain = pressure / data_->rootMeanSquare;
    for (std::size_t n = 0; n < out.size(); ++n) {
        if (!looping_ && position_ >= size) {
            ended_ = true;
            return;
        }
        double const whole = std::floor(position_);
        auto const index = static_cast<std::ptrdiff_t>(whole);
        double const t = position_ - whole;
        double const a = static_cast<double>(at(index - 1));
        double const b = static_cast<double>(at(index));
        double const c = static_cast<double>(at(index + 1));
        double const d = static_cast<double>(at(index + 2));
        double const value =
            b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
        double const share = fade ? 1 - static_cast<double>(n) / static_cast<double>(out.size()) : 1;
        out[n] += static_cast<float>(gain * share * value);
        position_ += step;
        if (looping_ && position_ >= size) {
            position_ = std::fmod(position_, size);
        }
    }
    ended_ = ended_ || fade;
}

} // namespace trembler
