#include "game/ui/shared/focus.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {

void Focus::beginFrame() {
    if (!shown_) {
        page_.clear();
    }
    shown_ = false;
}

void Focus::begin(std::string_view page, std::span<SDL_Event const> events, bool mouseMoved) {
    shown_ = true;
    lastCount_ = count_;
    count_ = 0;
    adjust_ = 0;
    press_ = moved_ = false;
    if (page != page_) {
        page_ = page;
        index_ = 0;
        adjusts_ = false;
        return; // the key that opened this page must not act on it
    }
    for (SDL_Event const& event : events) {
        if (event.type == SDL_KEYDOWN) {
            take(event.key);
        }
    }
    visible_ = visible_ && !mouseMoved;
}

void Focus::take(SDL_KeyboardEvent const& event) {
    switch (event.keysym.sym) {
    case SDLK_DOWN:
        return move(1);
    case SDLK_UP:
        return move(-1);
    case SDLK_TAB:
        return move((event.keysym.mod & KMOD_SHIFT) != 0 ? -1 : 1);
    case SDLK_LEFT:
    case SDLK_RIGHT: {
        int const by = event.keysym.sym == SDLK_LEFT ? -1 : 1;
        if (visible_ && adjusts_) {
            adjust_ = by;
        } else {
            move(by);
        }
        return;
    }
    case SDLK_RETURN:
    case SDLK_KP_ENTER:
    case SDLK_SPACE:
        press_ = press_ || (visible_ && event.repeat == 0);
        return;
    default:
        return;
    }
}

void Focus::move(int by) {
    if (visible_ && lastCount_ > 0) {
        index_ = (index_ + by + lastCount_) % lastCount_;
    }
    visible_ = moved_ = true;
}

bool Focus::item(bool adjusts) {
    ++count_;
    if (!here()) {
        return false;
    }
    adjusts_ = adjusts;
    // Around the item, clipped to the visible part of its list.
    float const gap = render::scaled(3);
    float const line = render::scaled(2.4F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float const left = list.GetClipRectMin().x + line;
    float const right = list.GetClipRectMax().x - line;
    ImVec2 const low = ImGui::GetItemRectMin();
    ImVec2 const high = ImGui::GetItemRectMax();
    list.AddRect({std::max(low.x - gap, left), low.y - gap}, {std::min(high.x + gap, right), high.y + gap},
                 render::imColour(render::palette::accent), render::scaled(10), 0, line);
    if (moved_ && ImGui::GetScrollMaxY() > 0) {
        ImGui::SetScrollHereY();
    }
    return press_;
}

} // namespace trembler::ui
