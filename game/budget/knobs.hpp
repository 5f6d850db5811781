// What there is to choose in a running world, and how far off each choice is there: the estimates behind the
// panel and the budget. Reads the world and never changes it.
#pragma once

#include "game/budget/knob.hpp"
#include "game/budget/motion_log.hpp"
#include "runtime/world/world.hpp"

#include <optional>
#include <vector>

namespace trembler::budget {

/// One knob per effect that has any choice in this world, in order of the effects' names. Errors come from
/// evaluating every option for a sample of objects where they are now wherever that can be done (gravity,
/// magnetism, buoyancy), from a formula and what has been seen to move (dynamics), or from the figures of
/// `trembler accuracy` (sound); Knob::source says which. `log` has been told of the world's last frames.
[[nodiscard]] std::vector<Knob> knobsOf(World const& world, MotionLog const& log);

// Those of one effect each; nothing where the effect is absent.
[[nodiscard]] std::optional<Knob> dynamicsKnob(World const& world, MotionLog const& log);
[[nodiscard]] std::optional<Knob> gravityKnob(World const& world);
[[nodiscard]] std::optional<Knob> electricityKnob(World const& world);
[[nodiscard]] std::optional<Knob> magnetismKnob(World const& world);
[[nodiscard]] std::optional<Knob> buoyancyKnob(World const& world);
[[nodiscard]] std::optional<Knob> soundKnob(World const& world);

} // namespace trembler::budget
