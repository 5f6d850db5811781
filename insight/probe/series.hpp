// A number of the world over time.
#pragma once

#include "insight/probe/watch.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler::insight {

/// A value in a frame.
struct Sample {
    std::uint64_t frame = 0;
    double value = 0;
};

/// One line of a plot.
struct Series {
    std::string name;            ///< as asked for: "ball.velocity.x"
    std::string unit;            ///< empty: a pure number
    std::vector<Sample> samples; ///< ascending by frame; frames without a value are left out

    /// The value in the latest frame not after `frame`; nothing before the first sample.
    [[nodiscard]] std::optional<double> at(std::uint64_t frame) const;
};

/// Numbers of objects that are read frame by frame. Texts are left out. Their memory is bounded: when there
/// are too many samples, every second frame is forgotten, and later frames are kept as sparsely, so that all
/// of the run remains, with equal gaps. Not thread-safe.
class Probes {
public:
    /// Of all numbers together; 64 MB. Two frames stay in any case.
    static constexpr std::size_t mostSamples = 4'000'000;

    explicit Probes(std::size_t most = mostSamples) : most_(most) {}

    /// Adds a field, see watch::find(), which throws std::invalid_argument. Its series are empty.
    void add(World const& world, std::vector<watch::WatchedField> const& fields, std::string const& what);
    /// Whether there is one of that name.
    [[nodiscard]] bool has(std::string_view what) const;
    void remove(std::string_view what);

    /// Reads all of them in a world, which is in this frame. Frames must ascend.
    void look(World const& world, std::uint64_t frame);
    /// Forgets all samples after a frame.
    void forgetAfter(std::uint64_t frame);
    void clearSamples();

    [[nodiscard]] std::span<watch::Watch const> watches() const { return watches_; }
    /// One for each number: a vector has two.
    [[nodiscard]] std::vector<Series> const& series() const { return series_; }
    /// The frames that look() was called for, ascending, without those that were forgotten.
    [[nodiscard]] std::vector<std::uint64_t> const& frames() const { return frames_; }
    /// The last frame that was looked at, whether it was kept or not.
    [[nodiscard]] std::optional<std::uint64_t> last() const { return last_; }

private:
    void thinOut();

    std::vector<watch::Watch> watches_;
    std::vector<Series> series_; // in the order of watches_
    std::vector<std::uint64_t> frames_;
    std::optional<std::uint64_t> last_;
    std::size_t most_;
    std::uint64_t gap_ = 1; // between kept frames, at least
};

} // namespace trembler::insight
