// The player's hand.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/objects/wires.hpp"

namespace trembler::render {

/// The elastic cord between the held object and the place that the hand pulls it to; nothing while the hand
/// is empty.
void drawHand(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf);

} // namespace trembler::render
