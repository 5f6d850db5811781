#include "game/budget/motion_log.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/solver_choice.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::budget {

void MotionLog::clear() {
    last_.clear();
    changes_.clear();
    seen_ = 0;
    known_ = false;
}

void MotionLog::noteSteps(World const& world) {
    auto const* const column = world.store().findColumn<DynamicsSettings>();
    DynamicsSettings const settings =
        column == nullptr || column->empty() ? DynamicsSettings{} : column->values().front();
    if (!known_) {
        stated_ = settings.substeps;
        known_ = true;
    }
    if (auto const* const choice = world.find<SolverChoice>(); choice != nullptr && settings.substeps == 0) {
        automatic_ = std::max(choice->substeps, 1);
    }
}

void MotionLog::look(World const& world) {
    if (world.frame() < seen_) {
        clear(); // another run has begun
    }
    noteSteps(world);
    if (world.frame() % interval != 0 || (world.frame() == seen_ && !last_.empty())) {
        return;
    }
    auto const* const velocities = world.store().findColumn<Velocity>();
    auto const* const fixed = world.store().findColumn<Fixed>();
    std::map<ObjectId, Vec2> now;
    std::map<ObjectId, double> changes;
    for (std::size_t row = 0; velocities != nullptr && row < velocities->size(); ++row) {
        ObjectId const id = velocities->owners()[row];
        if (fixed != nullptr && fixed->has(id)) {
            continue;
        }
        Vec2 const velocity = velocities->values()[row].value;
        now.emplace_hint(now.end(), id, velocity);
        if (auto const before = last_.find(id); before != last_.end()) {
            changes.emplace_hint(changes.end(), id, length(velocity - before->second));
        }
    }
    if (!last_.empty()) {
        changes_.push_back(std::move(changes));
        if (changes_.size() > kept) {
            changes_.erase(changes_.begin());
        }
    }
    last_ = std::move(now);
    seen_ = world.frame();
}

double MotionLog::changePerSecond() const {
    std::map<ObjectId, double> sums;
    for (auto const& changes : changes_) {
        for (auto const& [id, change] : changes) {
            sums[id] += change;
        }
    }
    if (sums.empty()) {
        return 0;
    }
    double squares = 0;
    for (auto const& [id, sum] : sums) {
        squares += sum * sum;
    }
    double const seconds = static_cast<double>(changes_.size() * interval) * frameDuration;
    return std::sqrt(squares / static_cast<double>(sums.size())) / seconds;
}

} // namespace trembler::budget
