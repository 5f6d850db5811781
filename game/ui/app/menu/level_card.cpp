#include "game/ui/app/menu/level_card.hpp"

#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/icons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float pictureHeight = 112; // pixels at UI scale 1

void drawStar(ImDrawList& list, ImVec2 centre, float radius, bool reached) {
    std::array<ImVec2, 10> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        float const angle = 3.14159265F * (static_cast<float>(i) / 5 - 0.5F);
        float const far = i % 2 == 0 ? radius : 0.45F * radius;
        corners[i] = {centre.x + far * std::cos(angle), centre.y + far * std::sin(angle)};
    }
    if (reached) {
        for (std::size_t i = 0; i < corners.size(); ++i) { // concave: a fan of triangles
            list.AddTriangleFilled(centre, corners[i], corners[(i + 1) % corners.size()],
                                   imColour(palette::live));
        }
    }
    Colour const line = mix(palette::paperShade, palette::ink, reached ? 0.75F : 0.4F);
    list.AddPolyline(corners.data(), static_cast<int>(corners.size()), imColour(line), ImDrawFlags_Closed,
                     scaled(1.4F));
}

/// At most two lines of at most `width` pixels; a longer text ends in an ellipsis.
std::vector<std::string> inTwoLines(std::string const& text, float width) {
    std::vector<std::string> lines(1);
    std::size_t start = 0;
    while (start < text.size()) {
        std::size_t const end = std::min(text.find(' ', start), text.size());
        std::string const word = text.substr(start, end - start);
        std::string const longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (ImGui::CalcTextSize(longer.c_str()).x <= width || lines.back().empty()) {
            lines.back() = longer;
        } else if (lines.size() < 2) {
            lines.push_back(word);
        } else {
            lines.back() += " …";
            break;
        }
        start = end + 1;
    }
    for (std::string& line : lines) {
        bool cut = false;
        while (!line.empty() && ImGui::CalcTextSize((cut ? line + "…" : line).c_str()).x > width) {
            cut = true;
            do { // do not cut inside a UTF-8 sequence
                line.pop_back();
            } while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0U) == 0x80U);
        }
        line += cut ? "…" : "";
    }
    return lines;
}

void drawStars(UiContext const& context, CatalogEntry const& entry, ImVec2 low, ImVec2 high) {
    auto& list = *ImGui::GetWindowDrawList();
    int const stars = context.profile.progress().of(entry.id).stars();
    int const shown = entry.demonstration ? (entry.task ? 1 : 0) : std::max(stars, shownStars);
    float const y = high.y - scaled(15);
    if (entry.task) {
        char const* const words = text(stars > 0 ? "levels.task_done" : "levels.task");
        ImFont* const font = theme().fonts.small;
        list.AddText(font, font->FontSize, {low.x + scaled(34), y - 0.5F * font->FontSize},
                     imColour(palette::inkSoft), words);
    }
    for (int i = 0; i < shown; ++i) {
        drawStar(list, {low.x + scaled(19 + 20 * static_cast<float>(i)), y}, scaled(8.5F), i < stars);
    }
}

void drawPicture(UiContext& context, CatalogEntry const& entry, ImVec2 low, ImVec2 high) {
    auto& list = *ImGui::GetWindowDrawList();
    Size const size{static_cast<int>(high.x - low.x), static_cast<int>(high.y - low.y)};
    bool const seen = ImGui::IsRectVisible(low, high);
    unsigned const texture = seen ? context.pictures.texture(entry, size) : 0;
    if (auto const why = context.pictures.takeTrouble()) {
        context.levels.noteTrouble(entry.id, *why);
    }
    if (texture != 0) {
        list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), low, high, {0, 1},
                      {1, 0});
    } else {
        list.AddRectFilled(low, high, imColour(palette::paperShade));
    }
    if (!entry.trouble.empty()) {
        drawIcon(list, Icon::Cross, {0.5F * (low.x + high.x), 0.5F * (low.y + high.y)}, scaled(26),
                 imColour(palette::warning));
    }
}

void showTip(CatalogEntry const& entry, std::string const& title, bool cut) {
    if (!entry.trouble.empty()) {
        ImGui::SetTooltip("%s\n%s", text("levels.cannot_play"), words::wrapped(entry.trouble, 70).c_str());
    } else if (cut) {
        ImGui::SetTooltip("%s", words::wrapped(title, 70).c_str());
    }
}

} // namespace

bool drawLevelCard(UiContext& context, CatalogEntry const& entry, LevelCardOptions const& options) {
    bool clicked = ImGui::InvisibleButton(entry.id.c_str(), {scaled(options.width), scaled(levelCardHeight)});
    context.layout.item("level " + entry.id);
    bool const hovered = ImGui::IsItemHovered();
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    bool const trouble = !entry.trouble.empty(); // as far as it was known in the last picture
    auto& list = *ImGui::GetWindowDrawList();
    Colour const ground = hovered && !trouble ? mix(palette::paperLight, palette::accent, 0.12F)
                                              : mix(palette::paperLight, palette::paper, 0.35F);
    list.AddRectFilled(low, high, imColour(ground), scaled(9));
    float const rim = scaled(1.5F);
    drawPicture(context, entry, {low.x + rim, low.y + scaled(7)},
                {high.x - rim, low.y + scaled(7 + pictureHeight)});
    bool const marked = options.current || options.next;
    list.AddRect(low, high,
                 imColour(marked ? palette::accent : mix(palette::paperShade, palette::ink, 0.35F)),
                 scaled(9), 0, scaled(marked ? 2.6F : 1.4F));
    clicked = context.focus.item() || clicked;
    ImGui::PushFont(theme().fonts.small);
    std::string const title = titleIn(entry.texts, std::string(languageInUse()), entry.title);
    std::vector<std::string> const lines = inTwoLines(title, high.x - low.x - scaled(20));
    float y = low.y + scaled(pictureHeight + 12);
    for (std::string const& line : lines) {
        list.AddText({low.x + scaled(10), y}, imColour(trouble ? palette::inkSoft : palette::ink),
                     line.c_str());
        y += ImGui::GetTextLineHeight();
    }
    char const* const note = options.current ? text("levels.here") : options.next ? text("levels.next") : "";
    ImVec2 const size = ImGui::CalcTextSize(note);
    list.AddText({high.x - scaled(10) - size.x, high.y - scaled(15) - 0.5F * size.y},
                 imColour(palette::accent), note);
    ImGui::PopFont();
    if (!trouble) {
        drawStars(context, entry, low, high);
    }
    if (hovered) {
        showTip(entry, title, !lines.empty() && lines.back().ends_with("…"));
    }
    return clicked && entry.trouble.empty();
}

} // namespace trembler::ui
