// Navigation on a page of buttons without a mouse: arrow keys or the directional pad of a gamepad move a ring
// from item to item, Enter or its lower button presses, unless the player has chosen other keys.
#pragma once

#include "game/ui/shared/commands/menu_keys.hpp"

#include <imgui.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {

/// For pages that cover the screen, where keys have no other meaning. The ring is shown from the first arrow
/// key until the mouse moves. Arrows go to the nearest item in their direction, at the end of a column or row
/// on to the next, and Tab goes through all items in order. Window thread only.
class Focus {
public:
    /// Call once in every picture, even if no page is shown: a page that was not drawn in the last picture
    /// starts again at its first item.
    void beginFrame();
    /// Call once per picture, before the first item of a page. The ring of a new page begins at its first
    /// item. `presses` may be empty while keys have another meaning.
    void begin(std::string_view page, std::span<MenuKeys::Press const> presses, bool mouseMoved);
    /// Call directly after an ImGui item that can be pressed. Returns true if Enter or Space presses it. With
    /// `adjusts` the left and right arrows change its value instead of moving the ring.
    bool item(bool adjusts = false);
    /// Whether the ring is around the last item.
    [[nodiscard]] bool here() const { return visible_ && count_ == index_ + 1; }
    /// Whether a key of this picture presses the item at the ring.
    [[nodiscard]] bool pressed() const { return shown_ && press_; }
    /// By how many steps the last item is to be changed: -1, 0 or 1.
    [[nodiscard]] int adjusted() const { return here() ? adjust_ : 0; }

private:
    struct Area {
        ImVec2 low;
        ImVec2 high;
        void const* list; ///< identifies the window, or the scrolled part of one, that has the item
        bool scrolls;     ///< that list shows only some of its items
        bool seen;        ///< this one among them
    };
    /// To the next or the previous item in their order.
    void move(int by);
    /// To the nearest item in a direction (one of both is 0, y down), else as move(). Up and down pass
    /// through a whole scrolled list before they leave it.
    void moveTowards(int x, int y);
    /// The nearest one, or -1. `within`: of the list of the present item only.
    [[nodiscard]] int nearest(int x, int y, bool within) const;
    void take(MenuKeys::Press const& press);

    std::string page_;
    int index_ = 0;
    int count_ = 0;               // items of this picture so far
    std::vector<Area> areas_;     // of the items of this picture so far
    std::vector<Area> lastAreas_; // of the last picture
    int adjust_ = 0;
    bool adjusts_ = false; // the item at the ring uses the left and right arrows
    bool press_ = false;
    bool moved_ = false;
    bool shown_ = false; // a page was drawn in this picture
    bool visible_ = false;
};

} // namespace trembler::ui
