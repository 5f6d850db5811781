#include "puzzle/goals/judging/condition_state.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

ConditionState::ConditionState(Condition const& condition, ObjectFinder const& finder, ObjectId it)
    : condition_(&condition), subjects_(finder.find(condition.subject, it)),
      objects_(finder.find(condition.object, it)),
      needed_(condition.seconds
                  ? World::ticksPerFrame * static_cast<std::uint64_t>(
                                               std::max(1L, std::lround(*condition.seconds / frameDuration)))
                  : 1) {
    constexpr std::size_t own = 8; // the memory of a condition itself, in objects
    if (!finder.take(own + subjects_.size() + objects_.size(), condition.path)) {
        subjects_ = {}; // not clear(), which keeps the memory
        objects_ = {};
        return;
    }
    condition.kind->begin(*this, finder, it);
}

void ConditionState::addChildren(ObjectFinder const& finder, ObjectId it) {
    for (Condition const& child : condition_->children) {
        children_.emplace_back(child, finder, it);
    }
}

void ConditionState::restart() {
    held_ = 0;
    for (ConditionState& child : children_) {
        child.restart();
    }
}

void ConditionState::update(World const& world, std::uint64_t ticks) {
    for (ConditionState& child : children_) {
        child.update(world, ticks);
    }
    Standing const now = condition_->kind->judge(*this, world);
    holds_ = now.holds;
    progress_ = now.progress;
    held_ = holds_ ? std::min(held_ + ticks, needed_) : 0;
    met_ = held_ >= needed_;
    if (needed_ > World::ticksPerFrame && holds_) {
        progress_ = static_cast<double>(held_) / static_cast<double>(needed_);
    }
}

void ConditionState::collectCauses(World const& world, bool truth, std::vector<EventId>& events) const {
    condition_->kind->collectCauses(*this, world, truth, events);
    std::erase_if(events, [](EventId event) { return !event; });
}

void ConditionState::collectObjects(std::vector<ObjectId>& objects) const {
    objects.insert(objects.end(), subjects_.begin(), subjects_.end());
    objects.insert(objects.end(), objects_.begin(), objects_.end());
    for (ConditionState const& child : children_) {
        child.collectObjects(objects);
    }
}

} // namespace trembler
