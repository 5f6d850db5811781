// The small signs that show the function of an object, drawn as strokes so that they are crisp at any size.
#pragma once

#include "render/draw/canvas.hpp"

#include <optional>

namespace trembler::render {

enum class Sign : std::uint8_t {
    plus,  ///< the source of a network
    minus, ///< the other pole of a battery
    earth, ///< the return of a network, as in circuit diagrams (IEC 60617)
    flash, ///< a user of electricity
    north, ///< letter N
    south, ///< letter S
};

/// The bare sign inside a circle of `radius` metres; `angle` in radians turns it.
void drawSign(Canvas& canvas, Sign sign, Pose const& pose, double radius, Colour colour, float alpha = 1.F);

/// The sign on a disc of paper with a dark edge; a live one is lit. Without a sign the disc is blank: the
/// ground for a label.
void drawBadge(Canvas& canvas, std::optional<Sign> sign, Pose const& pose, double radius, bool live,
               Style const& style);

} // namespace trembler::render
