#include "render/panels/cards.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/icons.hpp"
#include "render/panels/theme.hpp"
#include "render/panels/unbroken.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {

namespace {

using namespace palette;

/// 0, 0.5 or 1 along each axis.
ImVec2 pivotOf(Anchor anchor) {
    auto const index = static_cast<int>(anchor);
    int const column = index % 3;
    int const row = index / 3;
    return {0.5F * static_cast<float>(column), 0.5F * static_cast<float>(row)};
}

/// Towards the window's middle from the corner; none along an axis that is centred.
float inwards(float pivot, float offset) {
    return (pivot < 0.25F ? 1.F : (pivot > 0.75F ? -1.F : 0.F)) * offset;
}

/// Around the content of a bare card, pixels. Half of it lies inside the rectangle at which ImGui clips: room
/// for the half of a button's outline that lies outside the button, and for the part of a pixel that ImGui
/// cuts from a window's size.
float outlineRoom() {
    return 2 * std::ceil(0.5F * scaled(buttonOutline)) + 1;
}

/// A soft shadow under the card, in the layer below all windows.
void shadowUnder(ImVec2 low, ImVec2 high) {
    auto& list = *ImGui::GetBackgroundDrawList();
    float const drop = scaled(3);
    for (int i = 5; i >= 1; --i) {
        float const grow = scaled(1.4F) * static_cast<float>(i);
        list.AddRectFilled({low.x - grow, low.y - grow + drop}, {high.x + grow, high.y + grow + drop},
                           imColour(faded(shadow, 0.16F)), scaled(12) + grow);
    }
}

} // namespace

void beginCard(char const* id, char const* title, CardOptions const& options) {
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    ImVec2 const pivot = pivotOf(options.anchor);
    float const padding = options.bare ? outlineRoom() : 0.F; // outside, so that the content keeps its place
    ImGui::SetNextWindowPos({screen.x * pivot.x + inwards(pivot.x, scaled(options.offset.x) - padding),
                             screen.y * pivot.y + inwards(pivot.y, scaled(options.offset.y) - padding)},
                            ImGuiCond_Always, pivot);
    float const width = options.width > 0 ? scaled(options.width) + 2 * padding : 0.F;
    if (width > 0) {
        ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y});
    }
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                             ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    if (options.bare) {
        flags |= ImGuiWindowFlags_NoBackground;
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding, padding));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.F);
    }
    ImGui::Begin(id, nullptr, flags);
    if (options.bare) {
        ImGui::PopStyleVar(2);
    } else if (!ImGui::IsWindowAppearing()) { // in its first frame the size is not known
        ImVec2 const low = ImGui::GetWindowPos();
        ImVec2 const size = ImGui::GetWindowSize();
        shadowUnder(low, {low.x + size.x, low.y + size.y});
    }
    // Fields leave room for their names on the right; ImGui's own default would run out of a card this
    // narrow.
    ImGui::PushItemWidth(width > 0 ? 0.56F * (width - 2 * ImGui::GetStyle().WindowPadding.x) : scaled(180));
    if (title != nullptr && *title != '\0') {
        ImGui::PushFont(theme().fonts.heading);
        ImGui::TextUnformatted(title);
        ImGui::PopFont();
        ImVec2 const at = ImGui::GetItemRectMin();
        float const y = ImGui::GetItemRectMax().y + scaled(2);
        ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + scaled(36), y + scaled(3)},
                                                  imColour(accent), scaled(1.5F));
        ImGui::Dummy({0, scaled(2)});
    }
}

void endCard() {
    ImGui::PopItemWidth();
    ImGui::End();
}

void goalLines(std::span<GoalLine const> lines) {
    auto& list = *ImGui::GetWindowDrawList();
    float const side = scaled(20);
    for (auto const& line : lines) {
        ImVec2 const at = ImGui::GetCursorScreenPos();
        float const end = at.x + ImGui::GetContentRegionAvail().x; // of the card, or of its column
        float const top = at.y + 0.5F * (ImGui::GetTextLineHeight() - side);
        ImVec2 const low{at.x, top};
        ImVec2 const high{at.x + side, top + side};
        ImVec2 const middle{at.x + 0.5F * side, top + 0.5F * side};
        Colour const mark = line.state == GoalLine::State::Met      ? goal
                            : line.state == GoalLine::State::Failed ? warning
                                                                    : ink;
        bool const open = line.state == GoalLine::State::Open;
        list.AddRectFilled(low, high, imColour(open ? paper : mark), scaled(5));
        list.AddRect(low, high, imColour(mix(ink, mark, 0.4F)), scaled(5), 0, scaled(1.6F));
        if (!open) {
            drawIcon(list, line.state == GoalLine::State::Met ? Icon::Tick : Icon::Cross, middle,
                     0.62F * side, imColour(paperLight));
        }
        ImGui::SetCursorScreenPos({at.x + side + scaled(10), at.y});
        ImGui::PushTextWrapPos(0.F);
        ImGui::PushStyleColor(ImGuiCol_Text, imColour4(line.state == GoalLine::State::Met ? inkSoft : ink));
        ImGui::TextUnformatted(unbroken(line.text).c_str());
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
        if (line.progress >= 0.F) {
            float const y = ImGui::GetItemRectMax().y + scaled(3);
            float const left = at.x + side + scaled(10);
            float const right = std::max(end, left + scaled(60));
            float const share = std::clamp(line.progress, 0.F, 1.F);
            list.AddRectFilled({left, y}, {right, y + scaled(6)}, imColour(paperShade), scaled(3));
            list.AddRectFilled({left, y}, {left + share * (right - left), y + scaled(6)}, imColour(goal),
                               scaled(3));
            ImGui::Dummy({0, scaled(6)});
        }
    }
}

void caption(char const* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(inkSoft));
    ImGui::PushTextWrapPos(0.F);
    ImGui::TextUnformatted(unbroken(text).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void smallCaption(char const* text) {
    ImGui::PushFont(theme().fonts.small);
    caption(text);
    ImGui::PopFont();
}

} // namespace trembler::render
