// Gravity ladders: linear, tree and real, against the sum over all pairs in long double.
#include "measure/accuracy/ladder.hpp"
#include "measure/accuracy/ladders/effect_clock.hpp"
#include "measure/accuracy/ladders/vector_error.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/gravity/register.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace trembler::accuracy {
namespace {

struct Scene {
    std::vector<double> masses; ///< kg
    std::vector<Vec2> places;   ///< m
    GravityLaw law;
    Vec2 linear; ///< m/s², the uniform field set for linear gravity
    /// Number of objects at the beginning to exclude from the error: the planet itself is not subject to the
    /// linear field that replaces it.
    std::size_t skipped = 0;
};

// A disc of stars on a sunflower spiral, denser towards its middle, with a heavy star there.
Scene galaxy(int count) {
    Scene scene;
    scene.law = {1, 0.1, 0.35};
    for (int i = 0; i < count; ++i) {
        double const radius = 50 * std::pow(static_cast<double>(i) / count, 0.8);
        double const angle = i * pi * (3 - std::sqrt(5.0));
        scene.masses.push_back(i == 0 ? 1e4 : 1.0 + i % 5);
        scene.places.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return scene;
}

// Objects of a few kilograms up to 50 m above the ground of a planet of 6371 km radius, as on Earth.
Scene onTheGround(int count) {
    constexpr double radius = 6.371e6;
    Scene scene;
    scene.law = {6.6743e-11, 0.01, 0.35};
    scene.masses.push_back(earthGravity * radius * radius / scene.law.constant);
    scene.places.push_back({0, -radius});
    scene.skipped = 1;
    scene.linear = {0, -earthGravity};
    for (int i = 1; i < count; ++i) {
        scene.masses.push_back(0.1 + i % 7);
        scene.places.push_back({0.37 * (i % 20), 0.5 + (i * 31 % 100) * 0.5});
    }
    return scene;
}

std::vector<Vec2> reference(Scene const& scene) {
    std::vector<Vec2> forces;
    long double const softening2 = static_cast<long double>(scene.law.softening) * scene.law.softening;
    for (std::size_t i = 0; i < scene.masses.size(); ++i) {
        long double x = 0;
        long double y = 0;
        for (std::size_t j = 0; j < scene.masses.size(); ++j) {
            long double const rx = static_cast<long double>(scene.places[j].x) - scene.places[i].x;
            long double const ry = static_cast<long double>(scene.places[j].y) - scene.places[i].y;
            long double const d = std::sqrt(rx * rx + ry * ry + softening2);
            long double const pull = scene.law.constant * scene.masses[i] * scene.masses[j] / (d * d * d);
            x += pull * rx;
            y += pull * ry;
        }
        forces.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
    return forces;
}

Registry const& gravityAlone() {
    static Registry const registry = [] {
        Registry made;
        registerRuntime(made);
        registerGravity(made);
        return made;
    }();
    return registry;
}

Rung measure(Scene const& scene, std::vector<Vec2> const& right, std::string const& name,
             std::string const& level, double openingAngle, int frames) {
    World world(gravityAlone(), {.threads = 1, .detail = {{"gravity", level}}, .periods = {}});
    Store& store = world.store();
    ObjectId const settings = store.create("world");
    GravityLaw law = scene.law;
    law.openingAngle = openingAngle;
    store.column<GravityLaw>().set(settings, law);
    store.column<GravityField>().set(settings, {scene.linear});
    ObjectId first;
    for (std::size_t i = 0; i < scene.masses.size(); ++i) {
        ObjectId const id = store.create("mass " + std::to_string(i));
        first = i == 0 ? id : first;
        store.column<Mass>().set(id, {scene.masses[i]});
        store.column<Position>().set(id, {scene.places[i]});
    }
    world.start();
    EffectClock clock("gravity");
    for (int frame = 0; frame < frames; ++frame) {
        // Marks the column as changed, as if an object had moved.
        store.column<Position>().set(first, {scene.places[0]});
        store.column<Mass>().set(first, {scene.masses[0]});
        world.step();
        clock.frame(world);
    }
    std::vector<Vec2> forces;
    for (GravityForce::Entry const& entry : world.find<GravityForce>()->forces) {
        forces.push_back(entry.force);
    }
    return {name, clock.median(), relativeError(forces, right, scene.skipped), {}, false, {}};
}

Ladder climbGravity(Scene const& scene, std::string name, bool angles, int frames) {
    Ladder ladder;
    ladder.scene = std::move(name);
    ladder.unit = "of the force";
    ladder.error = "root of the mean squared error of all forces, relative to that of the forces";
    ladder.reference = "every pair, in long double";
    auto const right = reference(scene);
    ladder.rungs.push_back(measure(scene, right, "linear", "linear", 0, frames));
    for (double const angle : {0.7, 0.5, 0.35, 0.25, 0.15}) {
        if (angles || angle == 0.35) {
            ladder.rungs.push_back(
                measure(scene, right, fmt::format("tree, opening angle {}", angle), "tree", angle, frames));
        }
    }
    ladder.rungs.push_back(measure(scene, right, "real", "real", 0, frames));
    ladder.remark =
        angles ? "The tree is faster than the sum over all pairs from some hundreds of masses on, and a "
                 "scene uses "
                 "it from 2000 on (bench_many_bodies)."
               : "Near the ground the error of linear gravity is the decrease of weight with height.";
    return ladder;
}

} // namespace

void addGravityPlans(std::vector<Plan>& plans) {
    plans.push_back({"gravity", [](GameData const&, Effort effort) {
                         int const count = effort.brief ? 150 : 2000;
                         return climbGravity(galaxy(count), fmt::format("a disc of {} stars", count), true,
                                             effort.brief ? 25 : 121);
                     }});
    plans.push_back({"gravity", [](GameData const&, Effort effort) {
                         int const count = effort.brief ? 20 : 200;
                         return climbGravity(onTheGround(count), fmt::format("{} things on Earth", count - 1),
                                             false, effort.brief ? 25 : 601);
                     }});
}

} // namespace trembler::accuracy
