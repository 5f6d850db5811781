#include "game/ui/shared/letters/keyboard_drawing.hpp"

#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/icons.hpp"
#include "render/panels/theme.hpp"
#include "render/window/gamepad.hpp"

#include <imgui_internal.h>

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;

// Pixels at UI scale 1.
constexpr float widestKeyboard = 660;
constexpr float highestKey = 42;
constexpr float keyGap = 4;

/// The signs on keys that are not letters.
char const* signOf(LetterKey const& key, KeyPage page) {
    switch (key.act) {
    case KeyAct::shift:
        return "⇧";
    case KeyAct::signs:
        return page == KeyPage::letters || page == KeyPage::capitals ? "#+=" : "abc";
    case KeyAct::blank:
        return words::blankKey;
    case KeyAct::newLine:
        return "↵";
    case KeyAct::left:
        return "←";
    case KeyAct::right:
        return "→";
    case KeyAct::erase:
        return "⌫";
    case KeyAct::type:
    case KeyAct::cancel:
    case KeyAct::done:
        break;
    }
    return key.text.c_str();
}

std::string nameOfKey(LetterKey const& key) {
    switch (key.act) {
    case KeyAct::type:
        return "letter " + key.text;
    case KeyAct::shift:
        return "letters shift";
    case KeyAct::signs:
        return "letters signs";
    case KeyAct::blank:
        return "letters blank";
    case KeyAct::newLine:
        return "letters new line";
    case KeyAct::left:
        return "letters left";
    case KeyAct::right:
        return "letters right";
    case KeyAct::erase:
        return "letters erase";
    case KeyAct::cancel:
        return "letters cancel";
    case KeyAct::done:
        break;
    }
    return "letters done";
}

void drawKey(LetterKey const& key, KeyPage page, bool chosen, ImVec2 low, ImVec2 high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    bool const lit = key.act == KeyAct::shift && page == KeyPage::capitals;
    bool const letter = key.act == KeyAct::type || key.act == KeyAct::blank;
    list.AddRectFilled(low, high,
                       imColour(chosen   ? palette::accent
                                : lit    ? palette::grid
                                : letter ? palette::paper
                                         : palette::paperShade),
                       scaled(6));
    ImU32 const ink = imColour(chosen ? palette::paperLight : palette::ink);
    ImVec2 const middle{0.5F * (low.x + high.x), 0.5F * (low.y + high.y)};
    if (key.act == KeyAct::done || key.act == KeyAct::cancel) {
        drawIcon(list, key.act == KeyAct::done ? Icon::Tick : Icon::Cross, middle,
                 std::min(scaled(18), 0.7F * (high.y - low.y)), ink);
        return;
    }
    char const* const sign = signOf(key, page);
    ImVec2 const size = ImGui::CalcTextSize(sign);
    list.PushClipRect(low, high, true);
    list.AddText({middle.x - 0.5F * size.x, middle.y - 0.5F * size.y}, ink, sign);
    list.PopClipRect();
}

/// The line that is being typed; of a long one the part around the cursor.
void drawTyped(ShownKeyboard const& shown, float width) {
    ImVec2 const low = ImGui::GetCursorScreenPos();
    float const height = ImGui::GetTextLineHeight() + scaled(8);
    ImVec2 const high{low.x + width, low.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, imColour(palette::paper), scaled(6));
    float const inset = scaled(8);
    float const before = ImGui::CalcTextSize(shown.before.c_str()).x;
    float const room = width - 2 * inset;
    float const start = low.x + inset - std::max(before - 0.8F * room, 0.F);
    float const top = low.y + scaled(4);
    list.PushClipRect({low.x + 0.5F * inset, low.y}, {high.x - 0.5F * inset, high.y}, true);
    list.AddText({start, top}, imColour(palette::ink), (shown.before + shown.behind).c_str());
    float const at = start + before;
    list.AddLine({at, low.y + scaled(3)}, {at, high.y - scaled(3)}, imColour(palette::accent), scaled(2));
    list.PopClipRect();
    ImGui::Dummy({width, height});
}

} // namespace

std::string legendOf(KeyBindings const& bindings) {
    auto const button = [&](std::string_view id) {
        for (Chord const& chord : bindings.keysOf(id)) {
            if (std::string_view const name = nameOfPadKey(chord.key); name.starts_with("Pad ")) {
                return std::string(name.substr(4));
            }
        }
        return std::string(words::nothingStated);
    };
    return textWith(
        "{}: press · {}: delete · {}: space · {}, {}: cursor · {}: capitals · {}: signs · {}: done "
        "· {}: cancel",
        button("menu-press"), button("letters-erase"), button("letters-space"), button("letters-left"),
        button("letters-right"), button("letters-capitals"), button("letters-signs"), button("letters-done"),
        button("back"));
}

void drawKeyboard(Layout& layout, ShownKeyboard const& shown) {
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    float const card = std::min(widestKeyboard, screen.x / theme().scale - 16);
    layout.beginCard("letters", "", {.anchor = Anchor::Bottom, .offset = {0, 8}, .width = card});
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    float const width = ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(theme().fonts.small);
    ImVec2 const legend = ImGui::CalcTextSize(shown.legend.c_str(), nullptr, false, width);
    ImGui::PopFont();
    drawTyped(shown, width);
    // Never more than two thirds of the window.
    float const rest = 0.66F * screen.y - 2 * ImGui::GetStyle().WindowPadding.y - legend.y -
                       ImGui::GetTextLineHeight() - scaled(8) - scaled(8);
    float const step =
        std::clamp(rest / static_cast<float>(rowsOfKeys), ImGui::GetTextLineHeight(), scaled(highestKey));
    float const gap = std::min(scaled(keyGap), 0.12F * step);
    ImVec2 const from = ImGui::GetCursorScreenPos();
    float const unit = (width + gap) / static_cast<float>(rowOfKeys);
    for (std::size_t i = 0; i < shown.keys.size(); ++i) {
        LetterKey const& key = shown.keys[i];
        ImVec2 const low{from.x + unit * static_cast<float>(key.left),
                         from.y + step * static_cast<float>(key.row)};
        ImVec2 const high{low.x + unit * static_cast<float>(key.width) - gap, low.y + step - gap};
        ImGui::SetCursorScreenPos(low);
        ImGui::Dummy({high.x - low.x, high.y - low.y});
        layout.item(nameOfKey(key));
        drawKey(key, shown.page, i == shown.chosen, low, high);
    }
    ImGui::SetCursorScreenPos({from.x, from.y + step * static_cast<float>(rowsOfKeys)});
    ImGui::PushFont(theme().fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::inkSoft));
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width + 1);
    ImGui::TextUnformatted(shown.legend.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    layout.endCard();
}

} // namespace trembler::ui
