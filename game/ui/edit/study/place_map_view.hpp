// Draws where a part of a recorded solution may lie.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

namespace trembler::ui {

/// Over the edited scene, while the page of the report has a solution chosen: its parts, as they are placed,
/// and around the chosen one its places. Between Canvas::begin and end.
void drawPlaceMap(EditParts& parts, render::Canvas& canvas);

} // namespace trembler::ui
