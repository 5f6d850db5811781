// The levels to choose from, with their titles and a mark on those that are solved.
#pragma once

#include "game/ui/shared/ui_context.hpp"

namespace trembler::ui {

/// Draws the list into the open card, at most `height` pixels at UI scale 1 high; returns the level that was
/// chosen.
CatalogEntry const* drawLevelList(UiContext& context, std::filesystem::path const& current, float height);

} // namespace trembler::ui
