// Brings a window that was maximised back as that from the whole screen.
#pragma once

namespace trembler::render {

struct WindowState {
    bool fullscreen = false;
    bool maximised = false;
};

/// Some window managers forget that a window was maximised while it fills the screen, and SDL only knows the
/// size from before; others answer late, when the window has been seen small already. So for a few pictures
/// after the whole screen the window is maximised whenever it is not. Plain data.
class Maximising {
public:
    /// The window is about to fill the screen (`on`), or to leave it; `now` is how it is until then.
    void switches(bool on, WindowState now) {
        if (on && !now.fullscreen) {
            before_ = now.maximised || left_ > 0;
            left_ = 0;
        } else if (!on && now.fullscreen) {
            left_ = before_ ? patience : 0;
        }
    }
    /// Once per picture: whether the window is to be maximised now.
    [[nodiscard]] bool due(WindowState now) {
        if (left_ == 0) {
            return false;
        }
        --left_;
        return !now.fullscreen && !now.maximised;
    }

private:
    static constexpr int patience = 20; // pictures, a third of a second

    bool before_ = false; // it was maximised before it filled the screen
    int left_ = 0;        // pictures in which it may be maximised
};

} // namespace trembler::render
