// A circle inside a body, used in place of the body's shape if the body is so fast that it could jump through
// others.
#pragma once

#include "physics/dynamics/core/engine.hpp"

namespace trembler {

struct BodyCore {
    Vec2 at; ///< m, from the centre of mass, in the body's frame
    double radius = 0;

    /// How far a body can move in a substep, in m, before it could jump through another.
    [[nodiscard]] double reach() const { return radius / 2; }
};

/// The core in the piece that contains the largest circle.
[[nodiscard]] BodyCore coreOf(BodySpec const& spec);

/// How far a body's points may move in the last substep of a step, in m, before contacts are detected at its
/// end as well: a substep detects contacts at the positions at its beginning, but the world reads positions
/// at its end.
inline constexpr double farInSubstep = 0.01;

/// An upper bound, in m, of the distance of the body's points from its centre of mass.
[[nodiscard]] double extentOf(BodySpec const& spec);

} // namespace trembler
