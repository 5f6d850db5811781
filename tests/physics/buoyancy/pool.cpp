#include "tests/physics/buoyancy/pool.hpp"

#include <stdexcept>

namespace trembler::test {

Pool::Pool(Options options) {
    registerRuntime(registry);
    registerDynamics(registry);
    registerGravity(registry);
    registerBuoyancy(registry);
    std::map<std::string, std::string> detail{{"buoyancy", options.detail}};
    if (!options.engine.empty()) {
        detail["dynamics"] = options.engine;
    }
    world = std::make_unique<World>(registry, WorldOptions{.threads = options.threads,
                                                           .detail = detail,
                                                           .periods = {},
                                                           .trace = options.trace,
                                                           .rowsWorthThreads = 0});
    world->setPeriod(options.detail == "exact" ? "Buoyancy" : "Particle Buoyancy", options.period);
    ObjectId const id = world->store().create("world");
    give(id, GravityField{options.gravity});
    give(id, options.solver);
    give(id, options.buoyancy);
}

ObjectId Pool::liquid(std::string const& name, ShapePiece piece, Vec2 at, double density, Liquid liquid,
                      double angle) {
    ObjectId const id = world->store().create(name);
    give(id, Shape{{std::move(piece)}});
    give(id, Position{at});
    give(id, Rotation{angle});
    give(id, Density{density});
    give(id, liquid);
    return id;
}

ObjectId Pool::body(std::string const& name, Shape shape, Vec2 at, double density, double angle) {
    ObjectId const id = world->store().create(name);
    give(id, std::move(shape));
    give(id, Position{at});
    give(id, Rotation{angle});
    give(id, Density{density});
    return id;
}

ObjectId Pool::fixed(std::string const& name, ShapePiece piece, Vec2 at, double angle) {
    ObjectId const id = body(name, std::move(piece), at, 1000, angle);
    give(id, Fixed{});
    return id;
}

ObjectId Pool::joint(std::string const& name, Joint joint) {
    ObjectId const id = world->store().create(name);
    give(id, joint);
    return id;
}

void Pool::run(int frames) {
    if (!started_) {
        world->start();
        started_ = true;
    }
    for (int frame = 0; frame < frames; ++frame) {
        world->step();
    }
}

Vec2 Pool::force(ObjectId id) const {
    for (BuoyancyForce::Entry const& entry : world->find<BuoyancyForce>()->forces) {
        if (entry.object == id) {
            return entry.force;
        }
    }
    return {};
}

Vec2 Pool::centre(ObjectId id) const {
    for (CentreOfBuoyancy::Entry const& entry : world->find<CentreOfBuoyancy>()->centres) {
        if (entry.object == id) {
            return entry.world;
        }
    }
    throw std::logic_error("the object displaces nothing");
}

Activity Pool::activity(std::string const& component) const {
    for (ComponentStatus const& status : world->status()) {
        if (status.info->text.name == component) {
            return status.activity;
        }
    }
    throw std::logic_error("no component " + component);
}

} // namespace trembler::test
