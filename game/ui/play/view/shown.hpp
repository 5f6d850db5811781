// The overlays that the player has switched on.
#pragma once

#include "render/scene/scene_view.hpp"

namespace trembler::ui {

/// Plain data.
struct Shown {
    bool electricity = false; ///< the electricity graph
    bool magnetism = false;   ///< forces and field lines
    bool contacts = false;    ///< where objects touch
    bool names = false;       ///< of all objects

    [[nodiscard]] render::Overlays overlays() const {
        return {
            .electricity = electricity, .forces = magnetism, .fieldLines = magnetism, .contacts = contacts};
    }
};

} // namespace trembler::ui
