// The run that has been computed so far, to be looked at again: any moment of it, back and forth.
#pragma once

#include "audio/effect/hearing/rings.hpp"
#include "insight/timeline/again.hpp"
#include "insight/timeline/marks.hpp"
#include "insight/timeline/recording.hpp"
#include "insight/timeline/stage.hpp"
#include "render/scene/overlays/overlay_sound.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trembler::ui {

class ProbePanel;

/// Records the session's run while it goes on. While it looks back, world() is the past and the session
/// stands still. Never changes the session. Needs no window; window thread only.
class Timeline {
public:
    /// All must outlive this. `registry` is the session's.
    Timeline(Registry const& registry, Session const& session);

    // The run.
    /// Directly before each Session::step.
    void beforeStep();
    /// Directly after it.
    void afterStep();
    /// The run has ended.
    void stopped();
    /// The run begins again and is computed up to the shown frame, which stays in sight until then; later
    /// frames are forgotten.
    void beginAgain();
    /// Whether the run is being computed again.
    [[nodiscard]] bool beginningAgain() const { return target_.has_value(); }

    // The bar.
    [[nodiscard]] bool open() const { return open_; }
    void setOpen(bool open);
    /// Whether the bar is on the screen: it is open, and there is a run.
    [[nodiscard]] bool shown() const { return open_ && recording_.begun(); }

    /// Height of the bar and of the plots above it, if they are open, pixels at UI scale 1.
    [[nodiscard]] float height() const;
    /// Height of the drawing between the bar and the plots, pixels at UI scale 1; 0: none.
    void setLane(float height) { lane_ = height; }
    [[nodiscard]] float lane() const { return lane_; }
    /// The numbers that are plotted above the bar.
    [[nodiscard]] ProbePanel& probes() const { return *probes_; }

    // Looking.
    [[nodiscard]] bool looksBack() const { return at_.has_value(); }
    /// The shown frame: of the past, or the session's.
    [[nodiscard]] std::uint64_t frame() const { return at_ ? *at_ : session_.world().frame(); }
    [[nodiscard]] std::uint64_t last() const { return recording_.begun() ? recording_.last() : 0; }
    /// The world that is shown. Valid until the next call that changes anything.
    [[nodiscard]] World const& world() const { return at_ ? stage_.world() : session_.world(); }
    /// The goals as they were; of the session while it does not look back.
    [[nodiscard]] std::vector<GoalStatus> const& goals() const {
        return at_ ? stage_.goals() : session_.judge().status();
    }
    /// The rings of the sounds in the frames before the shown one.
    [[nodiscard]] std::vector<render::Ripple> ripples() const;
    /// Shows the recorded frame nearest to this one; from the last one on, the present.
    void seek(std::uint64_t frame);
    /// By that many recorded frames, forwards or backwards.
    void stepBy(int frames);
    /// To the next or the last mark before the shown frame; false if there is none.
    bool seekMark(bool forwards);

    // Playing the recording.
    [[nodiscard]] bool playing() const { return playing_; }
    /// Whether the next picture shows something new without any input.
    [[nodiscard]] bool moving() const { return playing_ || reading_ || target_.has_value(); }
    /// Plays on from the shown frame, or, if it is the last one, from the beginning; or stops playing.
    void playOrPause();
    /// `seconds` of the player's time pass, at this speed.
    void pass(double seconds, double speed);
    /// A section that is repeated while it plays; first and last frame.
    [[nodiscard]] std::optional<std::pair<std::uint64_t, std::uint64_t>> loop() const { return loop_; }
    /// Begins a section at the shown frame, ends it there, or, if there is one, forgets it.
    void markLoop();

    [[nodiscard]] insight::Marks const& marks() const { return marks_; }
    [[nodiscard]] insight::Recording const& recording() const { return recording_; }
    /// Why the last seek() failed, in words for the player, once.
    [[nodiscard]] std::optional<std::string> takeTrouble() { return std::exchange(trouble_, {}); }

private:
    void show(std::uint64_t frame);
    void hear(std::uint64_t frame);

    Session const& session_;
    insight::Recording recording_;
    insight::Stage stage_;
    insight::Marks marks_;
    bool open_ = false;
    float lane_ = 0;
    std::optional<std::uint64_t> at_;     // the shown frame of the past
    std::optional<std::uint64_t> target_; // up to which the run is computed again
    bool spared_ = false;                 // the run ends only to begin again
    bool playing_ = false;
    bool reading_ = false; // for the plots
    double due_ = 0;       // frames
    std::optional<std::pair<std::uint64_t, std::uint64_t>> loop_;
    bool loopEnds_ = false; // its end has been stated
    SoundRings rings_;
    std::optional<std::uint64_t> heard_; // the frame up to which rings_ has heard
    std::optional<std::string> trouble_;
    std::shared_ptr<ProbePanel> probes_; // never null
};

} // namespace trembler::ui
