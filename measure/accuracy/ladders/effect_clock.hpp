// Measures the time of an effect's components per frame.
#pragma once

#include <string>
#include <vector>

namespace trembler {

class World;

namespace accuracy {

/// Reads the world's own time measurements. Components of a period above one do nothing in most frames, so
/// frames are grouped into windows, and the median of the windows' means is taken. Times are used only in
/// reports.
class EffectClock {
public:
    /// Name of the effect; "": all effects.
    explicit EffectClock(std::string effect) : effect_(std::move(effect)) {}
    /// Call after each frame.
    void frame(World const& world);
    /// µs per frame; 0 before the first complete window.
    [[nodiscard]] double median() const;
    /// µs per frame, for effects whose cost is concentrated in few frames; 0 before the first complete
    /// window.
    [[nodiscard]] double mean() const;

private:
    static constexpr int window = 12; // a multiple of the periods 1 to 4, 6 and 12

    std::string effect_;
    double total_ = -1; // µs, of the effect at the start of the window
    int frames_ = 0;
    std::vector<double> means_;
};

/// The median of the values; 0 if there are none.
[[nodiscard]] double medianOf(std::vector<double> values);

} // namespace accuracy
} // namespace trembler
