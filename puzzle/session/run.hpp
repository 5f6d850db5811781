// One run of a level: its world, the judge of its goals, and the log of its inputs and changes.
#pragma once

#include "puzzle/goals/goal_judge.hpp"
#include "runtime/level/build/build_world.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// Until begin() the world stays at frame 0 and nothing is logged. A run cannot be restarted; create another
/// object. Not thread-safe.
class LevelRun {
public:
    /// Builds the world of a level with the placements and the player's wires. Throws InputError if that is
    /// not possible. All arguments but the placements and the options must outlive the run.
    LevelRun(Registry const& registry, PartLibrary const& parts, LevelFile const& level,
             std::span<Placement const> placements, WorldOptions const& options,
             std::span<LevelConnection const> wires = {});
    /// The same with a world that is built already. `registry` and `level` must outlive the run.
    LevelRun(Registry const& registry, LevelFile const& level, BuiltLevel built);

    [[nodiscard]] World const& world() const { return *built_.world; }
    [[nodiscard]] GoalJudge const& judge() const { return judge_; }
    /// The object made from a placement, by the placement's index in the list given; of a composite part, its
    /// main piece. It may have been destroyed since.
    [[nodiscard]] ObjectId objectOf(std::size_t placement) const { return built_.placements[placement]; }
    /// The same for the level's "objects" and "joints", by index.
    [[nodiscard]] std::span<ObjectId const> objects() const { return built_.objects; }
    [[nodiscard]] std::span<ObjectId const> joints() const { return built_.joints; }
    /// All objects of an entry of "objects" (Origin::Kind::object) or of a placement, by its index, in the
    /// order of Origin::piece. They may have been destroyed since.
    [[nodiscard]] std::vector<ObjectId> pieces(Origin::Kind kind, std::size_t index) const;
    /// Whether the level, or a composite part, connects the two objects from the start.
    [[nodiscard]] bool connectedAtStart(ObjectId a, ObjectId b) const;
    /// The index of the placement that an object came from; nothing for any other object.
    [[nodiscard]] std::optional<std::size_t> placementOf(ObjectId object) const;

    /// Starts the log of inputs and changes. To be called once.
    void begin() { begunWith_ = world().options(); }
    [[nodiscard]] bool begun() const { return begunWith_.has_value(); }
    /// The options that the run began with, including the options that the level states; before begin(), the
    /// world's present options.
    [[nodiscard]] WorldOptions const& begunWith() const {
        return begunWith_ ? *begunWith_ : world().options();
    }
    /// Sets the detail levels and periods to those of `options`, from another run of this level; before
    /// begin() only. change() could refuse them: that run may have begun with other physics. So they are not
    /// checked.
    void takeOver(WorldOptions const& options);

    /// Computes one frame. Only after begin().
    void step();
    /// Passes a player input to the next frame. Does nothing before begin().
    void feed(PlayerInput const& input);
    /// Changes how exactly the world is computed, from the next frame on. Throws std::invalid_argument, see
    /// change_fault.hpp.
    void change(RecordedChange change);

    /// Changes the world, between frames, in a way that neither a level nor a solution can state: another
    /// version of a script, another value of its parameters. `why` states the change in words for people; the
    /// run then counts as no solution, see altered(). `make` may be empty, if the change was made elsewhere.
    void alter(std::string why, std::function<void(World&)> const& make);
    /// Why the run counts as no solution: the reason of the first alter(); nothing if there was none.
    [[nodiscard]] std::optional<std::string> const& altered() const { return altered_; }

    /// The inputs since begin(), with the frames that receive them, ascending.
    [[nodiscard]] std::span<RecordedInput const> inputs() const { return inputs_; }
    /// The changes since begin(), with the first frames that they affect, ascending.
    [[nodiscard]] std::span<RecordedChange const> changes() const { return changes_; }
    /// The run so far as a solution without a name and placements. Its changes begin with those from the
    /// level's detail levels and periods to the run's initial ones.
    [[nodiscard]] Solution record() const;
    /// Why a solution cannot state the run: its initial options, see Session::whyNotRecorded(), or altered().
    [[nodiscard]] std::optional<std::string> whyNotRecorded() const;

private:
    void noteGoals();
    /// The changes from the level's detail levels and periods to the run's initial ones.
    [[nodiscard]] std::vector<RecordedChange> changesBefore() const;

    Registry const& registry_;
    LevelFile const& level_;
    BuiltLevel built_;
    GoalJudge judge_;
    std::optional<WorldOptions> begunWith_;
    std::optional<std::string> altered_;
    std::vector<RecordedInput> inputs_;
    std::vector<RecordedChange> changes_;
};

} // namespace trembler
