// A second run beside the real one, in which something is changed at a moment of the run.
#pragma once

#include "game/ui/play/timeline/timeline.hpp"
#include "game/ui/play/whatif/picture_pace.hpp"
#include "insight/whatif/other_run.hpp"
#include "insight/whatif/settable.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trembler::ui {

/// The other run never counts: it is no run of the session, which it never changes. When it ends, the real
/// one is as it was. Needs no window; window thread only.
class WhatIfView {
public:
    static constexpr std::size_t mostKept = 4; ///< what-ifs of this run that can be shown again

    /// All must outlive this. `registry` is the session's. `clock` returns seconds; it decides only how much
    /// is computed in which picture. Empty: the computer's clock.
    WhatIfView(Registry const& registry, Session const& session, Timeline& timeline,
               std::function<double()> clock = {});

    [[nodiscard]] bool active() const { return active_; }
    /// Begins a what-if at the moment that the timeline shows, without any change so far. False if the run
    /// cannot be repeated: a script was changed while it ran.
    bool begin();
    /// Ends it: only the real run is shown. Its changes are kept.
    void end();
    /// Shows one of kept() again.
    void again(std::size_t kept);
    /// The runs that have ended, the latest last; without the runs in which nothing was changed.
    [[nodiscard]] std::vector<insight::WhatIf> const& kept() const { return kept_; }
    /// The session's run has ended, or begins again.
    void forget();

    // Changes, all at the moment.
    [[nodiscard]] std::uint64_t moment() const { return whatIf_.frame; }
    [[nodiscard]] insight::WhatIf const& whatIf() const { return whatIf_; }
    /// Whether the moment is shown, so that something can be changed; or the nearest that is still recorded.
    [[nodiscard]] bool atMoment() const {
        return active_ && timeline_.frame() == timeline_.recording().nearest(whatIf_.frame);
    }
    /// Lets the timeline show the moment.
    void toMoment();
    void change(insight::Change change);
    /// Leaves out these of the session's inputs.
    void leaveOut(std::vector<std::size_t> const& inputs);
    /// Takes a change back, by its place in the list; an input that is left out with all others of them.
    void takeBack(std::size_t index);
    /// The fields of an object that can be set, as they are at the moment in the other run.
    [[nodiscard]] std::vector<insight::SettableField> fieldsOf(std::string const& object);

    /// Once per picture: computes on, for a few milliseconds at most, or builds one world: the real run once
    /// more, the other run, and the stage that shows it. While changes come in every picture, it waits.
    void pass();
    /// Whether the next picture may show something new without any input.
    [[nodiscard]] bool moving() const { return moving_; }
    /// Whether the other run, with all changes, has not been computed yet as far as the real one.
    [[nodiscard]] bool working() const { return active_ && working_; }
    /// How many of the worlds of the changed run, of worldsToBuild, are built.
    [[nodiscard]] int worldsBuilt() const { return wanted_ ? 0 : worldsBuilt_; }
    static constexpr int worldsToBuild = insight::OtherRun::worlds + 1;
    /// How far it has been computed, 0 to 1.
    [[nodiscard]] double progress() const;
    /// Computes no further until goOn(), or another change; its frames so far can still be seen.
    void stop() { stopped_ = working(); }
    void goOn() { stopped_ = false; }
    /// Whether it is not computed further although there is more.
    [[nodiscard]] bool stopped() const { return working() && stopped_; }
    /// The other run as far as it is known; nullptr: there is none yet.
    [[nodiscard]] insight::OtherRun const* run() const { return shown_.get(); }
    /// It in the frame that the timeline shows; nullptr before the moment and where it is not computed.
    [[nodiscard]] World const* world();
    /// The goals in that frame; empty where world() is nullptr.
    [[nodiscard]] std::vector<GoalStatus> const& goals() const;
    /// Why it could not be computed, in words for the player, once.
    [[nodiscard]] std::optional<std::string> takeTrouble() { return std::exchange(trouble_, {}); }

private:
    /// With the next picture in which nothing is changed.
    void compute();
    void computeOn();
    /// Builds one world of the next run; false if all are built.
    bool buildOn();
    void drop();
    [[nodiscard]] std::unique_ptr<insight::Stage> newStage() const;

    Registry const& registry_;
    Session const& session_;
    Timeline& timeline_;
    bool active_ = false;
    bool moving_ = false;
    bool working_ = false;
    bool stopped_ = false;
    bool wanted_ = false; // the runs are to begin again
    bool fresh_ = false;  // something was changed since the last picture
    insight::WhatIf whatIf_;
    std::vector<insight::WhatIf> kept_;
    std::unique_ptr<insight::OtherRun> shown_;
    std::unique_ptr<insight::OtherRun> next_; // after a change, until it has come to the moment
    std::unique_ptr<insight::Stage> stage_;
    std::unique_ptr<insight::Stage> nextStage_; // of next_
    int worldsBuilt_ = 0;
    std::optional<std::uint64_t> staged_; // the frame on the stage
    std::optional<std::string> trouble_;
    std::function<double()> clock_;
    PicturePace pace_;
};

} // namespace trembler::ui
