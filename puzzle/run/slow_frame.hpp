// Frames that take long are told, whether a level runs with or without a window. How long one takes depends
// on the machine, so it may only be told and must decide nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace trembler {

class World;

/// A frame that takes more of this process's time on processors is told, in s; not the time that passes, so
/// that a busy machine makes no frame slow.
inline constexpr double slowAfter = 2;

/// The time on processors that this process has used in all its threads, in s.
[[nodiscard]] double processorSeconds();

struct SlowFrame {
    std::uint64_t frame = 0;
    double seconds = 0;         ///< of time on processors
    std::string_view component; ///< in which its last part spent most of it; empty: none is constructed
};

/// In English: "frame 12 took 3.1 s of processor time, most of it in Dynamics".
[[nodiscard]] std::string inWords(SlowFrame const& slow);

/// Measures the frames of a world, one after the other.
class FrameTimer {
public:
    /// `limit`: s that a frame may take without being told; below 0 every frame is told. `clock`: s, see
    /// processorSeconds().
    explicit FrameTimer(double limit = slowAfter, std::function<double()> clock = processorSeconds)
        : limit_(limit), clock_(std::move(clock)) {}
    /// To be called directly before a frame.
    void begin() { begun_ = clock_(); }
    /// To be called directly after it: the frame if it took longer than the limit.
    [[nodiscard]] std::optional<SlowFrame> end(World const& world) const;

private:
    double limit_;
    std::function<double()> clock_;
    double begun_ = 0;
};

} // namespace trembler
