#include "game/budget/knobs.hpp"

namespace trembler::budget {

// Effects may be left out of a program.
std::vector<Knob> knobsOf(World const& world, MotionLog const& log) {
    std::vector<Knob> knobs;
    auto const add = [&](std::optional<Knob> knob) {
        if (knob) {
            knobs.push_back(std::move(*knob));
        }
    };
#ifndef TREMBLER_WITHOUT_BUOYANCY
    add(buoyancyKnob(world));
#endif
    add(dynamicsKnob(world, log));
#ifndef TREMBLER_WITHOUT_ELECTRICITY
    add(electricityKnob(world));
#endif
#ifndef TREMBLER_WITHOUT_GRAVITY
    add(gravityKnob(world));
#endif
#ifndef TREMBLER_WITHOUT_MAGNETISM
    add(magnetismKnob(world));
#endif
#ifndef TREMBLER_WITHOUT_SOUND
    add(soundKnob(world));
#endif
    return knobs;
}

} // namespace trembler::budget
