// The list of levels to choose from, with their titles and a mark on solved ones.
#pragma once

#include "game/ui/shared/ui_context.hpp"

namespace trembler::ui {

/// Draws the list into the open card, at most `height` pixels at UI scale 1 high; returns the level that was
/// chosen in this picture, or nullptr.
CatalogEntry const* drawLevelList(UiContext& context, std::filesystem::path const& current, float height);

} // namespace trembler::ui
