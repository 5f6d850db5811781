// One player at one level: placing parts, running the world, taking everything back.
#pragma once

#include "puzzle/session/lasting_object.hpp"
#include "puzzle/session/placements.hpp"
#include "puzzle/session/playback.hpp"
#include "puzzle/session/run.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

enum class SessionMode : std::uint8_t {
    building, ///< parts can be placed; the world stands at frame 0
    running,
    paused,
};

/// Headless: the window, the command line and the tests all play through it. It consists of the placements
/// (Placements), a run (LevelRun) that is built from the level and the placements whenever these change, and
/// what is fed to the run (Playback). So stop() puts everything back exactly as it was placed. Not
/// thread-safe.
class Session {
public:
    /// `registry` and `parts` must outlive the session. Throws InputError if the level cannot be built.
    Session(Registry const& registry, PartLibrary const& parts, LevelFile level, WorldOptions options = {});
    Session(Session const&) = delete;
    Session& operator=(Session const&) = delete;

    [[nodiscard]] LevelFile const& level() const { return level_; }
    [[nodiscard]] PartLibrary const& parts() const { return parts_; }
    [[nodiscard]] SessionMode mode() const;
    /// The world as it is now; while building, as it will start. Valid until the next call that changes
    /// anything. To be looked at, and subscribed to (World::want()). What changes it goes through feed() and
    /// change(), which record it.
    [[nodiscard]] World const& world() const { return run_->world(); }

    // Building. All of these do nothing, and say so, unless mode() is building.
    [[nodiscard]] std::vector<PlacedPart> const& placed() const { return placements_.now(); }
    [[nodiscard]] std::vector<ToolboxSlot> toolbox() const { return placements_.toolbox(); }
    /// The object in world() that a placed part became, or an invalid id.
    [[nodiscard]] ObjectId objectOf(int number) const;
    /// The placed part that an object in world() came from.
    [[nodiscard]] std::optional<int> numberOf(ObjectId object) const;
    /// What names an object of world() in all worlds of this session; a default one for an invalid id.
    [[nodiscard]] LastingObject lasting(ObjectId object) const;
    /// The object in world() that is meant; an invalid id if that was put back or is not there (any more).
    [[nodiscard]] ObjectId find(LastingObject const& object) const;
    /// Whether a part may stand there, `ignoring` one that is being moved.
    [[nodiscard]] Verdict check(Placement const& placement, std::optional<int> ignoring = {}) const;
    /// Takes a part out of the toolbox; returns its number, or nothing if check() objects.
    std::optional<int> place(Placement const& placement);
    /// Moves or turns a placed part. False if check() objects; it then stays where it was.
    bool move(int number, Vec2 at, double angle);
    /// Puts a placed part back into the toolbox.
    bool putBack(int number);
    bool putAllBack();
    bool undo();
    bool redo();
    [[nodiscard]] bool canUndo() const { return building() && placements_.canUndo(); }
    [[nodiscard]] bool canRedo() const { return building() && placements_.canRedo(); }

    // Running.
    void start();
    void pause();
    void resume();
    /// Ends the run: everything is back as it was placed.
    void stop();
    /// One frame, to which what a loaded solution, or play(), has for it is fed first. Starts the run if it
    /// has not begun.
    void step();
    /// Passes on what the player does to the running world, and remembers it.
    void feed(PlayerInput const& input);
    /// All inputs of this run, with the frames that see them.
    [[nodiscard]] std::span<RecordedInput const> inputs() const { return run_->inputs(); }
    /// Changes how exactly the running world is computed from its next frame on, and remembers it with that
    /// frame; later runs know nothing of it. Does nothing while building. Throws std::invalid_argument, see
    /// change_fault.hpp.
    void change(RecordedChange change);
    /// All such changes of this run, those of setDetail() and setPeriod() among them.
    [[nodiscard]] std::span<RecordedChange const> changes() const { return run_->changes(); }
    /// Ends the run, if one goes on, and begins it, or the last one, again with the levels and periods that
    /// it began with.
    void startAgain();
    /// Everything that was done in this run, by the player or by a solution, for play() in a run that repeats
    /// it.
    [[nodiscard]] Playback done() const;
    /// Feeds this to the run that goes on, until it ends, in place of a loaded solution. Does nothing while
    /// building.
    void play(Playback playback);
    /// Whether play() feeds this run.
    [[nodiscard]] bool playing() const { return played_.has_value(); }

    /// Changes the world as it is now in a way that no level and no solution can state, see
    /// LevelRun::alter(). It is not done again in other worlds of the session.
    void alter(std::string why, std::function<void(World&)> const& make = {}) {
        run_->alter(std::move(why), make);
    }
    /// Why the run counts as no solution, although it may reach the goals; nothing if it counts.
    [[nodiscard]] std::optional<std::string> const& altered() const { return run_->altered(); }
    /// Is called whenever the session has built another world, at its frame 0; may be empty.
    void whenBuilt(std::function<void()> call) { built_ = std::move(call); }
    /// Why the world could not be built again as it is placed now, in the words of the first problem, such as
    /// a script that no longer has a parameter that an object states; nothing if it can.
    [[nodiscard]] std::optional<std::string> whyNotBuilt() const;
    /// Builds the world again as it is placed. While building only. Throws InputError, see whyNotBuilt().
    void rebuild();

    [[nodiscard]] bool solved() const { return judge().solved(); }
    [[nodiscard]] GoalJudge const& judge() const { return run_->judge(); }

    /// Why the run cannot stand in a solution: it began with a detail level, asked for on the command line,
    /// that is other physics, or with a period that is no matter of accuracy, or it was altered, see alter().
    /// Nothing if it can.
    [[nodiscard]] std::optional<std::string> whyNotRecorded() const { return run_->whyNotRecorded(); }
    /// Placements, inputs and changes so far, those among them that make the level's own levels and periods
    /// what the run began with, as a solution that can be recorded in the level.
    [[nodiscard]] Solution record(std::string name) const;
    /// Ends the run, places a solution's parts, and feeds its inputs and makes its changes in their frames of
    /// every run until the player changes what is placed. Throws InputError if it does not fit; then
    /// everything stays as it was placed.
    void load(Solution const& solution);

    /// Detail level and period of the running world, remembered as by change(), and of all later ones. Throw
    /// std::invalid_argument like change(); a period also takes a component's bare name.
    void setDetail(std::string const& effect, std::string const& level);
    void setPeriod(std::string const& component, int period);
    /// Why setDetail() would refuse it; nothing if it would not.
    [[nodiscard]] std::optional<std::string> whyNotDetail(std::string const& effect,
                                                          std::string const& level) const;

private:
    [[nodiscard]] bool building() const { return !run_->begun(); }
    [[nodiscard]] std::unique_ptr<LevelRun> runOf(Placements::List const& placed) const;
    /// Makes an edit, if a world can be built from it.
    bool keep(std::optional<Placements::List> next);
    /// After undo and redo.
    void placedOtherwise();
    void use(std::unique_ptr<LevelRun> run);

    Registry const& registry_;
    PartLibrary const& parts_;
    LevelFile level_;
    WorldOptions options_; // of the next runs
    Placements placements_;
    std::unique_ptr<LevelRun> run_; // never null; one that has not begun while building
    std::function<void()> built_;
    bool paused_ = false;
    std::optional<WorldOptions> lastBegunWith_; // what the last run began with
    Playback solution_;                         // of a loaded solution
    std::optional<Playback> played_;            // of this run, in place of the solution's
};

} // namespace trembler
