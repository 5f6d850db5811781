#include "game/ui/shared/focus.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler::ui {

void Focus::beginFrame() {
    if (!shown_) {
        page_.clear();
    }
    shown_ = false;
}

void Focus::begin(std::string_view page, std::span<MenuKeys::Press const> presses, bool mouseMoved) {
    shown_ = true;
    lastAreas_ = std::exchange(areas_, {});
    count_ = 0;
    adjust_ = 0;
    press_ = moved_ = false;
    if (page != page_) {
        page_ = page;
        index_ = 0;
        adjusts_ = false;
        return; // the key that opened this page must not act on it
    }
    for (MenuKeys::Press const& press : presses) {
        take(press);
    }
    visible_ = visible_ && !mouseMoved;
}

void Focus::take(MenuKeys::Press const& press) {
    switch (press.key) {
    case MenuKey::down:
        return moveTowards(0, 1);
    case MenuKey::up:
        return moveTowards(0, -1);
    case MenuKey::next:
        return move(1);
    case MenuKey::before:
        return move(-1);
    case MenuKey::left:
    case MenuKey::right: {
        int const way = press.key == MenuKey::left ? -1 : 1;
        if (visible_ && adjusts_) {
            adjust_ = way;
        } else {
            moveTowards(way, 0);
        }
        return;
    }
    case MenuKey::press:
        press_ = press_ || (visible_ && !press.repeat);
        return;
    default:
        return;
    }
}

void Focus::move(int by) {
    if (auto const count = static_cast<int>(lastAreas_.size()); visible_ && count > 0) {
        index_ = (index_ + by + count) % count;
    }
    visible_ = moved_ = true;
}

int Focus::nearest(int x, int y, bool within) const {
    Area const& here = lastAreas_[static_cast<std::size_t>(index_)];
    auto const dx = static_cast<float>(x);
    auto const dy = static_cast<float>(y);
    // How far an interval lies from another one; 0 if they overlap.
    auto const gap = [](float low, float high, float otherLow, float otherHigh) {
        return std::max({otherLow - high, low - otherHigh, 0.F});
    };
    int best = -1;
    float least = 0;
    for (int i = 0; i < static_cast<int>(lastAreas_.size()); ++i) {
        Area const& there = lastAreas_[static_cast<std::size_t>(i)];
        // Items that a list has scrolled out of sight lie behind items elsewhere.
        if (there.list != here.list && (within || !there.seen)) {
            continue;
        }
        float const ahead = dx * (there.low.x + there.high.x - here.low.x - here.high.x) / 2 +
                            dy * (there.low.y + there.high.y - here.low.y - here.high.y) / 2;
        float const across = x != 0 ? gap(here.low.y, here.high.y, there.low.y, there.high.y)
                                    : gap(here.low.x, here.high.x, there.low.x, there.high.x);
        // Sideways only within the same row; up and down also to items beside the column.
        if (i == index_ || ahead <= 1 || (x != 0 && across > 0)) {
            continue;
        }
        float const centre = x != 0 ? 0 : std::abs(there.low.x - here.low.x);
        float const cost = ahead + 3 * across + 0.01F * centre;
        if (best < 0 || cost < least) {
            best = i;
            least = cost;
        }
    }
    return best;
}

void Focus::moveTowards(int x, int y) {
    if (!visible_ || index_ >= static_cast<int>(lastAreas_.size())) {
        return move(0);
    }
    int best = -1;
    if (y != 0 && lastAreas_[static_cast<std::size_t>(index_)].scrolls) {
        best = nearest(x, y, true);
    }
    if (best < 0) {
        best = nearest(x, y, false);
    }
    if (best < 0) {
        return move(x + y);
    }
    index_ = best;
    moved_ = true;
}

bool Focus::item(bool adjusts) {
    ++count_;
    areas_.push_back({ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), ImGui::GetWindowDrawList(),
                      ImGui::GetScrollMaxY() > 0, ImGui::IsItemVisible()});
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
