// Small worlds with liquids for tests.
#pragma once

#include "physics/buoyancy/core/liquid_drag.hpp"
#include "physics/buoyancy/properties/air.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/buoyancy/properties/settings.hpp"
#include "physics/buoyancy/register.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/register.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/gravity/register.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"

#include <memory>
#include <string>

namespace trembler::test {

/// A world with dynamics, gravity and buoyancy only.
class Pool {
public:
    struct Options {
        std::string detail = "exact"; ///< of buoyancy
        std::string engine = {};      ///< of dynamics; empty: the default
        Vec2 gravity{0, -9.81};
        DynamicsSettings solver = {};
        BuoyancySettings buoyancy = {};
        int threads = 1;
        bool trace = false;
        int period = 1; ///< of the Buoyancy resolver
    };
    Pool() : Pool(Options{}) {}
    explicit Pool(Options options);

    /// A body of liquid; its density in kg/m³.
    ObjectId liquid(std::string const& name, ShapePiece piece, Vec2 at, double density = 1000,
                    Liquid liquid = {}, double angle = 0);
    /// Water with its surface at y = 0, 100 m wide and 50 m deep.
    ObjectId water(Liquid properties = {}) {
        return liquid("water", boxPiece(100, 50), {0, -25}, 1000, properties);
    }
    ObjectId body(std::string const& name, Shape shape, Vec2 at, double density, double angle = 0);
    ObjectId body(std::string const& name, ShapePiece piece, Vec2 at, double density, double angle = 0) {
        return body(name, Shape{{std::move(piece)}}, at, density, angle);
    }
    ObjectId fixed(std::string const& name, ShapePiece piece, Vec2 at, double angle = 0);
    ObjectId joint(std::string const& name, Joint joint);
    template <class P>
    void give(ObjectId id, P property) {
        world->store().column<P>().set(id, std::move(property));
    }
    /// Removes the effect of air on the bodies; without this, light ones rise in the air of the Earth.
    void withoutAir() { give(world->store().find("world"), Air{.density = 0}); }
    /// Runs frames; the first call starts the world.
    void run(int frames);
    void seconds(double time) { run(static_cast<int>(std::lround(time * 60))); }

    [[nodiscard]] Vec2 at(ObjectId id) const { return world->find<Position>(id)->value; }
    [[nodiscard]] Vec2 velocity(ObjectId id) const { return world->find<Velocity>(id)->value; }
    [[nodiscard]] double angle(ObjectId id) const { return world->find<Rotation>(id)->angle; }
    [[nodiscard]] double spin(ObjectId id) const { return world->find<AngularVelocity>(id)->value; }
    [[nodiscard]] double mass(ObjectId id) const { return world->find<Mass>(id)->value; }
    /// The force F_B in N; zero if there is none.
    [[nodiscard]] Vec2 force(ObjectId id) const;
    /// The centre of buoyancy in the world; the object must have one.
    [[nodiscard]] Vec2 centre(ObjectId id) const;
    [[nodiscard]] Activity activity(std::string const& component) const;

    Registry registry;
    std::unique_ptr<World> world;

private:
    bool started_ = false;
};

} // namespace trembler::test
