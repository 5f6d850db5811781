#include "game/ui/cards/play_cards.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"
#include "render/panels/unbroken.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;

/// The number of the hint, and the buttons for the others and to fold the card, which keep their places.
HintCardAsked drawHintHead(Layout& layout, HintCardLook const& look) {
    HintCardAsked asked;
    float const side = scaled(40);
    float const gap = scaled(6);
    bool const several = look.hints.size() > 1;
    ImVec2 const start = ImGui::GetCursorPos();
    float const right = start.x + ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(theme().fonts.strong);
    ImGui::SetCursorPosY(start.y + 0.5F * (side - ImGui::GetTextLineHeight()));
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
    ImGui::TextUnformatted(words::hintOf(look.at + 1, look.total).c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
    float x = right - side;
    ImGui::SetCursorPos({x, start.y});
    asked.fold = iconButton("fold hints", Icon::Cross, words::foldHints);
    layout.item("fold hints");
    if (several) {
        x -= side + gap;
        ImGui::SetCursorPos({x, start.y});
        bool const more = look.at + 1 < look.hints.size();
        if (iconButton("hint after", Icon::Next, words::hintAfter, false, more)) {
            asked.at = look.at + 1;
        }
        layout.item("hint after");
        x -= side + gap;
        ImGui::SetCursorPos({x, start.y});
        if (iconButton("hint before", Icon::Back, words::hintBefore, false, look.at > 0)) {
            asked.at = look.at - 1;
        }
        layout.item("hint before");
    }
    ImGui::SetCursorPos({start.x, start.y + side + scaled(6)});
    return asked;
}

} // namespace

HintCardAsked drawHintCard(Layout& layout, HintCardLook const& look) {
    HintCardAsked asked;
    if (look.hints.empty()) {
        return asked;
    }
    layout.beginCard("hints", "",
                     {.anchor = Anchor::TopLeft, .offset = {cardGap, look.top}, .width = goalCardWidth});
    asked = drawHintHead(layout, look);
    // Text that does not fit scrolls; the height used is that of the last picture.
    std::string const& hint = look.hints[std::min(look.at, look.hints.size() - 1)];
    ImGuiID const heightId = ImGui::GetID("height of the hint");
    float const most =
        std::max(scaled(look.most) - ImGui::GetCursorPosY() - ImGui::GetStyle().WindowPadding.y,
                 2 * ImGui::GetTextLineHeight());
    bool const scrolls = ImGui::GetStateStorage()->GetFloat(heightId) > most;
    if (scrolls) {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("hint", {0, most});
    }
    float const top = ImGui::GetCursorPosY();
    ImGui::TextWrapped("%s", unbroken(hint).c_str());
    float const drawn = ImGui::GetCursorPosY() - top;
    if (scrolls) {
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    ImGui::GetStateStorage()->SetFloat(heightId, drawn);
    layout.endCard();
    return asked;
}

} // namespace trembler::ui
