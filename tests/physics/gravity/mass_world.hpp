// A world of masses with forces of gravity, but without motion.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/gravity/register.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"

#include <string>
#include <vector>

namespace trembler::test {

inline Registry const& gravityOnly() {
    static Registry const registry = [] {
        Registry made;
        registerRuntime(made);
        registerGravity(made);
        return made;
    }();
    return registry;
}

/// Masses and a law of gravity, without Dynamics.
struct MassWorld {
    explicit MassWorld(int threads = 1)
        : world(gravityOnly(), {.threads = threads, .detail = {}, .periods = {}}) {}
    ObjectId mass(double kilograms, Vec2 at = {}) {
        ObjectId const id = world.store().create("mass " + std::to_string(world.store().objects().size()));
        world.store().column<Position>().set(id, {at});
        world.store().column<Mass>().set(id, {kilograms});
        return id;
    }
    void linear(Vec2 acceleration) {
        world.store().column<GravityField>().set(world.store().create("field"), {acceleration});
    }
    void real(double constant, double softening) {
        world.store().column<GravityLaw>().set(world.store().create("law"), {constant, softening});
    }
    std::vector<GravityForce::Entry> const& forces() {
        world.start();
        world.step();
        return world.find<GravityForce>()->forces;
    }
    World world;
};

} // namespace trembler::test
