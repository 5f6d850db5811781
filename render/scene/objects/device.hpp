// The marks of an object that is more than a body: windings, poles, bulbs, signs of electricity, bolts.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/facts/facts.hpp"
#include "render/scene/facts/poses.hpp"

namespace trembler::render {

/// The light around an object that is at work (a device with current, a magnet that pulls); none otherwise.
[[nodiscard]] Glow deviceGlow(Facts const& facts);

/// Of an object whose form is a bulb: its largest piece as glass with a filament, the others as its metal
/// socket. In place of the plain shape.
void drawBulb(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style);

/// Draws over the object's shape. From `style` it takes the marks for the player (ghost and so on).
void drawDevice(Canvas& canvas, Facts const& facts, Pose const& pose, Style const& style);

/// Where a wire that comes from `towards` (world) is fastened to the object, in the world.
[[nodiscard]] Point terminalOf(Facts const& facts, Pose const& pose, Point towards);

} // namespace trembler::render
