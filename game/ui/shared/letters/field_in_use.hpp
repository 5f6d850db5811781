// The field for text or numbers that has the keys, as ImGui knows it.
#pragma once

#include <imgui_internal.h>

#include <string>

namespace trembler::ui {

/// nullptr if there is none.
[[nodiscard]] ImGuiInputTextState* fieldInUse();
/// Whether it has several lines.
[[nodiscard]] bool hasLines(ImGuiInputTextState const& field);
/// Whether it is a number that can be dragged, while it is typed.
[[nodiscard]] bool takesNumbers(ImGuiInputTextState const& field);
/// A piece of a field's text, without the breaks of wrapped lines; its own are signs.
[[nodiscard]] std::string inOneLine(ImWchar const* from, ImWchar const* to);

} // namespace trembler::ui
