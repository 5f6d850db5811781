// The pointer of a second player, with a gamepad or keys of their own: it moves the second hand in a run.
#pragma once

#include "game/ui/shared/pointer.hpp"
#include "render/draw/camera.hpp"
#include "render/window/second_pad.hpp"

#include <optional>

namespace trembler::ui {

/// There while a second player has a gamepad or uses their keys. Window thread only.
class SecondPointer {
public:
    /// Pixels per second at UI scale 1 that it moves while the stick is held all the way.
    static constexpr double speed = 420;

    /// To be called once per picture, `seconds` after the last. `pad`: nothing if there is no second player.
    void look(std::optional<render::SecondPad> const& pad, double seconds, render::Camera const& camera,
              double uiScale);

    [[nodiscard]] bool active() const { return active_; }
    [[nodiscard]] bool moving() const { return moving_; }
    /// m
    [[nodiscard]] Vec2 at() const { return at_; }
    /// As the tools take it: the button that grabs is its button.
    [[nodiscard]] Pointer pointer(render::Camera const& camera, double uiScale) const;

private:
    bool active_ = false;
    bool moving_ = false;
    bool held_ = false;
    bool before_ = false; // held in the last picture
    Vec2 at_;
};

} // namespace trembler::ui
