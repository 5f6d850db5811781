#include "game/ui/shared/letters/field_in_use.hpp"

namespace trembler::ui {

ImGuiInputTextState* fieldInUse() {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    return context.ActiveId == 0 ? nullptr : ImGui::GetInputTextState(context.ActiveId);
}

bool hasLines(ImGuiInputTextState const& field) {
    return field.Stb.single_line == 0; // its flags are not kept by every version
}

bool takesNumbers(ImGuiInputTextState const& field) {
    return ImGui::GetCurrentContext()->TempInputId == field.ID;
}

std::string inOneLine(ImWchar const* from, ImWchar const* to) {
    std::string text(4 * static_cast<std::size_t>(to - from) + 1, '\0');
    text.resize(
        static_cast<std::size_t>(ImTextStrToUtf8(text.data(), static_cast<int>(text.size()), from, to)));
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n' && (i == 0 || text[i - 1] != '\r')) {
            line += "↵";
        } else if (text[i] != '\n' && text[i] != '\r') {
            line += text[i];
        }
    }
    return line;
}

} // namespace trembler::ui
