// The dynamics knob: the engine's substeps per frame.
#include "game/budget/knobs.hpp"
#include "game/budget/making_options.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/settings.hpp"

#include <fmt/format.h>

#include <cmath>

namespace trembler::budget {
namespace dynamics_knob {
namespace {

constexpr std::string_view effect = "dynamics";

// µs per small body and frame, on the machine of docs/measurements/accuracy.md.
double workOf(int steps) {
    return 0.19 + 0.52 * steps;
}

// Too long a substep tears a chain and topples a stack (docs/measurements/accuracy.md): not a small error but
// a different course of events. So joints need all the stated substeps; without joints two are enough.
int fewestSteps(World const& world, int stated) {
    auto const* const joints = world.store().findColumn<Joint>();
    bool const jointed = joints != nullptr && !joints->empty();
    return jointed ? stated : std::min(stated, 2);
}

} // namespace
} // namespace dynamics_knob

std::optional<Knob> dynamicsKnob(World const& world, MotionLog const& log) {
    using namespace dynamics_knob;
    auto const levels = levelsOf(world, effect);
    auto const now = working(levels);
    if (!now) {
        return std::nullopt;
    }
    auto const settings = settingsOf<DynamicsSettings>(world);
    Knob knob;
    knob.effect = effect;
    knob.of = "of the way that a thing falls in a second";
    knob.source = "Half a step times the change of velocities in the last second, as the engines' steps are "
                  "of the first order.";
    knob.components.push_back(title(*now->info));
    auto const add = [&](std::string name, int setting, int steps, std::string cannot) {
        double const step = frameDuration / steps;
        if (setting == settings.substeps) {
            knob.current = knob.options.size();
        }
        knob.options.push_back({std::move(name),
                                {toSetting(DynamicsSettings::text.key, "substeps", setting)},
                                workOf(steps),
                                {step / 2 * log.changePerSecond(), step},
                                std::move(cannot)});
    };
    // Fewer substeps than the level, or automatically its scene, needs are not allowed: see fewestSteps. The
    // current number stays allowed.
    bool const automatic = log.statedSteps() == 0;
    int const fewest = automatic ? log.automaticSteps() : fewestSteps(world, log.statedSteps());
    if (automatic) {
        add(fmt::format("automatic: {} steps", fewest), 0, fewest, "");
    }
    std::vector<int> usual{1, 2, 4, 8, 16};
    if (!automatic) {
        usual = withCurrent(usual, log.statedSteps());
    }
    if (settings.substeps > 0) {
        usual = withCurrent(usual, settings.substeps);
    }
    for (int const steps : usual) {
        bool const tooFew = steps < fewest && steps != settings.substeps;
        add(steps == 1 ? std::string("1 step") : fmt::format("{} steps", steps), steps, steps,
            tooFew ? "with so long steps joints open, and chains and stacks fall apart" : "");
    }
    return knob;
}

} // namespace trembler::budget
