#include "game/budget/knobs.hpp"

namespace trembler::budget {

std::vector<Knob> knobsOf(World const& world, MotionLog const& log) {
    std::vector<Knob> knobs;
    auto const add = [&](std::optional<Knob> knob) {
        if (knob) {
            knobs.push_back(std::move(*knob));
        }
    };
    add(buoyancyKnob(world));
    add(dynamicsKnob(world, log));
    add(electricityKnob(world));
    add(gravityKnob(world));
    add(magnetismKnob(world));
    add(soundKnob(world));
    return knobs;
}

} // namespace trembler::budget
