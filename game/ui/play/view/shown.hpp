// What the player wants to see of a world besides the things themselves.
#pragma once

#include "render/scene/scene_view.hpp"

namespace trembler::ui {

/// Plain data.
struct Shown {
    bool electricity = false; ///< the graph
    bool magnetism = false;   ///< forces and field lines
    bool contacts = false;
    bool names = false;

    [[nodiscard]] render::Overlays overlays() const {
        return {
            .electricity = electricity, .forces = magnetism, .fieldLines = magnetism, .contacts = contacts};
    }
};

} // namespace trembler::ui
