// One run of a level: its world, the judge of its goals, and the log of what was done to it.
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

/// Until begin() the world stands at frame 0 and nothing is logged; there is no way back to that: another run
/// is another object. Not thread-safe.
class LevelRun {
public:
    /// Builds the world of a level with what is placed in it. Throws InputError if that cannot be. All but
    /// the placements and the options must outlive it.
    LevelRun(Registry const& registry, PartLibrary const& parts, LevelFile const& level,
             std::span<Placement const> placements, WorldOptions const& options);

    [[nodiscard]] World const& world() const { return *built_.world; }
    [[nodiscard]] GoalJudge const& judge() const { return judge_; }
    /// The object that a placement became, by its index in those that were given. It may have been destroyed
    /// since.
    [[nodiscard]] ObjectId objectOf(std::size_t placement) const { return built_.placements[placement]; }
    /// Likewise of the level's "objects" and "joints", by index.
    [[nodiscard]] std::span<ObjectId const> objects() const { return built_.objects; }
    [[nodiscard]] std::span<ObjectId const> joints() const { return built_.joints; }
    /// The index of the placement that an object came from; nothing for any other object.
    [[nodiscard]] std::optional<std::size_t> placementOf(ObjectId object) const;

    /// From now on, what is done is logged. Once only.
    void begin() { begunWith_ = world().options(); }
    [[nodiscard]] bool begun() const { return begunWith_.has_value(); }
    /// The options, what the level states among them, that the run began with; before begin(), those that the
    /// world has now.
    [[nodiscard]] WorldOptions const& begunWith() const {
        return begunWith_ ? *begunWith_ : world().options();
    }
    /// Makes detail levels and periods those of `options`, which a run of this level had; before begin()
    /// only. They are not checked as change() checks them, as they may have been other physics then, too.
    void takeOver(WorldOptions const& options);

    /// One frame, after begin().
    void step();
    /// What the player does, for the next frame. Does nothing before begin().
    void feed(PlayerInput const& input);
    /// Changes how exactly the world is computed, from the next frame on. Throws std::invalid_argument, see
    /// change_fault.hpp.
    void change(RecordedChange change);

    /// Changes the world, between frames, in a way that neither a level nor a solution can state: another
    /// version of a script, another value of its parameters. `why` says so in words for people; the run then
    /// counts as no solution, see altered(). `make` may be empty, if the change was made elsewhere.
    void alter(std::string why, std::function<void(World&)> const& make);
    /// Why the run counts as no solution: what alter() was told first; nothing if it was never called.
    [[nodiscard]] std::optional<std::string> const& altered() const { return altered_; }

    /// What was fed since begin(), with the frames that see it, ascending.
    [[nodiscard]] std::span<RecordedInput const> inputs() const { return inputs_; }
    /// The changes made since begin(), with the first frames that they count for, ascending.
    [[nodiscard]] std::span<RecordedChange const> changes() const { return changes_; }
    /// The run so far as a solution without a name and placements. Its changes begin with those that make the
    /// level's own levels and periods what the run began with.
    [[nodiscard]] Solution record() const;
    /// Why the run cannot stand in a solution, see Session::whyNotRecorded().
    [[nodiscard]] std::optional<std::string> whyNotRecorded() const;

private:
    void noteGoals();
    /// What differs between the level's own detail levels and periods and those that the run began with.
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
