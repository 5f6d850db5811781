#include "tests/physics/dynamics/scene.hpp"

#include <algorithm>

namespace trembler::test {

std::vector<std::string> engines() {
    Registry registry;
    registerScene(registry);
    std::vector<std::string> found;
    for (Registration const& registration : registry.components()) {
        ComponentText const& text = registration.info->text;
        if (text.effect == "dynamics" && !text.level.empty() && registration.missing.empty()) {
            found.emplace_back(text.level);
        }
    }
    return found;
}

std::string& engineUnderTest() {
    static std::string engine = "box2d";
    return engine;
}

void DynamicsFromPull::apply(Access& access) {
    auto const& pulls = access.read<Pull>();
    auto const& masses = access.read<Mass>();
    for (std::size_t row = 0; row < pulls.size(); ++row) {
        ObjectId const id = pulls.owners()[row];
        Pull const& pull = pulls.values()[row];
        Mass const* const mass = masses.find(id);
        access.call(AddForce{id, pull.force + (mass == nullptr ? 0 : mass->value) * pull.acceleration});
        access.call(AddForceToPoint{id, pull.point, pull.pointForce});
        access.call(AddTorque{id, pull.torque});
    }
}

void DynamicsFromKick::apply(Access& access) {
    auto const& kicks = access.read<Kick>();
    for (std::size_t row = 0; row < kicks.size(); ++row) {
        Kick const& kick = kicks.values()[row];
        int& seen = seen_[kicks.owners()[row]];
        if (seen != kick.serial) {
            seen = kick.serial;
            access.call(AddImpulse{kicks.owners()[row], kick.point, kick.impulse});
        }
    }
}

void registerScene(Registry& registry) {
    registerRuntime(registry);
    registerDynamics(registry);
    registry.component<DynamicsFromPull>();
    registry.component<DynamicsFromKick>();
}

Scene::Scene(Options options) {
    registerScene(registry);
    if (options.extend != nullptr) {
        options.extend(registry);
    }
    world = std::make_unique<World>(registry, WorldOptions{.threads = options.threads,
                                                           .detail = {{"dynamics", engineUnderTest()}},
                                                           .periods = {},
                                                           .trace = options.trace});
    give(world->store().create("world"), options.solver);
}

ObjectId Scene::ball(Vec2 at, double radius) {
    return body("ball " + std::to_string(world->store().objects().size()), circlePiece(radius), at);
}

ObjectId Scene::body(std::string const& name, Shape shape, Vec2 at, double angle) {
    ObjectId const id = world->store().create(name);
    give(id, std::move(shape));
    give(id, Position{at});
    give(id, Rotation{angle});
    Pull pull;
    pull.acceleration = {0, -gravity};
    give(id, pull);
    return id;
}

ObjectId Scene::body(std::string const& name, ShapePiece piece, Vec2 at, double angle) {
    return body(name, Shape{{std::move(piece)}}, at, angle);
}

ObjectId Scene::fixed(std::string const& name, ShapePiece piece, Vec2 at, double angle) {
    ObjectId const id = world->store().create(name);
    give(id, Shape{{std::move(piece)}});
    give(id, Position{at});
    give(id, Rotation{angle});
    give(id, Fixed{});
    return id;
}

ObjectId Scene::joint(std::string const& name, Joint joint) {
    ObjectId const id = world->store().create(name);
    give(id, joint);
    return id;
}

void Scene::run(int frames) {
    if (!started_) {
        world->start();
        started_ = true;
    }
    for (int frame = 0; frame < frames; ++frame) {
        world->step();
    }
}

bool Scene::touching(ObjectId a, ObjectId b) const {
    TouchingPair const pair = a < b ? TouchingPair{a, b, {}} : TouchingPair{b, a, {}};
    return std::binary_search(contacts().current.begin(), contacts().current.end(), pair);
}

Activity Scene::dynamics() const {
    for (ComponentStatus const& status : world->status()) {
        if (status.info->kind == ComponentKind::resolver && status.info->roleName == "Dynamics") {
            if (status.activity != Activity::absent) {
                return status.activity;
            }
        }
    }
    return Activity::absent;
}

} // namespace trembler::test
