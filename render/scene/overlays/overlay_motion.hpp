// How bodies move: centres of mass and velocities; and the player's hand.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/objects/wires.hpp"

namespace trembler::render {

/// The draughtsman's quartered disc at the centre of mass of every body that can move, and an arrow along its
/// velocity (logarithmic, from about 5 cm/s on).
void drawMotion(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf);

/// The elastic cord between the held object and the place that the hand pulls it to; nothing while the hand
/// is empty.
void drawHand(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf);

} // namespace trembler::render
