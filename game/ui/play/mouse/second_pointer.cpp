#include "game/ui/play/mouse/second_pointer.hpp"

#include <algorithm>

namespace trembler::ui {

void SecondPointer::look(std::optional<render::SecondPad> const& pad, double seconds,
                         render::Camera const& camera, double uiScale) {
    before_ = held_;
    held_ = pad && pad->grabs;
    moving_ = pad && (pad->x != 0 || pad->y != 0);
    if (!pad) {
        active_ = false;
        return;
    }
    if (!active_) {
        active_ = true;
        at_ = {camera.centre.x, camera.centre.y};
    }
    double const way = speed * uiScale / camera.pixelsPerMetre * std::clamp(seconds, 0.0, 0.1);
    at_ += Vec2{pad->x, pad->y} * way;
    render::Point const low = camera.toWorld({0, static_cast<double>(camera.viewport.height)});
    render::Point const high = camera.toWorld({static_cast<double>(camera.viewport.width), 0});
    at_ = {std::clamp(at_.x, low.x, high.x), std::clamp(at_.y, low.y, high.y)};
}

Pointer SecondPointer::pointer(render::Camera const& camera, double uiScale) const {
    Pointer pointer;
    pointer.world = at_;
    pointer.screen = camera.toScreen({at_.x, at_.y});
    pointer.uiScale = uiScale;
    pointer.pixel = uiScale / camera.pixelsPerMetre;
    pointer.pressed = held_ && !before_;
    pointer.released = !held_ && before_;
    pointer.held = held_;
    return pointer;
}

} // namespace trembler::ui
