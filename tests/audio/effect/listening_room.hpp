// Small worlds for tests in which objects fall, collide and sound.
#pragma once

#include "audio/effect/hearing/loudness.hpp"
#include "audio/effect/properties/decibel.hpp"
#include "audio/effect/properties/sounds.hpp"
#include "audio/effect/register.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/impacts.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/material.hpp"
#include "physics/register_physics.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <memory>
#include <string>

namespace trembler::test {

class ListeningRoom {
public:
    explicit ListeningRoom(WorldOptions options = {}) {
        registerEverything(registry);
        registerSound(registry);
        world = std::make_unique<World>(registry, std::move(options));
        give(world->store().create("world"), GravityField{{0, -9.81}});
    }

    template <class P>
    void give(ObjectId id, P property) {
        world->store().column<P>().set(id, std::move(property));
    }
    /// A body whose material determines only its sound: mass and surface are the defaults of objects without
    /// a material.
    ObjectId body(std::string const& name, Material material, ShapePiece piece, Vec2 at, double angle = 0) {
        ObjectId const id = surface(name, material, std::move(piece), at, angle);
        give(id, Density{});
        return id;
    }
    /// A fixed body, with the mass of objects without a material, by which it damps sound.
    ObjectId fixed(std::string const& name, Material material, ShapePiece piece, Vec2 at, double angle = 0) {
        double const mass = Density{}.value * areaOf(piece) * worldDepth;
        ObjectId const id = surface(name, material, std::move(piece), at, angle);
        give(id, Mass{mass});
        give(id, Fixed{});
        return id;
    }
    ObjectId ear(std::string const& name, Vec2 at) {
        ObjectId const id = world->store().create(name);
        give(id, Position{at});
        give(id, Ear{});
        return id;
    }
    /// Starts the world if needed and computes frames.
    void run(int frames) {
        start();
        for (int i = 0; i < frames; ++i) {
            world->step();
        }
    }
    void start() {
        if (!started_) {
            world->start();
            started_ = true;
        }
    }
    /// Runs until an impact is heard, but at most `frames`; returns whether one was heard.
    bool runToImpact(int frames = 600) {
        for (int i = 0; i < frames; ++i) {
            run(1);
            if (!sounds().impacts.empty()) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] Sounds const& sounds() const { return *world->find<Sounds>(); }
    [[nodiscard]] Sounds::Body const* sounding(ObjectId id) const {
        for (Sounds::Body const& body : sounds().bodies) {
            if (body.object == id) {
                return &body;
            }
        }
        return nullptr;
    }
    [[nodiscard]] double levelAt(ObjectId ear) const { return world->find<Loudness>()->at(ear); }
    [[nodiscard]] Activity of(std::string_view component) const {
        for (ComponentStatus const& status : world->status()) {
            if (status.info->text.name == component) {
                return status.activity;
            }
        }
        return Activity::absent;
    }

    Registry registry;
    std::unique_ptr<World> world;

private:
    ObjectId surface(std::string const& name, Material material, ShapePiece piece, Vec2 at, double angle) {
        ObjectId const id = world->store().create(name);
        give(id, Shape{{std::move(piece)}});
        give(id, Position{at});
        give(id, Rotation{angle});
        give(id, MadeOf{material});
        give(id, Friction{});
        give(id, Restitution{});
        return id;
    }
    bool started_ = false;
};

} // namespace trembler::test
