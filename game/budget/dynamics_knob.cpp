// Dynamics: steps of the engine in a frame.
#include "game/budget/knobs.hpp"
#include "game/budget/making_options.hpp"
#include "physics/dynamics/joint.hpp"
#include "physics/dynamics/settings.hpp"

#include <fmt/format.h>

#include <cmath>

namespace trembler::budget {
namespace {

constexpr std::string_view effect = "dynamics";

// µs for one small body, on the machine of docs/accuracy.md.
double workOf(int steps) {
    return 0.19 + 0.52 * steps;
}

// Too long a step tears a chain and topples a stack (docs/accuracy.md): no small error but another course of
// things.
int fewestSteps(World const& world, DynamicsSettings const& settings) {
    auto const* const joints = world.store().findColumn<Joint>();
    bool const jointed = joints != nullptr && !joints->empty();
    return jointed ? settings.substeps : std::min(settings.substeps, 2);
}

} // namespace

std::optional<Knob> dynamicsKnob(World const& world, MotionLog const& log) {
    auto const levels = levelsOf(world, effect);
    auto const now = working(levels);
    if (!now) {
        return std::nullopt;
    }
    auto const settings = settingsOf<DynamicsSettings>(world);
    Knob knob;
    knob.effect = effect;
    knob.of = "of the way fallen in a second";
    knob.source =
        "Half a step times what velocities have changed by in the last second: the engines' steps are of "
        "the first order.";
    knob.components.push_back(title(*now->info));
    if (settings.substeps < 1) { // the solver chooses by itself what the scene needs
        knob.options.push_back(
            {"automatic steps", {toSetting(DynamicsSettings::text.key, "substeps", 0)}, 1, {}, {}});
        knob.source = "The scene itself calls for as many steps as it needs.";
        return knob;
    }
    int const fewest = fewestSteps(world, settings);
    for (int const steps : withCurrent(std::vector<int>{1, 2, 4, 8, 16}, settings.substeps)) {
        double const step = frameDuration / steps;
        Option option{fmt::format("{} step{} per frame", steps, steps == 1 ? "" : "s"),
                      {toSetting(DynamicsSettings::text.key, "substeps", steps)},
                      workOf(steps),
                      {step / 2 * log.changePerSecond(), step},
                      {}};
        if (steps < fewest) {
            option.cannot = "with so long steps joints gape, and chains and stacks burst";
        }
        if (steps == settings.substeps) {
            knob.current = knob.options.size();
        }
        knob.options.push_back(std::move(option));
    }
    return knob;
}

} // namespace trembler::budget
