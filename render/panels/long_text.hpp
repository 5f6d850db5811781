// Long texts in Dear ImGui's draw lists.
//
// Debian builds Dear ImGui with indices of 16 bits and with assertions, so that one call that draws more than
// 16,383 letters ends the program. All text that ImGui and we draw goes through ImDrawList::AddText. The linker
// replaces it (--wrap, see CMakeLists.txt) by a function that passes short texts on, and draws of long ones the
// lines that are in sight, piece by piece.
#pragma once

#include <cstddef>

namespace trembler::render {

/// Bytes of text that are passed on as they are: four vertices for each letter are below 65,536.
inline constexpr std::ptrdiff_t mostBytesAtOnce = 16'000;

} // namespace trembler::render
