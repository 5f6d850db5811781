// Plays the sounds of the level on the screen.
#pragma once

#include "game/ui/shared/frame_clock.hpp"
#include "render/draw/camera.hpp"

namespace trembler {
class Loudspeaker;
class World;
} // namespace trembler

namespace trembler::ui {

/// Follows one level. Without a loudspeaker it does nothing. It never changes the world. Window thread only;
/// the loudspeaker must outlive it.
class LevelAudio {
public:
    explicit LevelAudio(Loudspeaker* loudspeaker) : loudspeaker_(loudspeaker) {}

    /// A run begins.
    void enter(World const& world);
    /// The run ends: silence, at once.
    void leave();
    /// To be called after every step of the world that is to be heard. The listener is where the camera
    /// looks.
    void frame(World const& world, render::Camera const& camera);
    /// To be called in a picture in which the world stands still, `seconds` after the last: sounds die away.
    void pause(double seconds, render::Camera const& camera);

private:
    Loudspeaker* loudspeaker_;
    FrameClock clock_; // of the pauses
};

} // namespace trembler::ui
