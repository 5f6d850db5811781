// A condition at work on a world: the objects it speaks of, and what it remembers from frame to frame.
#pragma once

#include "puzzle/goals/object_finder.hpp"
#include "runtime/world/world.hpp"

#include <span>
#include <vector>

namespace trembler {

class ConditionState {
public:
    /// `condition` must outlive it.
    ConditionState(Condition const& condition, ObjectFinder const& finder, ObjectId it);

    /// `ticks` is the time since the last update, in ticks of the world, at least 1.
    void update(World const& world, std::uint64_t ticks);
    [[nodiscard]] bool met() const { return met_; }
    /// 0 to 1: how much of it is done.
    [[nodiscard]] double progress() const { return met_ ? 1 : progress_; }
    /// Of a sequence.
    [[nodiscard]] std::size_t stepsDone() const { return steps_; }
    [[nodiscard]] std::span<ConditionState const> children() const { return children_; }

    /// Adds the events that make it true, or false if `truth` is false.
    void collectCauses(World const& world, bool truth, std::vector<EventId>& events) const;
    void collectObjects(std::vector<ObjectId>& objects) const;
    /// Forgets how long it has been held.
    void restart();

private:
    [[nodiscard]] bool holds(World const& world);
    [[nodiscard]] bool inside(World const& world);
    [[nodiscard]] bool touching(World const& world);
    [[nodiscard]] bool moved(World const& world);
    [[nodiscard]] bool counted();
    void advanceSequence(World const& world);
    [[nodiscard]] double wayOf(World const& world, std::size_t subject) const;
    void collectContacts(World const& world, bool truth, std::vector<EventId>& events) const;

    Condition const* condition_;
    std::vector<ObjectId> subjects_;
    std::vector<ObjectId> objects_;
    std::vector<Vec2> starts_; // m, of the subjects (moved)
    std::vector<ConditionState> children_;

    bool met_ = false;
    bool base_ = false; // whether it holds, leaving aside for how long
    double progress_ = 0;
    std::uint64_t needed_ = 1; // ticks of the world for which it must hold
    std::uint64_t held_ = 0;   // ticks for which it has held
    std::size_t steps_ = 0;
    bool blocked_ = false;            // sequence: the next step already held when its turn came
    std::vector<EventId> stepCauses_; // sequence: of the steps that are done
    EventId ended_;                   // touching: when the last contact ended
};

} // namespace trembler
