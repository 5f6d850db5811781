// The sound knob: the number of modes per body.
#include "audio/effect/properties/sounds.hpp"
#include "game/budget/knobs.hpp"
#include "game/budget/making_options.hpp"

#include <array>

namespace trembler::budget {
namespace sound_knob {
namespace {

constexpr std::string_view effect = "sound";

/// A measured point of the sound ladder of `trembler accuracy`.
struct Calibrated {
    std::string_view level;
    double microseconds;
    double hertz; ///< error of a body's mean audible frequency, Hz
};
constexpr std::array<Calibrated, 5> ladder{{{"1-mode", 5.71, 40.8},
                                            {"4-modes", 6.79, 7.1},
                                            {"8-modes", 7.56, 3.51},
                                            {"16-modes", 8.56, 0.831},
                                            {"32-modes", 10.6, 0}}};
/// Sound moves no bodies, so its error needs a conversion: an error of 100 % of the pitch counts as much as a
/// body that is off by this.
constexpr double metresForAll = 0.01;

double meanFrequency(World const& world) {
    double sum = 0;
    double weights = 0;
    if (Sounds const* const sounds = world.find<Sounds>()) {
        for (Sounds::Body const& body : sounds->bodies) {
            sum += body.loudness * body.brightness;
            weights += body.loudness;
        }
    }
    constexpr double usual = 1000;
    return weights > 0 && sum > 0 ? sum / weights : usual;
}

} // namespace
} // namespace sound_knob

std::optional<Knob> soundKnob(World const& world) {
    using namespace sound_knob;
    auto const levels = levelsOf(world, effect);
    auto const now = working(levels);
    if (!now) {
        return std::nullopt;
    }
    Knob knob;
    knob.effect = effect;
    knob.of = "of the pitch";
    knob.source = "Calibrated: the error of the level in docs/measurements/accuracy.md. It changes no "
                  "motion, so it counts for little.";
    double const frequency = meanFrequency(world);
    for (ComponentStatus const& level : levels) {
        for (Calibrated const& known : ladder) {
            if (known.level != level.info->text.level) {
                continue;
            }
            double const share = known.hertz / frequency;
            if (level.info == now->info) {
                knob.current = knob.options.size();
            }
            knob.components.push_back(title(*level.info));
            knob.options.push_back({std::string(known.level),
                                    {toLevel(effect, known.level)},
                                    known.microseconds,
                                    {metresForAll * share, share},
                                    {}});
        }
    }
    return knob.options.empty() ? std::nullopt : std::optional(knob);
}

} // namespace trembler::budget
