// Pictures of the editor's tools and pages, drawn with lines.
#pragma once

#include "game/ui/edit/tools/tool.hpp"

#include <imgui.h>

namespace trembler::ui {

/// Within a square of `size` pixels around `centre`.
void drawToolIcon(ImDrawList& list, Tool tool, ImVec2 centre, float size, ImU32 colour);
void drawTabIcon(ImDrawList& list, Tab tab, ImVec2 centre, float size, ImU32 colour);

/// A square button of the bar with one of these pictures; true when it is clicked. `side` in pixels at UI
/// scale 1.
bool toolButton(char const* id, Tool tool, char const* tip, bool on, float side = 38);
bool tabButton(char const* id, Tab tab, char const* tip, bool on, float width, float height = 34);

} // namespace trembler::ui
