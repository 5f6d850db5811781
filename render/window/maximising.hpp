// Maximises a window again that was maximised before it filled the screen.
#pragma once

namespace trembler::render {

struct WindowState {
    bool fullscreen = false;
    bool maximised = false;
};

/// Some window managers forget that a window was maximised while it fills the screen, and SDL only knows the
/// size from before; others restore it late, after the window was small for a moment. So for one second after
/// the whole screen the window is maximised whenever it is not. This is measured in time, not in pictures:
/// while nothing changes none is drawn, and a window that the player makes smaller later must stay so. Plain
/// data.
class Maximising {
public:
    /// The window is about to fill the screen (`on`), or to leave it; `now` is how it is until then.
    /// `seconds` on any clock.
    void switches(bool on, WindowState now, double seconds) {
        if (on && !now.fullscreen) {
            before_ = now.maximised || seconds < until_;
            until_ = -1;
        } else if (!on && now.fullscreen) {
            until_ = before_ ? seconds + patience : -1;
        }
    }
    /// With every picture: whether the window is to be maximised now.
    [[nodiscard]] bool due(WindowState now, double seconds) const {
        return seconds < until_ && !now.fullscreen && !now.maximised;
    }

private:
    static constexpr double patience = 1; // s

    bool before_ = false; // it was maximised before it filled the screen
    double until_ = -1;   // it may be maximised until then
};

} // namespace trembler::render
