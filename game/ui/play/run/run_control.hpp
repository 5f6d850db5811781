// Controls a level's run: its begin and end, its speed, and the calls around each frame.
#pragma once

#include "game/budget/budget_mode.hpp"
#include "game/ui/play/run/level_audio.hpp"
#include "game/ui/play/run/speed.hpp"
#include "game/ui/shared/camera_control.hpp"
#include "game/ui/tools/hand_tool.hpp"
#include "game/ui/tools/placing_tool.hpp"
#include "puzzle/run/slow_frame.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace trembler::ui {

/// Functions that are called when the run changes; none may be empty.
struct RunEvents {
    std::function<void()> newWorld;   ///< the session has another world
    std::function<void()> beforeStep; ///< directly before each Session::step
    std::function<void()> afterStep;
    std::function<void()> stopping;             ///< the run is about to end
    std::function<void()> stopped;              ///< the run has ended; directly before newWorld
    std::function<void(SlowFrame const&)> slow; ///< a frame took long; after afterStep
};

/// Needs no window. Window thread only.
class RunControl {
public:
    /// All must outlive this. The listener is where `view` looks.
    RunControl(Session& session, PlacingTool& placing, HandTool& hand, budget::BudgetMode& budget,
               LevelAudio& audio, CameraControl const& view, RunEvents events);

    /// To be called when a picture begins. `fastHeld`: the key for fast motion is down.
    void beginPicture(bool fastHeld);
    /// Lets the world move on, if it runs: by `seconds` of the player's time, or by a single frame with
    /// `oneFrame` (a film has every frame once, however long a picture takes).
    void advance(double seconds, bool oneFrame);

    /// Begins a run, or ends it.
    void runOrStop();
    /// Pauses, or goes on; does nothing while building.
    void pauseOrGo();
    /// Computes one frame and pauses; begins a run if none goes on.
    void step();
    /// Ends the run: the world is again as it was placed.
    void stop();
    /// Begins the last run again and repeats the player's inputs in it, with the detail levels and periods
    /// that it had.
    void watchAgain();
    /// Begins the last run again with the player's inputs, computes it up to that frame, without sound and as
    /// fast as it can in several pictures, and lets it run on from there as the player's own.
    void beginAgain(Playback done, std::uint64_t frame);
    /// From here on a run that is watched again is the player's own.
    void takeOver();
    /// Measures frames with another timer than the usual one.
    void measureWith(FrameTimer timer) { timer_ = std::move(timer); }

    [[nodiscard]] bool building() const { return session_.mode() == SessionMode::building; }
    [[nodiscard]] bool running() const { return session_.mode() == SessionMode::running; }
    [[nodiscard]] bool paused() const { return session_.mode() == SessionMode::paused; }
    /// Whether a run is being watched again.
    [[nodiscard]] bool watching() const { return session_.playing(); }
    /// How fast it goes. The player's choice lasts until another level is opened.
    [[nodiscard]] Speed& speed() { return speed_; }
    [[nodiscard]] Speed const& speed() const { return speed_; }
    /// Whether the world moved on in this picture.
    [[nodiscard]] bool stepped() const { return stepped_; }
    /// How far the display is between the last two frames, 0 to 1.
    [[nodiscard]] double alpha() const { return running() && !oneFrame_ ? speed_.alpha() : 1; }

private:
    void begin(bool asBefore);
    void stepOnce(bool heard = true);
    void catchUp();

    Session& session_;
    PlacingTool& placing_;
    HandTool& hand_;
    budget::BudgetMode& budget_;
    LevelAudio& audio_;
    CameraControl const& view_;
    RunEvents events_;
    Subscription patches_; // of the running world
    Speed speed_;
    FrameTimer timer_;
    bool oneFrame_ = false;
    bool stepped_ = false;
    std::optional<std::uint64_t> target_; // up to which the run is computed again
};

} // namespace trembler::ui
