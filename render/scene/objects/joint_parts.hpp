// How each kind of joint is drawn.
#pragma once

#include "render/scene/objects/joints.hpp"

namespace trembler::render {

inline constexpr double pinRadius = 0.045; ///< m

/// Everything but gears.
void drawJoint(Canvas& canvas, Joint const& joint, JointPlaces const& places);

/// The pitch circles of two gears about their pins, as dash-dotted lines: they touch, and their radii are in
/// the ratio of the gears. An inner gear (negative ratio) encloses the other.
void drawGearPitch(Canvas& canvas, Point pinA, Point pinB, double ratio);

} // namespace trembler::render
