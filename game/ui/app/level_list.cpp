#include "game/ui/app/level_list.hpp"

#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/icons.hpp"
#include "render/panels/theme.hpp"

#include <string>
#include <system_error>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float rowHeight = 40;

void drawMark(ImVec2 centre, bool solved, bool trouble) {
    auto& list = *ImGui::GetWindowDrawList();
    float const radius = scaled(10);
    if (solved) {
        list.AddCircleFilled(centre, radius, imColour(palette::goal));
        drawIcon(list, Icon::Tick, centre, 1.15F * radius, imColour(palette::paperLight));
    } else {
        list.AddCircleFilled(centre, radius, imColour(palette::paper));
        list.AddCircle(centre, radius,
                       imColour(mix(palette::paperShade, palette::ink, trouble ? 0.2F : 0.45F)), 0,
                       scaled(1.6F));
    }
}

/// The text, truncated with an ellipsis to fit into `width` pixels.
std::string fitted(std::string const& text, float width) {
    std::string shown = text;
    std::size_t kept = text.size();
    while (kept > 0 && ImGui::CalcTextSize(shown.c_str()).x > width) {
        --kept;
        while (kept > 0 && (static_cast<unsigned char>(text[kept]) & 0xC0U) == 0x80U) {
            --kept; // do not cut inside a UTF-8 sequence
        }
        shown = text.substr(0, kept) + "…";
    }
    return shown;
}

bool drawRow(UiContext& context, CatalogEntry const& entry, bool current) {
    float const width = ImGui::GetContentRegionAvail().x;
    bool clicked = ImGui::InvisibleButton(entry.id.c_str(), {width, scaled(rowHeight)});
    context.layout.item("level " + entry.id);
    clicked = context.focus.item() || clicked;
    bool const hovered = ImGui::IsItemHovered();
    bool const trouble = !entry.trouble.empty();
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    auto& list = *ImGui::GetWindowDrawList();
    if (current || (hovered && !trouble)) {
        Colour const ground =
            current ? mix(palette::paperShade, palette::accent, 0.15F) : palette::paperShade;
        list.AddRectFilled(low, high, imColour(ground), scaled(8));
    }
    float const middle = 0.5F * (low.y + high.y);
    drawMark({low.x + scaled(22), middle}, context.profile.solved(entry.id), trouble);
    float const left = low.x + scaled(44);
    std::string const shown = fitted(entry.title, high.x - scaled(32) - left);
    ImVec2 const size = ImGui::CalcTextSize(shown.c_str());
    list.AddText({left, middle - 0.5F * size.y}, imColour(trouble ? palette::inkSoft : palette::ink),
                 shown.c_str());
    if (hovered && !trouble && shown != entry.title) {
        ImGui::SetTooltip("%s", words::wrapped(entry.title, 70).c_str());
    }
    if (trouble) {
        drawIcon(list, Icon::Cross, {high.x - scaled(18), middle}, scaled(14), imColour(palette::warning));
        if (hovered) {
            ImGui::SetTooltip("%s\n%s", words::cannotPlay, words::wrapped(entry.trouble, 70).c_str());
        }
    } else if (hovered) {
        drawIcon(list, Icon::Next, {high.x - scaled(18), middle}, scaled(14), imColour(palette::accent));
    }
    return clicked && !trouble;
}

} // namespace

CatalogEntry const* drawLevelList(UiContext& context, std::filesystem::path const& current, float height) {
    CatalogEntry const* chosen = nullptr;
    if (context.levels.size() == 0) {
        caption(words::noLevels);
        return nullptr;
    }
    float const headings = 31 * static_cast<float>(context.levels.groups().size());
    float const rows = (rowHeight + 4) * static_cast<float>(context.levels.size());
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
    ImGui::BeginChild("levels", {0, scaled(std::min(headings + rows, height))});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(scaled(4), scaled(4)));
    CatalogEntry const* const here = current.empty() ? nullptr : context.levels.find(current);
    for (CatalogGroup const& group : context.levels.groups()) {
        ImGui::Dummy({0, scaled(2)});
        ImGui::PushFont(theme().fonts.strong);
        ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
        ImGui::TextUnformatted(group.title.c_str());
        ImGui::PopStyleColor();
        ImGui::PopFont();
        for (CatalogEntry const& entry : group.levels) {
            if (drawRow(context, entry, &entry == here)) {
                chosen = &entry;
            }
        }
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleColor();
    return chosen;
}

} // namespace trembler::ui
