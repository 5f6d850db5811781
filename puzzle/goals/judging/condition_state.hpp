// The state of a condition in a running world: its objects, and its memory from frame to frame.
#pragma once

#include "puzzle/goals/judging/object_finder.hpp"
#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

#include <any>
#include <span>
#include <utility>
#include <vector>

namespace trembler {

/// A level may have half a million of these. So they are plain values in vectors, without virtual functions,
/// and data that only some kinds of conditions need are in memory().
class ConditionState {
public:
    /// `condition` must outlive it. Complains through `finder` about objects that lack what the condition
    /// needs, and about too many objects; the state must then not be used.
    ConditionState(Condition const& condition, ObjectFinder const& finder, ObjectId it);

    /// `ticks` is the time since the last update, in ticks of the world, at least 1.
    void update(World const& world, std::uint64_t ticks);
    [[nodiscard]] bool met() const { return met_; }
    /// Whether it holds at present, whether or not it has held for the required time.
    [[nodiscard]] bool holds() const { return holds_; }
    /// 0 to 1: how much of it is done.
    [[nodiscard]] double progress() const { return met_ ? 1 : progress_; }

    [[nodiscard]] Condition const& condition() const { return *condition_; }
    /// The objects that the condition's selectors refer to, each list ascending.
    [[nodiscard]] std::vector<ObjectId> const& subjects() const { return subjects_; }
    [[nodiscard]] std::vector<ObjectId> const& objects() const { return objects_; }
    [[nodiscard]] std::span<ConditionState const> children() const { return children_; }
    [[nodiscard]] std::span<ConditionState> children() { return children_; }

    /// Adds the events that make the condition true or, if `truth` is false, make it false.
    void collectCauses(World const& world, bool truth, std::vector<EventId>& events) const;
    void collectObjects(std::vector<ObjectId>& objects) const;
    /// Resets the time for which the condition and its children have held.
    void restart();

    // Only the condition's kind uses these.

    /// Adds a state for each child of the condition, in which "it" is `it`.
    void addChildren(ObjectFinder const& finder, ObjectId it);
    /// Stores the memory of the condition's kind. A value up to the size of a pointer needs no allocation.
    template <class Memory>
    void remember(Memory memory) {
        memory_ = std::move(memory);
    }
    /// The stored memory. Throws std::bad_any_cast if it is of another type.
    template <class Memory>
    [[nodiscard]] Memory& memory() {
        return std::any_cast<Memory&>(memory_);
    }
    template <class Memory>
    [[nodiscard]] Memory const& memory() const {
        return std::any_cast<Memory const&>(memory_);
    }

private:
    Condition const* condition_;
    std::vector<ObjectId> subjects_;
    std::vector<ObjectId> objects_;
    std::vector<ConditionState> children_;
    std::any memory_;

    bool met_ = false;
    bool holds_ = false;
    double progress_ = 0;
    std::uint64_t needed_ = 1; // ticks of the world for which it must hold
    std::uint64_t held_ = 0;   // ticks for which it has held
};

} // namespace trembler
