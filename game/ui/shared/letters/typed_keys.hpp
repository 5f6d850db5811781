// The keys of a real keyboard that the one on the screen presses for the widgets.
#pragma once

#include "render/window/input_events.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// A key that goes down in one picture comes up in another, as ImGui reads a key once per picture. Window
/// thread only.
class TypedKeys {
public:
    /// Before everything else of a picture: lets the keys come up that are to.
    void beginPicture(render::InputEvents& input);
    void type(std::string const& text, render::InputEvents& input);
    /// Until the button is let go; `pad` 0: until the next picture.
    void hold(SDL_Keycode key, SDL_Keycode pad, render::InputEvents& input);
    /// The button was let go.
    void release(SDL_Keycode pad);
    /// After all events of a picture: lets the keys come up whose button was let go.
    void letGo(render::InputEvents& input);
    /// All keys come up in the next picture.
    void letAllGo();
    [[nodiscard]] bool any() const { return !held_.empty() || !due_.empty(); }

private:
    struct Held {
        SDL_Keycode key;
        SDL_Keycode pad; ///< 0: let go in the next picture
        bool fresh;      ///< went down in this picture, in which it must not come up again
    };

    std::vector<Held> held_;
    std::vector<SDL_Keycode> due_; // keys that come up in the next picture
};

} // namespace trembler::ui
