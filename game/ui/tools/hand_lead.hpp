// How far ahead of the pointer the hand pulls.
#pragma once

#include "runtime/math/vec2.hpp"

#include <array>
#include <cstddef>

namespace trembler::ui {

/// The hand is a damped spring (DynamicsFromPlayer), so what it drags at a steady speed stays behind it by
/// 0.17 s of the way: more than the radius of a crank that is turned once a second, which then does not turn
/// with the hand at all. Pulled to a place as far ahead of the pointer, it stays at the pointer. Only a
/// motion that has lasted for eight frames counts, so that a jump of the pointer throws nothing. A value
/// type; any thread.
class HandLead {
public:
    /// The hand takes hold of something at this place of the world (m) and rests there.
    void begin(Vec2 pointer);
    /// The place to pull to (m), 0 to `most` from the pointer; to be called once for each frame of the run.
    [[nodiscard]] Vec2 ahead(Vec2 pointer);

    static constexpr double most = 0.5; ///< m
    /// s, by which a critically damped spring of 12 rad/s follows a steady motion late: 2 / (12 rad/s).
    static constexpr double springDelay = 1.0 / 6;

private:
    static constexpr std::size_t half = 4;  // frames, of each of two successive motions that are compared
    std::array<Vec2, 2 * half + 1> last_{}; // of successive frames, the newest first
};

} // namespace trembler::ui
