// How many frames of another run are computed in one picture, so that the window keeps moving.
#pragma once

#include <algorithm>
#include <cstdint>

namespace trembler::ui {

/// Divides the work of a picture into batches: their sizes follow from what the frames before have cost.
/// Reads no clock itself. The results do not depend on it, only the time at which they are computed. Any
/// thread, one at a time.
class PicturePace {
public:
    static constexpr double budget = 8e-3;          ///< s in one picture
    static constexpr std::uint64_t mostFrames = 60; ///< in one picture

    /// A picture begins.
    void begin() {
        left_ = budget;
        frames_ = mostFrames;
    }
    /// The size of the next batch in this picture; 0: enough. The first batch of a picture is never 0, so
    /// that the slowest computer gets on.
    [[nodiscard]] std::uint64_t next() const {
        if (frames_ == 0 || (left_ <= 0 && frames_ < mostFrames)) {
            return 0;
        }
        // Frames may suddenly cost more: so a batch is a part of the picture's work only, and at most twice
        // as large as the one before.
        double const room = perFrame_ > 0 ? std::clamp(left_, 0.0, budget / 4) / perFrame_ : 1;
        auto const most = std::min(frames_, std::max<std::uint64_t>(2 * last_, 1));
        return std::clamp<std::uint64_t>(static_cast<std::uint64_t>(std::min(room, 1e6)), 1, most);
    }
    /// A batch of so many frames took that long, s.
    void took(std::uint64_t frames, double seconds) {
        spent(seconds);
        frames_ -= std::min(frames, frames_);
        if (frames == 0) {
            return;
        }
        last_ = frames;
        double const cost = std::max(seconds, 0.0) / static_cast<double>(frames);
        perFrame_ = std::max(cost, 0.5 * (perFrame_ + cost));
    }
    /// Something else took that long.
    void spent(double seconds) { left_ -= std::max(seconds, 0.0); }

private:
    double left_ = 0;          // s, in this picture
    std::uint64_t frames_ = 0; // in this picture
    double perFrame_ = 0;      // s; 0: not known
    std::uint64_t last_ = 0;   // frames of the last batch
};

} // namespace trembler::ui
