// The magnetism knob: grid with its cutoff, tree with its opening angle, all pairs; each may be computed once
// in several frames.
#include "game/budget/force_sample.hpp"
#include "game/budget/knobs.hpp"
#include "game/budget/making_options.hpp"
#include "game/budget/tree_sample.hpp"
#include "physics/magnetism/magnetic_grid.hpp"
#include "physics/magnetism/magnetic_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::budget {
namespace magnetism_knob {
namespace {

constexpr std::string_view effect = "magnetism";

struct Scene {
    Sample sample;
    std::vector<SampledSum> sums;
    double poles = 0; ///< number of sources and of the bodies that they attract
};

Scene lookAt(World const& world, TreeSample& tree) {
    static Column<Rotation> const noRotations;
    static Column<Velocity> const noVelocities;
    static Column<AngularVelocity> const noSpins;
    static Column<Shape> const noShapes;
    static Column<MagneticPoles> const noPoles;
    static Column<Mass> const noMasses;
    auto const orNone = [](auto const* column, auto const& none) -> auto const& {
        return column == nullptr ? none : *column;
    };
    Store const& store = world.store();
    auto const* const positions = store.findColumn<Position>();
    auto const* const strengths = store.findColumn<MagneticStrength>();
    auto const* const magnets = store.findColumn<Magnet>();
    Scene scene;
    if (positions == nullptr || strengths == nullptr || magnets == nullptr) {
        return scene;
    }
    scene.sample = sampleOf(world, [&](ObjectId id) { return strengths->has(id) && positions->has(id); });
    MagneticPoints points;
    points.gather({*positions, orNone(store.findColumn<Rotation>(), noRotations),
                   orNone(store.findColumn<Velocity>(), noVelocities),
                   orNone(store.findColumn<AngularVelocity>(), noSpins),
                   orNone(store.findColumn<Mass>(), noMasses), orNone(store.findColumn<Shape>(), noShapes),
                   orNone(store.findColumn<MagneticPoles>(), noPoles), *strengths, *magnets},
                  0);
    for (MagneticSum const which :
         {MagneticSum::polesOnPoles, MagneticSum::softOnPoles, MagneticSum::polesOnSoft}) {
        SampledSum sum;
        sum.softening2 = magneticSoftening * magneticSoftening;
        sum.sources = points.sources(which);
        sum.receive(points.receivers(which), scene.sample);
        tree.add(sum.sources, points.receivers(which), true, sum.softening2);
        scene.sums.push_back(std::move(sum));
    }
    scene.poles = static_cast<double>(points.sources(MagneticSum::polesOnPoles).size() +
                                      points.sources(MagneticSum::softOnPoles).size());
    return scene;
}

/// The mean number of sources in the nine cells around a receiver; a cell is as wide as the cutoff.
double neighbours(Scene const& scene, double cutoff) {
    double found = 0;
    double receivers = 0;
    for (SampledSum const& sum : scene.sums) {
        for (std::size_t i = 0; i < sum.receivers.size(); ++i) {
            for (std::size_t j = 0; j < sum.sources.size(); ++j) {
                bool const near = std::abs(sum.sources.x[j] - sum.receivers.x[i]) < 1.5 * cutoff &&
                                  std::abs(sum.sources.y[j] - sum.receivers.y[i]) < 1.5 * cutoff;
                found += near ? 1 : 0;
            }
            ++receivers;
        }
    }
    return receivers > 0 ? found / receivers : 0;
}

// µs on the machine of docs/measurements/accuracy.md, 2000 poles; only the ratios matter.
double workOfPairs(double n) {
    return 0.1 + 2.5e-3 * n * n;
}
double workOfTree(double n, double angle) {
    double const each = 0.7 + 0.35 / std::max(angle, 0.1);
    return 0.1 + 0.05 * n + std::min(n * each * std::log2(n + 2) / 11, workOfPairs(n));
}
double workOfGrid(double n, double near) {
    return 0.1 + 0.3 * n + 2.5e-3 * n * near;
}

} // namespace
} // namespace magnetism_knob

std::optional<Knob> magnetismKnob(World const& world) {
    using namespace magnetism_knob;
    auto const levels = levelsOf(world, effect);
    auto const now = working(levels);
    if (!now) {
        return std::nullopt;
    }
    TreeSample tree(world);
    Scene const scene = lookAt(world, tree);
    auto const settings = settingsOf<MagnetismSettings>(world);
    std::vector<Vec2> const right = forcesOn(scene.sample, scene.sums, addPairs);

    Knob knob;
    knob.effect = effect;
    knob.of = "of the force";
    knob.source = fmt::format("Measured on {} bodies, against the sum over all pairs of poles.",
                              scene.sample.bodies.size());
    std::string const nowLevel(now->info->text.level);
    Staleness stale(world, scene.sample, scene.sums, right);
    auto const add = [&](ComponentStatus const& level, Option made, Error const& error, bool current) {
        std::string const component = title(*level.info);
        bool const isNow = level.info == now->info && current;
        made.makes.insert(made.makes.begin(), toLevel(effect, level.info->text.level));
        for (int const period : withCurrent(std::vector<int>{1, 2, 4}, isNow ? now->period : 1)) {
            Option option = made;
            runEvery(option, component, period);
            option.error = together(error, stale.of(period));
            if (isNow && period == now->period) {
                knob.current = knob.options.size();
            }
            knob.options.push_back(std::move(option));
        }
    };
    std::string_view const key = MagnetismSettings::text.key;
    auto const* const strengths = world.store().findColumn<MagneticStrength>();
    for (ComponentStatus const& level : levels) {
        std::string const name(level.info->text.level);
        knob.components.push_back(title(*level.info));
        if (name == "tree") {
            for (double const angle : withCurrent({0.15, 0.25, 0.35, 0.5, 0.7}, settings.openingAngle)) {
                add(level,
                    {fmt::format("tree, opening angle {:g}", angle),
                     {toSetting(key, "opening_angle", angle)},
                     workOfTree(scene.poles, angle),
                     {},
                     {}},
                    tree.errorAt(angle), angle == settings.openingAngle);
            }
        } else if (name == "grid") {
            for (double const asked : withCurrent({1.0, 2.0, 4.0, 8.0}, settings.cutoff)) {
                MagnetismSettings so = settings;
                so.cutoff = asked;
                double const cutoff = magneticCutoff(so, *strengths);
                add(level,
                    {asked > 0 ? fmt::format("grid, cutoff {:g} m", asked)
                               : fmt::format("grid, cutoff {:.2g} m by the force threshold", cutoff),
                     {toSetting(key, "cutoff", asked)},
                     workOfGrid(scene.poles, neighbours(scene, cutoff)),
                     {},
                     {}},
                    errorOf(scene.sample,
                            forcesOn(scene.sample, scene.sums, byGrid(fullShareOfCutoff * cutoff, cutoff)),
                            right),
                    asked == settings.cutoff);
            }
        } else {
            add(level, {name, {}, workOfPairs(scene.poles), {}, {}}, {}, true);
        }
    }
    return knob;
}

} // namespace trembler::budget
