#include "game/ui/shared/layout.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

namespace trembler::ui {
namespace {

Rect rectOf(ImVec2 low, ImVec2 high) {
    return {{static_cast<double>(low.x), static_cast<double>(low.y)},
            {static_cast<double>(high.x), static_cast<double>(high.y)}};
}

/// How far the content exceeds the window's size, pixels.
double overflowOf(ImGuiWindow const& window) {
    float const right = window.DC.CursorMaxPos.x - window.WorkRect.Max.x;
    float const bottom = window.DC.CursorMaxPos.y - window.WorkRect.Max.y;
    return static_cast<double>(std::max({right, bottom, 0.F}));
}

} // namespace

void Layout::beginFrame() {
    cards_ = std::exchange(nextCards_, {});
    items_ = std::exchange(nextItems_, {});
}

void Layout::beginCard(char const* name, char const* title, render::CardOptions const& options) {
    open_ = name;
    bare_ = options.bare;
    render::beginCard(name, title, options);
}

void Layout::endCard() {
    auto const& window = *ImGui::GetCurrentWindow();
    // ImGui does not know a card's size before it has drawn the card once.
    bool const known =
        window.AutoFitFramesX <= 0 && window.AutoFitFramesY <= 0 && window.HiddenFramesCannotSkipItems == 0;
    if (known) {
        ImVec2 const edge = bare_ ? window.WindowPadding : ImVec2(0, 0); // nothing is drawn there
        ImVec2 const low{window.Pos.x + edge.x, window.Pos.y + edge.y};
        ImVec2 const high{window.Pos.x + window.Size.x - edge.x, window.Pos.y + window.Size.y - edge.y};
        nextCards_.push_back({open_, rectOf(low, high), overflowOf(window)});
    }
    render::endCard();
}

void Layout::item(std::string name) {
    // Parts that are scrolled out of sight are clipped.
    ImDrawList const& list = *ImGui::GetWindowDrawList();
    ImVec2 const from = list.GetClipRectMin();
    ImVec2 const to = list.GetClipRectMax();
    ImVec2 const low{std::max(ImGui::GetItemRectMin().x, from.x),
                     std::max(ImGui::GetItemRectMin().y, from.y)};
    ImVec2 const high{std::min(ImGui::GetItemRectMax().x, to.x), std::min(ImGui::GetItemRectMax().y, to.y)};
    if (low.x < high.x && low.y < high.y) {
        ImVec2 const size = ImGui::GetItemRectSize();
        float const cut = std::max({size.x - (high.x - low.x), size.y - (high.y - low.y), 0.F});
        nextItems_.push_back({std::move(name), rectOf(low, high), static_cast<double>(cut)});
    }
}

std::string_view Layout::cardAt(render::Point point) const {
    for (Placed const& card : cards_) {
        if (card.rect.contains(point)) {
            return card.name;
        }
    }
    return {};
}

std::optional<Rect> Layout::find(std::vector<Placed> const& all, std::string_view name) {
    auto const found = std::find_if(all.begin(), all.end(), [&](Placed const& p) { return p.name == name; });
    return found == all.end() ? std::nullopt : std::optional(found->rect);
}

} // namespace trembler::ui
