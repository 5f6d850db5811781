// How fast a run is shown: from a quarter of real time to eight times as fast.
#pragma once

#include "game/ui/shared/frame_clock.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace trembler::ui {

/// The speeds that the player can choose, in multiples of real time, ascending. The world always advances in
/// whole frames of 1/60 s; only their number per picture changes.
inline constexpr std::array speeds{0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

/// The chosen speed, the frames that are due, and whether the computer keeps up. Reads no clock. Any thread.
class Speed {
public:
    /// Times real time while the key for fast motion is held, and of the switch for fast motion.
    static constexpr double fast = 4;

    void slower() { chosen_ -= chosen_ > 0 ? 1 : 0; }
    void faster() { chosen_ += chosen_ + 1 < speeds.size() ? 1 : 0; }
    void setNormal() { chosen_ = normal; }
    void switchFast() { chosen_ = chosen_ == quick ? normal : quick; }
    /// To be set for each picture.
    void holdFast(bool held) { held_ = held; }

    /// Times real time, the held key included.
    [[nodiscard]] double now() const { return held_ ? fast : speeds[chosen_]; }
    [[nodiscard]] bool canSlow() const { return chosen_ > 0; }
    [[nodiscard]] bool canHurry() const { return chosen_ + 1 < speeds.size(); }

    /// Frames to compute in a picture that comes `seconds` after the last one. If computing them takes so
    /// long that less than about ten pictures a second remain, their number is reduced until the picture
    /// moves again: a slow computer is slower than asked for, but answers.
    [[nodiscard]] int due(double seconds);
    [[nodiscard]] double alpha() const { return clock_.alpha(); }
    /// A run begins, or goes on after a pause.
    void reset();
    /// The real speed of the world over the last seconds, as a multiple of real time; nothing if that is
    /// about the requested speed, or not yet known.
    [[nodiscard]] std::optional<double> onlyReached() const;

private:
    static constexpr std::size_t normal = 2; // index of 1 in speeds
    static constexpr std::size_t quick = 4;  // index of `fast`
    void measure(double seconds, int frames);

    FrameClock clock_;
    std::size_t chosen_ = normal;
    bool held_ = false;
    int last_ = 0;       // frames of the last picture
    int most_ = 0;       // frames of a picture at most; 0: no limit but the clock's
    double span_ = 0;    // s, of the current measurement
    double shown_ = 0;   // s, of the world, in it
    double asked_ = 0;   // s, of the world, that should have been shown in it
    int behind_ = 0;     // consecutive measurements in which the world was too slow
    double reached_ = 0; // in the last measurement
};

} // namespace trembler::ui
