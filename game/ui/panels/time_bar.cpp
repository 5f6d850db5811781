#include "game/ui/panels/time_bar.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {

using namespace render;

void drawTimeBar(TimeBar const& bar) {
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const width = ImGui::GetContentRegionAvail().x;
    float const height = bar.framed ? ImGui::GetFrameHeight() : ImGui::GetTextLineHeight();
    float const room = std::max(width - scaled(bar.numbers), scaled(10));
    float const middle = at.y + 0.5F * height;
    float const half = scaled(bar.half);
    auto& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x, middle - half}, {at.x + room, middle + half}, imColour(palette::paperShade),
                       half);
    if (bar.share > 0) {
        float const filled = std::max(room * std::min(bar.share, 1.F), 2 * half);
        list.AddRectFilled({at.x, middle - half}, {at.x + filled, middle + half},
                           imColour(bar.over ? palette::warning : palette::accent), half);
    }
    if (bar.limit > 0) {
        float const x = at.x + room * std::min(bar.limit, 1.F);
        list.AddLine({x, middle - 1.7F * half}, {x, middle + 1.7F * half}, imColour(palette::ink), scaled(2));
    }
    ImVec2 const size = ImGui::CalcTextSize(bar.text.c_str());
    list.AddText({at.x + width - size.x, middle - 0.5F * size.y},
                 imColour(bar.grey ? palette::inkSoft : palette::ink), bar.text.c_str());
    ImGui::Dummy({width, height});
}

} // namespace trembler::ui
