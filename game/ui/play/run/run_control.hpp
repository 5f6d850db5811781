// A level's run: when it begins and ends, how fast it goes, and what happens around each of its frames.
#pragma once

#include "game/budget/budget_mode.hpp"
#include "game/ui/play/run/level_audio.hpp"
#include "game/ui/shared/frame_clock.hpp"
#include "game/ui/tools/camera_control.hpp"
#include "game/ui/tools/hand_tool.hpp"
#include "game/ui/tools/placing_tool.hpp"

#include <functional>

namespace trembler::ui {

/// What others do when the run does something; none may be empty.
struct RunEvents {
    std::function<void()> newWorld;   ///< the session's world is another one
    std::function<void()> beforeStep; ///< directly before each Session::step
    std::function<void()> afterStep;
    std::function<void()> stopped; ///< directly before newWorld
};

/// Needs no window. Window thread only.
class RunControl {
public:
    /// All must outlive this. It is heard from where `view` looks.
    RunControl(Session& session, PlacingTool& placing, HandTool& hand, budget::BudgetMode& budget,
               LevelAudio& audio, CameraControl const& view, RunEvents events);

    /// A picture begins. `fastHeld`: the key for it is down.
    void beginPicture(bool fastHeld);
    /// Lets the world move on, if it runs: by `seconds` of the player's time, or by a single frame with
    /// `oneFrame` (a film has every frame once, however long a picture takes).
    void advance(double seconds, bool oneFrame);

    void runOrStop();
    /// Pauses or goes on; nothing while building.
    void pauseOrGo();
    /// One frame, and stands still after it; begins the run if need be.
    void step();
    void stop();
    void switchFast() { fast_ = !fast_; }
    /// The last run from its beginning, with what was done in it, at the levels and periods that it had.
    void watchAgain();

    [[nodiscard]] bool building() const { return session_.mode() == SessionMode::building; }
    [[nodiscard]] bool running() const { return session_.mode() == SessionMode::running; }
    [[nodiscard]] bool paused() const { return session_.mode() == SessionMode::paused; }
    /// A run is being watched again.
    [[nodiscard]] bool watching() const { return session_.playing(); }
    /// By its switch.
    [[nodiscard]] bool fast() const { return fast_; }
    /// The world moved on in this picture.
    [[nodiscard]] bool stepped() const { return stepped_; }
    /// How far the display is between the last two frames, 0 to 1.
    [[nodiscard]] double alpha() const { return running() && !oneFrame_ ? clock_.alpha() : 1; }

private:
    void begin(bool asBefore);
    void stepOnce();
    [[nodiscard]] bool quick() const { return fast_ || fastHeld_; }

    Session& session_;
    PlacingTool& placing_;
    HandTool& hand_;
    budget::BudgetMode& budget_;
    LevelAudio& audio_;
    CameraControl const& view_;
    RunEvents events_;
    Subscription patches_; // of the running world
    FrameClock clock_;
    bool fast_ = false;
    bool fastHeld_ = false;
    bool oneFrame_ = false;
    bool stepped_ = false;
};

} // namespace trembler::ui
