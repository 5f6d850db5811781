// The player's hand.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/objects/wires.hpp"

#include <array>
#include <optional>

namespace trembler::render {

/// Of the two hands, where the player points; nothing: where the hand pulls to.
using HandPlaces = std::array<std::optional<Point>, 2>;

/// The elastic cord between the held object and the hand's place; nothing while the hand is empty.
void drawHand(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf,
              HandPlaces const& places = {});

} // namespace trembler::render
