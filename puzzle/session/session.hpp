// One player at one level: placing parts, running the world, taking everything back.
#pragma once

#include "puzzle/goals/goal_judge.hpp"
#include "puzzle/session/history.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/world.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler {

enum class SessionMode : std::uint8_t {
    building, ///< parts can be placed; the world stands at frame 0
    running,
    paused,
};

/// A part that the player placed. The number names it for as long as the session lives, through undo and
/// redo.
struct PlacedPart {
    int number = 0;
    Placement placement;
};

/// One compartment of the toolbox.
struct ToolboxSlot {
    std::string part;
    int total = 0;
    int left = 0;
};

/// Whether a part may stand somewhere; if not, why, in words for the player.
struct Verdict {
    bool ok = true;
    std::string why;
};

/// Headless: the window, the command line and the tests all play through it. The world is rebuilt from the
/// level and the placements whenever these change, so stop() puts everything back exactly as it was placed.
/// Not thread-safe.
class Session {
public:
    /// `registry` and `parts` must outlive the session. Throws InputError if the level cannot be built.
    Session(Registry const& registry, PartLibrary const& parts, LevelFile level, WorldOptions options = {});
    ~Session();
    Session(Session const&) = delete;
    Session& operator=(Session const&) = delete;

    [[nodiscard]] LevelFile const& level() const { return level_; }
    [[nodiscard]] PartLibrary const& parts() const { return parts_; }
    [[nodiscard]] SessionMode mode() const { return mode_; }
    /// The world as it is now; while building, as it will start. Valid until the next call that changes
    /// anything.
    /// To be looked at, and subscribed to (World::want()). What changes it goes through feed() and change(),
    /// which record it.
    [[nodiscard]] World const& world() const { return *world_; }

    // Building. All of these do nothing, and say so, unless mode() is building.
    [[nodiscard]] std::vector<PlacedPart> const& placed() const { return history_.now(); }
    [[nodiscard]] std::vector<ToolboxSlot> toolbox() const;
    /// The object in world() that a placed part became, or an invalid id.
    [[nodiscard]] ObjectId objectOf(int number) const;
    /// The placed part that an object in world() came from.
    [[nodiscard]] std::optional<int> numberOf(ObjectId object) const;
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
    [[nodiscard]] bool canUndo() const { return mode_ == SessionMode::building && history_.canUndo(); }
    [[nodiscard]] bool canRedo() const { return mode_ == SessionMode::building && history_.canRedo(); }

    // Running.
    void start();
    void pause();
    void resume();
    /// Ends the run: everything is back as it was placed.
    void stop();
    /// One frame. Starts the run if it has not begun.
    void step();
    /// Passes on what the player does to the running world, and remembers it.
    void feed(PlayerInput const& input);
    /// All inputs of this run, with the frame before which they came.
    [[nodiscard]] std::span<RecordedInput const> inputs() const { return inputs_; }
    /// Changes how exactly the running world is computed from its next frame on, and remembers it with that
    /// frame; later runs know nothing of it. Does nothing while building. Throws std::invalid_argument, see
    /// world_change.hpp.
    void change(RecordedChange change);
    /// All such changes of this run, those of setDetail() and setPeriod() among them.
    [[nodiscard]] std::span<RecordedChange const> changes() const { return changes_; }
    /// Ends the run, if one goes on, and begins it, or the last one, again with the levels and periods that
    /// it began with.
    void startAgain();

    [[nodiscard]] bool solved() const;
    [[nodiscard]] GoalJudge const& judge() const { return *judge_; }

    /// Why what the run began with cannot stand in a solution: a detail level, asked for on the command line,
    /// that is other physics, or a period that is no matter of accuracy. Nothing if it can.
    [[nodiscard]] std::optional<std::string> whyNotRecorded() const;
    /// Placements, inputs and changes so far, those among them that make the level's own levels and periods
    /// what the run began with, as a solution that can be recorded in the level.
    [[nodiscard]] Solution record(std::string name) const;
    /// Places a solution's parts and will feed its inputs and make its changes at their frames. Throws
    /// InputError if it does not fit.
    void load(Solution const& solution);

    /// Detail level and period of the running world, remembered as by change(), and of all later ones. Throw
    /// std::invalid_argument like change(); a period also takes a component's bare name.
    void setDetail(std::string const& effect, std::string const& level);
    void setPeriod(std::string const& component, int period);
    /// Why setDetail() would refuse it; nothing if it would not.
    [[nodiscard]] std::optional<std::string> whyNotDetail(std::string const& effect,
                                                          std::string const& level) const;

private:
    using Placed = std::vector<PlacedPart>;

    void rebuild();
    bool changePlaced(Placed placed);
    void feedRecorded();
    void remember(RecordedChange change);
    void noteGoals();
    [[nodiscard]] RecordedInput named(PlayerInput const& input) const;
    [[nodiscard]] std::optional<PlayerInput> resolved(RecordedInput const& input) const;

    Registry const& registry_;
    PartLibrary const& parts_;
    LevelFile level_;
    WorldOptions options_;
    SessionMode mode_ = SessionMode::building;
    History<Placed> history_;
    int nextNumber_ = 1;
    std::unique_ptr<World> world_;
    std::unique_ptr<GoalJudge> judge_;
    std::vector<std::pair<int, ObjectId>> objects_; // of the placed parts
    std::vector<RecordedInput> inputs_;
    std::vector<RecordedChange> changes_;
    std::optional<WorldOptions> startOptions_; // as they were when the run began
    std::vector<RecordedInput> script_;        // inputs of a loaded solution
    std::vector<RecordedChange> scriptChanges_;
};

} // namespace trembler
