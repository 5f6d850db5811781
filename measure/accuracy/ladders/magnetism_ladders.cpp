// Magnetism ladders: grid, tree and pairwise, against the sum over all pairs in long double; and poles
// against point dipoles.
#include "measure/accuracy/ladder.hpp"
#include "measure/accuracy/ladders/effect_clock.hpp"
#include "measure/accuracy/ladders/vector_error.hpp"
#include "physics/dynamics/properties/standstill.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/magnetism/register.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace trembler::accuracy {
namespace {

struct Bar {
    Vec2 at;             ///< m
    double angle = 0;    ///< rad
    double strength = 0; ///< A m
    PoleSet poles = PoleSet::both;
};
constexpr double half = 0.1; // m, from the middle of a bar to its pole

// Magnets on a sunflower spiral, half a metre apart.
std::vector<Bar> field(int count, PoleSet poles) {
    std::vector<Bar> bars;
    for (int i = 0; i < count; ++i) {
        double const radius = 0.5 * std::sqrt(static_cast<double>(i));
        double const angle = i * pi * (3 - std::sqrt(5.0));
        bars.push_back(
            {{radius * std::cos(angle), radius * std::sin(angle)}, 1.7 * i, 100.0 + i % 50, poles});
    }
    return bars;
}

struct Pole {
    std::size_t bar;
    Vec2 at;
    double q;
};

std::vector<Pole> polesOf(std::vector<Bar> const& bars) {
    std::vector<Pole> poles;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        Vec2 const end = rotated({half, 0}, bars[i].angle);
        poles.push_back({i, bars[i].at + end, bars[i].strength});
        if (bars[i].poles == PoleSet::both) {
            poles.push_back({i, bars[i].at - end, -bars[i].strength});
        }
    }
    return poles;
}

std::vector<Vec2> reference(std::vector<Bar> const& bars) {
    std::vector<Pole> const poles = polesOf(bars);
    std::vector<Vec2> forces;
    for (Pole const& on : poles) {
        long double x = 0;
        long double y = 0;
        for (Pole const& from : poles) {
            if (from.bar != on.bar) {
                long double const rx = static_cast<long double>(from.at.x) - on.at.x;
                long double const ry = static_cast<long double>(from.at.y) - on.at.y;
                long double const d = std::sqrt(
                    rx * rx + ry * ry + static_cast<long double>(magneticSoftening * magneticSoftening));
                long double const push = -1e-7L * on.q * from.q / (d * d * d);
                x += push * rx;
                y += push * ry;
            }
        }
        forces.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
    return forces;
}

Registry const& magnetismAlone() {
    static Registry const registry = [] {
        Registry made;
        registerRuntime(made);
        registerMagnetism(made);
        made.component<Standstill>();
        return made;
    }();
    return registry;
}

struct Run {
    double microseconds = 0;
    std::vector<Vec2> forces; ///< by pole
};

Run run(std::vector<Bar> const& bars, std::string const& level, MagnetismSettings settings, int frames) {
    World world(magnetismAlone(), {.threads = 1, .detail = {{"magnetism", level}}, .periods = {}});
    Store& store = world.store();
    store.column<MagnetismSettings>().set(store.create("world"), settings);
    ObjectId first;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        ObjectId const id = store.create("bar " + std::to_string(i));
        first = i == 0 ? id : first;
        store.column<Position>().set(id, {bars[i].at});
        store.column<Rotation>().set(id, {bars[i].angle});
        store.column<MagneticStrength>().set(id, {bars[i].strength, 0});
        store.column<MagneticPoles>().set(id, {bars[i].poles, {half, 0}, {-half, 0}});
    }
    world.start();
    EffectClock clock("magnetism");
    for (int frame = 0; frame < frames; ++frame) {
        // Marks the column as changed, as if an object had moved.
        store.column<Position>().set(first, {bars[0].at});
        world.step();
        clock.frame(world);
    }
    Run found{clock.median(), {}};
    for (MagneticForce::Entry const& entry : world.find<MagneticForce>()->forces) {
        found.forces.push_back(entry.force);
    }
    return found;
}

