// Who has the keys of a picture: a widget that is in use, or the screen's commands.
#pragma once

namespace trembler::ui {

/// One rule for all widgets: an open list, menu or other popup, a text or a number that is being typed, and a
/// widget that is held have all keys, so that none of them runs a command on what lies behind. Window thread
/// only.
class KeysOwner {
public:
    /// Call once per picture, after the panels were drawn, and ask it before a command runs by a key. A
    /// widget that gave the keys back in this picture, as a list does that Enter closed, still has them.
    /// `carrying`: a part follows the mouse out of the catalogue, whose tile is held; the keys are the
    /// scene's.
    void look(bool carrying);
    [[nodiscard]] bool widgets() const { return now_ || before_; }
    /// Whether a popup is open.
    [[nodiscard]] static bool popup();

private:
    bool now_ = false;
    bool before_ = false;
};

} // namespace trembler::ui
