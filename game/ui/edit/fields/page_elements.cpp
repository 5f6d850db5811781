#include "game/ui/edit/fields/page_elements.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

namespace trembler::ui {
namespace {

using namespace render;

constexpr float arrowGap = 3; // pixels at UI scale 1

} // namespace

bool smallButton(EditParts& parts, char const* label, std::string const& item, char const* tip) {
    bool const clicked = ImGui::Button((std::string(label) + "##" + item).c_str());
    parts.context.layout.item(item);
    if (tip != nullptr && ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", tip);
    }
    return clicked;
}

std::optional<std::size_t> orderArrows(EditParts& parts, std::string const& item, std::size_t index,
                                       std::size_t count) {
    std::optional<std::size_t> to;
    auto const arrow = [&](char const* id, ImGuiDir way, bool possible, char const* tip, std::size_t target) {
        ImGui::SameLine(0, scaled(arrowGap));
        ImGui::BeginDisabled(!possible); // it keeps its place under a mouse that clicks it again
        if (ImGui::ArrowButton(id, way)) {
            to = target;
        }
        ImGui::EndDisabled();
        parts.context.layout.item(item + " " + id);
        if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
            ImGui::SetTooltip("%s", tip);
        }
    };
    arrow("up", ImGuiDir_Up, index > 0, words::upIt, index - 1);
    arrow("down", ImGuiDir_Down, index + 1 < count, words::downIt, index + 1);
    return to;
}

float orderArrowsWidth() {
    return 2 * (ImGui::GetFrameHeight() + scaled(arrowGap));
}

void besideIfRoom(char const* label) {
    float const gap = scaled(6);
    float const width = ImGui::CalcTextSize(label, nullptr, true).x + 2 * ImGui::GetStyle().FramePadding.x;
    float const edge = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + gap + width <= edge) {
        ImGui::SameLine(0, gap);
    }
}

void pageHeading(char const* text) {
    ImGui::Dummy({0, scaled(2)});
    ImGui::PushFont(theme().fonts.strong);
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

} // namespace trembler::ui
