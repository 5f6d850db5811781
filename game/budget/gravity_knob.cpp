// The gravity knob: linear, tree with its opening angle, real; each may be computed once in several frames.
#include "game/budget/force_sample.hpp"
#include "game/budget/knobs.hpp"
#include "game/budget/making_options.hpp"
#include "game/budget/tree_sample.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::budget {
namespace gravity_knob {
namespace {

constexpr std::string_view effect = "gravity";

// µs on the machine of docs/measurements/accuracy.md; only the ratios matter.
double workOfPairs(double n) {
    return 2.1e-3 * n * n;
}
double workOfTree(double n, double angle) {
    double const each = 0.55 + 0.33 / std::max(angle, 0.1); // 2000 stars
    return 0.05 * n + std::min(n * each * std::log2(n + 2) / 11, workOfPairs(n));
}
double workOfLinear(double n) {
    return 0.02 + 5.3e-4 * n;
}

SampledSum sumOf(World const& world, GravityLaw const& law, Sample const& sample, TreeSample& tree) {
    SampledSum sum;
    sum.softening2 = law.softening * law.softening;
    inverse_square::Points all;
    auto const* const masses = world.store().findColumn<Mass>();
    auto const* const positions = world.store().findColumn<Position>();
    if (masses != nullptr && positions != nullptr) {
        forEach(
            [&](ObjectId id, Mass const& mass, Position const& position) {
                sum.sources.add(position.value, mass.value, id.index);
                all.add(position.value, law.constant * mass.value, id.index);
            },
            *masses, *positions);
    }
    sum.receive(all, sample);
    tree.add(sum.sources, all, false, sum.softening2);
    return sum;
}

} // namespace
} // namespace gravity_knob

std::optional<Knob> gravityKnob(World const& world) {
    using namespace gravity_knob;
    auto const levels = levelsOf(world, effect);
    auto const now = working(levels);
    if (!now) {
        return std::nullopt;
    }
    GravityLaw const law = settingsOf<GravityLaw>(world);
    bool const isLaw = std::any_of(levels.begin(), levels.end(),
                                   [](ComponentStatus const& s) { return s.info->text.level == "real"; });
    auto const* const positions = world.store().findColumn<Position>();
    Sample const sample =
        sampleOf(world, [&](ObjectId id) { return positions != nullptr && positions->has(id); });
    std::vector<SampledSum> sums;
    TreeSample tree(world);
    std::vector<Vec2> right;
    std::vector<Vec2> linear;
    for (Sample::Body const& body : sample.bodies) {
        linear.push_back(body.mass * settingsOf<GravityField>(world).acceleration);
    }
    if (isLaw) {
        sums.push_back(sumOf(world, law, sample, tree));
        right = forcesOn(sample, sums, addPairs);
    } else {
        right = linear; // linear is the most exact level that this scene has
    }
    double const n = isLaw ? static_cast<double>(sums.front().sources.size())
                           : static_cast<double>(world.store().findColumn<Mass>()->size());

    Knob knob;
    knob.effect = effect;
    knob.of = "of the force";
    knob.source =
        isLaw ? fmt::format("Measured on {} masses, against the sum over all pairs.", sample.bodies.size())
              : "The world states no law of gravity, so linear gravity is exact.";
    Staleness stale(world, sample, sums, right);
    auto const add = [&](ComponentStatus const& level, Option const& made, Error const& error) {
        std::string const component = title(*level.info);
        bool const isNow = level.info == now->info;
        std::vector<int> const periods = !isLaw ? std::vector<int>{1} : std::vector<int>{1, 2, 4};
        for (int const period : withCurrent(periods, isNow ? now->period : 1)) {
            Option option = made;
            option.makes.insert(option.makes.begin(), toLevel(effect, level.info->text.level));
            runEvery(option, component, period);
            option.error = level.info->text.level == "linear" ? error : together(error, stale.of(period));
            bool const sameAngle =
                level.info->text.level != "tree" || option.makes[1].value == law.openingAngle;
            if (isNow && period == now->period && sameAngle) {
                knob.current = knob.options.size();
            }
            knob.options.push_back(std::move(option));
        }
    };
    for (ComponentStatus const& level : levels) {
        std::string const name(level.info->text.level);
        knob.components.push_back(title(*level.info));
        if (name == "tree") {
            for (double const angle : withCurrent({0.15, 0.25, 0.35, 0.5, 0.7}, law.openingAngle)) {
                Error const error = tree.errorAt(angle);
                add(level,
                    {fmt::format("tree, opening angle {:g}", angle),
                     {toSetting(GravityLaw::text.key, "opening_angle", angle)},
                     workOfTree(n, angle),
                     {},
                     {}},
                    error);
            }
        } else if (name == "linear") {
            add(level, {name, {}, workOfLinear(n), {}, {}}, errorOf(sample, linear, right));
        } else {
            add(level, {name, {}, workOfPairs(n), {}, {}}, {});
        }
    }
    return knob;
}

} // namespace trembler::budget
