// A part before it is in a world: in the toolbox, or while it is being placed. Of a composite, all pieces and
// what joins them.
#pragma once

#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/objects/body.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"

namespace trembler::render {

/// Draws what the placement would become, as a world would show it at its start. Nothing if there is no such
/// part.
void drawPart(Canvas& canvas, PartLibrary const& library, Placement const& placement,
              Marks const& marks = {});

/// The rectangle around all of its bodies, drawings and cables, for the toolbox' picture; empty if there is
/// nothing to see.
[[nodiscard]] Extent extentOfPart(PartLibrary const& library, Placement const& placement);

} // namespace trembler::render
