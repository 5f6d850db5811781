// How long an effect's components take in a frame.
#pragma once

#include <string>
#include <vector>

namespace trembler {

class World;

namespace accuracy {

/// Reads the world's own stopwatch. Components of a period above one do nothing in most frames, so frames are
/// gathered into windows, whose means the median is taken of. Times reach nobody but the report.
class EffectClock {
public:
    /// "": all effects.
    explicit EffectClock(std::string effect) : effect_(std::move(effect)) {}
    /// To be called after each frame.
    void frame(World const& world);
    /// µs per frame; 0 before the first whole window.
    [[nodiscard]] double median() const;
    /// µs per frame, for effects whose cost lies in a few frames; 0 before the first whole window.
    [[nodiscard]] double mean() const;

private:
    static constexpr int window = 12; // a multiple of the periods 1 to 4, 6 and 12

    std::string effect_;
    double total_ = -1; // µs, of the effect at the beginning of the window
    int frames_ = 0;
    std::vector<double> means_;
};

/// The middle of the values; 0 of none.
[[nodiscard]] double medianOf(std::vector<double> values);

} // namespace accuracy
} // namespace trembler
