// A circle inside a body that stands for it where it is so fast that it could jump through others.
#pragma once

#include "physics/dynamics/core/engine.hpp"

namespace trembler {

struct BodyCore {
    Vec2 at; ///< m, from the centre of mass, in the body's frame
    double radius = 0;

    /// How far a body can move in a substep before it could jump through another, in m.
    [[nodiscard]] double reach() const { return radius / 2; }
};

/// Of the piece that holds the largest circle.
[[nodiscard]] BodyCore coreOf(BodySpec const& spec);

/// How far a body's points may move in a step's last substep, in m, before what touches is looked for at its
/// end: what a substep finds to touch are the places at its beginning, and the world sees those at its end.
inline constexpr double farInSubstep = 0.01;

/// The distance of its farthest point from the centre of mass, in m, or a little more.
[[nodiscard]] double extentOf(BodySpec const& spec);

} // namespace trembler