Ladder climbField(std::vector<Bar> const& bars, std::string scene, std::string remark, Effort effort) {
    int const frames = effort.brief ? 25 : 121;
    Ladder ladder;
    ladder.scene = std::move(scene);
    ladder.unit = "of the force";
    ladder.error = "root of the mean squared error of all forces, relative to that of the forces";
    ladder.reference = "every pair of poles, in long double";
    auto const right = reference(bars);
    auto const add = [&](std::string name, std::string const& level, MagnetismSettings settings) {
        Run const found = run(bars, level, settings, frames);
        ladder.rungs.push_back(
            {std::move(name), found.microseconds, relativeError(found.forces, right), {}, false, {}});
    };
    for (double const cutoff : {1.0, 2.0, 4.0, 8.0}) {
        MagnetismSettings settings;
        settings.cutoff = cutoff;
        add(fmt::format("grid, cutoff {:g} m", cutoff), "grid", settings);
    }
    for (double const angle : {0.7, 0.5, 0.35, 0.25, 0.15}) {
        MagnetismSettings settings;
        settings.openingAngle = angle;
        add(fmt::format("tree, opening angle {}", angle), "tree", settings);
    }
    add("pairwise", "pairwise", {});
    ladder.remark = remark;
    return ladder;
}

// In line, at the distance r: point dipoles of the moment m attract each other with 3 µ0 m² / (2 π r⁴)
// (Griffiths, Introduction to Electrodynamics, 1999, problem 6.1). The bars have this moment, m = q l,
// whatever the distance l of their poles; a single pole has no moment and represents the pole of a bar of
// that length.
Ladder climbDipoles(Effort effort) {
    Ladder ladder;
    ladder.scene = "two bars in line";
    ladder.unit = "of the force";
    ladder.error = "relative difference of the force between two bars of two poles each, or of one";
    ladder.reference = "point dipoles of the same moment, 3 µ0 m² / (2 π r⁴)";
    ladder.rivals = false;
    ladder.remark =
        "Two poles at the ends of a bar of the length l pull harder than a point dipole of their moment, "
        "by 5/3 (l/r)² to first order: a real bar magnet is closer to the former. Below one length the "
        "two models have nothing in common. One pole alone is no magnet at any distance: its force falls "
        "with the square of the distance and not with the fourth power, and is (r/l)²/6 of the dipoles'.";
    constexpr double strength = 1e4;
    auto const add = [&](double lengths, PoleSet poles, char const* name) {
        double const r = lengths * 2 * half;
        std::vector<Bar> const bars{{{0, 0}, 0, strength, poles}, {{r, 0}, 0, strength, poles}};
        Run const found = run(bars, "pairwise", {}, effort.brief ? 25 : 601);
        double const moment = strength * 2 * half;
        double const dipoles = 3 * (4e-7 * pi) * moment * moment / (2 * pi * r * r * r * r);
        double force = found.forces[0].x;
        if (poles == PoleSet::both) {
            force += found.forces[1].x;
        }
        ladder.rungs.push_back({fmt::format("{}, {:g} lengths apart", name, lengths),
                                found.microseconds,
                                std::abs(std::abs(force) / dipoles - 1),
                                {},
                                false,
                                {}});
    };
    for (double const lengths : {1.5, 2.0, 3.0, 5.0, 10.0, 20.0}) {
        add(lengths, PoleSet::both, "two poles");
    }
    for (double const lengths : {1.5, 5.0, 20.0}) {
        add(lengths, PoleSet::north, "one pole");
    }
    return ladder;
}

} // namespace

void addMagnetismPlans(std::vector<Plan>& plans) {
    plans.push_back({"magnetism", [](GameData const&, Effort effort) {
                         int const count = effort.brief ? 100 : 1000;
                         return climbField(
                             field(count, PoleSet::both), fmt::format("{} bar magnets", count),
                             "Bars have hardly any far field, so a grid is sufficient. The two levels "
                             "overlap: a cutoff of 8 m takes longer than a tree of the same accuracy, and an "
                             "opening angle of 0.7 longer than a grid of 4 m, so neither is useful here.",
                             effort);
                     }});
    plans.push_back({"magnetism", [](GameData const&, Effort effort) {
                         int const count = effort.brief ? 100 : 2000;
                         return climbField(
                             field(count, PoleSet::north), fmt::format("{} single north poles", count),
                             "Where all poles have one sign, the far field is most of the force: a grid is "
                             "unsuitable for that, with any cutoff. Cells hardly larger than the magnets' "
                             "distance exclude few pairs and must be searched all the same, and an opening "
                             "angle of 0.7 saves hardly any time compared with 0.5.",
                             effort);
                     }});
    plans.push_back({"magnetism", [](GameData const&, Effort effort) { return climbDipoles(effort); }});
}

} // namespace trembler::accuracy
