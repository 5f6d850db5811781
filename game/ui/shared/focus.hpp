// The keyboard's way through a page of buttons: arrows move a ring from item to item, Enter presses.
#pragma once

#include <SDL_events.h>

#include <span>
#include <string>
#include <string_view>

namespace trembler::ui {

/// For pages that lie over everything, where keys have no other meaning. The ring is shown from the first
/// arrow key on until the mouse moves. Window thread only.
class Focus {
public:
    /// Once per picture, whatever is shown in it: a page that was not there in the last one begins again.
    void beginFrame();
    /// Once per picture, before the first item of a page. A page's ring begins at its first item. `events`
    /// may be empty where keys mean something else at the moment.
    void begin(std::string_view page, std::span<SDL_Event const> events, bool mouseMoved);
    /// Directly after an ImGui item that can be pressed. True if Enter, or Space, presses it. With `adjusts`
    /// the left and right arrows change it instead of leading to its neighbours.
    bool item(bool adjusts = false);
    /// Whether the ring is around the item that was named last.
    [[nodiscard]] bool here() const { return visible_ && count_ == index_ + 1; }
    /// By how many steps the last item is to be changed: -1, 0 or 1.
    [[nodiscard]] int adjusted() const { return here() ? adjust_ : 0; }

private:
    void move(int by);
    void take(SDL_KeyboardEvent const& event);

    std::string page_;
    int index_ = 0;
    int count_ = 0;     // items of this picture so far
    int lastCount_ = 0; // items of the last picture
    int adjust_ = 0;
    bool adjusts_ = false; // the item at the ring takes left and right
    bool press_ = false;
    bool moved_ = false;
    bool shown_ = false; // a page, in this picture
    bool visible_ = false;
};

} // namespace trembler::ui
