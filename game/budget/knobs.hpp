// The options of a running world and the error of each there: the estimates behind the panel and the budget.
// Reads the world and never changes it.
#pragma once

#include "game/budget/knob.hpp"
#include "game/budget/motion_log.hpp"
#include "runtime/world/world.hpp"

#include <optional>
#include <vector>

namespace trembler::budget {

/// One knob per effect that has any choice in this world, in order of the effects' names. Errors come from
/// evaluating every option for a sample of objects at their current places where that is possible
/// (gravity, magnetism, buoyancy), from a formula and the logged motion (dynamics), or from the figures of
/// `trembler accuracy` (sound); Knob::source says which. `log` must have looked at the world's last frames.
[[nodiscard]] std::vector<Knob> knobsOf(World const& world, MotionLog const& log);

// The knob of one effect each; nullopt where the effect is absent.
[[nodiscard]] std::optional<Knob> dynamicsKnob(World const& world, MotionLog const& log);
[[nodiscard]] std::optional<Knob> gravityKnob(World const& world);
[[nodiscard]] std::optional<Knob> electricityKnob(World const& world);
[[nodiscard]] std::optional<Knob> magnetismKnob(World const& world);
[[nodiscard]] std::optional<Knob> buoyancyKnob(World const& world);
[[nodiscard]] std::optional<Knob> soundKnob(World const& world);

} // namespace trembler::budget
