// Long texts in Dear ImGui's draw lists.
//
// Debian builds Dear ImGui with indices of 16 bits and with assertions, so that one call that draws more than
// 16,383 letters ends the program. All text that ImGui and we draw goes through ImDrawList::AddText. The
// linker replaces it (--wrap, see CMakeLists.txt) by a function that passes short texts on, and draws of long
// ones the lines that are in sight, piece by piece.
#pragma once

#include <imgui.h>

#include <cstddef>

namespace trembler::render {

/// Bytes of text that are passed on as they are: four vertices for each letter are below 65,536.
inline constexpr std::ptrdiff_t mostBytesAtOnce = 16'000;

/// Draws a text as ImDrawList::AddText does, whatever its length: the lines in sight, each in pieces. Between
/// two frames' calls of ImGui::NewFrame and ImGui::Render.
void addLongText(ImDrawList& list, ImFont const& font, float size, ImVec2 const& at, ImU32 colour,
                 char const* begin, char const* end, float wrapWidth, ImVec4 const* fineClip);

} // namespace trembler::render
