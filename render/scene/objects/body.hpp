// One object: its shape in its material, and the sign that it is fixed.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/scene/facts/facts.hpp"

namespace trembler::render {

/// The state of an object as the player sees it.
struct Marks {
    bool selected = false;
    bool hovered = false;
    bool ghost = false;     ///< not there yet
    bool forbidden = false; ///< may not be there
};

/// Draws the object with everything that its properties show: windings, poles, signs, bolts.
void drawObject(Canvas& canvas, Facts const& facts, Pose const& pose, Marks const& marks = {});

/// A part that is about to be placed: half transparent, hatched in the warning colour where it is not
/// allowed.
void drawGhost(Canvas& canvas, Prototype const& part, Pose const& pose, bool allowed);

/// The object's material and colour, without its marks.
[[nodiscard]] Style styleOf(Facts const& facts);

/// Draws all pieces of a shape as one body: the rims first, then the insides, so that no line runs between
/// pieces.
void drawShape(Canvas& canvas, Shape const& shape, Pose const& pose, Style style);

/// Half the smaller side of the object's box, in metres: the measure for signs on it. For an object without a
/// body, the radius of symbols.
[[nodiscard]] double innerSize(Facts const& facts);

} // namespace trembler::render
