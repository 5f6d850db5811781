// The rings that show where a level's sounds come from.
#pragma once

#include "audio/effect/hearing/rings.hpp"
#include "render/scene/overlays/overlay_sound.hpp"
#include "runtime/world/world.hpp"

#include <vector>

namespace trembler::ui {

/// Follows one world at a time. While it does, the world's sounds are computed, so that they can be drawn and
/// inspected; that changes no state of the world. Needs no window. Between frames only, by one thread.
class SoundView {
public:
    /// To be called directly before each World::step. Begins without rings in every new world.
    void beforeStep(World const& world);
    /// To be called directly after it.
    void afterStep(World const& world);
    /// The rings as they are now; none once the world no longer exists.
    [[nodiscard]] std::vector<render::Ripple> ripples() const;

private:
    Subscription sounds_;
    SoundRings rings_;
};

} // namespace trembler::ui
