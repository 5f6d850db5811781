// A part before it is in a world: in the toolbox, or while it is being placed. Of a composite, all pieces and
// the joints between them.
#pragma once

#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/objects/body.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"

namespace trembler::render {

/// Draws the objects that the placement would become, as a world would show them at its start. Nothing if
/// there is no such part.
void drawPart(Canvas& canvas, PartLibrary const& library, Placement const& placement,
              Marks const& marks = {});

/// The rectangle around all of its bodies, drawings and cables; empty if there is nothing to see.
[[nodiscard]] Extent extentOfPart(PartLibrary const& library, Placement const& placement);

/// The same for the picture on a tile of the toolbox, where a part is to be recognised by itself: a cable
/// that a rope bounds has its whole length there and lies in a loop, and is never as thin as a hair.
void drawPartOnTile(Canvas& canvas, PartLibrary const& library, Placement const& placement);
/// How a part lies on its tile: straight, as in a world, but a long loose thing, such as a bar or a spanner,
/// lies diagonally, so that it is not taken for one that is fixed, such as a shelf.
[[nodiscard]] Placement placementOnTile(PartLibrary const& library, std::string const& part);
[[nodiscard]] Extent extentOnTile(PartLibrary const& library, Placement const& placement);

} // namespace trembler::render
