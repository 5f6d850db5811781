// How far the conditions of a level are from being met in a world, condition by condition.
#pragma once

#include "insight/miss/miss.hpp"
#include "puzzle/goals/judging/condition_state.hpp"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace trembler::insight {

/// Measures one condition and its children. Holds what a kind needs to remember of the start. Make it before
/// the first frame. Not thread-safe.
class ConditionMiss {
public:
    /// `state` must outlive it, and stay where it is.
    ConditionMiss(ConditionState const& state, World const& world);

    /// How far it is from being met now; of measure 0 if it is. `circuits` must be one of this world.
    [[nodiscard]] Miss now(World const& world, CircuitSight& circuits) const;

    [[nodiscard]] ConditionState const& state() const { return state_; }
    [[nodiscard]] std::span<ConditionMiss const> children() const { return children_; }
    /// Where the state's subjects were at the start, in m.
    [[nodiscard]] std::vector<Vec2> const& starts() const { return starts_; }

private:
    ConditionState const& state_;
    std::vector<Vec2> starts_;
    std::vector<ConditionMiss> children_;
};

/// The keys of the kinds of conditions that can be measured: all of conditionKinds().
[[nodiscard]] std::vector<std::string_view> measurableKinds();

/// Distances, in m, become measures by d / (d + this).
inline constexpr double typicalDistance = 0.5;

} // namespace trembler::insight
