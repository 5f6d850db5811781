#include "measure/accuracy/ladders/dynamics_scenes.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::accuracy {
namespace {

constexpr double g = earthGravity;

std::unique_ptr<World> emptyWorld(GameData const& gameData, Solver const& solver) {
    WorldOptions options;
    options.detail["dynamics"] = solver.engine;
    auto world = std::make_unique<World>(gameData.registry, options);
    Store& store = world->store();
    ObjectId const settings = store.create("world");
    store.column<DynamicsSettings>().set(settings, solver.settings);
    store.column<GravityField>().set(settings, {{0, -g}});
    return world;
}

ObjectId body(World& world, std::string const& name, ShapePiece piece, Vec2 at, double mass) {
    Store& store = world.store();
    ObjectId const id = store.create(name);
    store.column<Shape>().set(id, {{std::move(piece)}});
    store.column<Position>().set(id, {at});
    store.column<Rotation>().set(id, {0});
    store.column<Mass>().set(id, {mass});
    return id;
}

ObjectId hinge(World& world, std::string const& name, ObjectId a, ObjectId b, Vec2 at) {
    Joint joint;
    joint.form = JointForm::hinge;
    joint.a = a;
    joint.b = b;
    joint.at = at;
    ObjectId const id = world.store().create(name);
    world.store().column<Joint>().set(id, joint);
    return id;
}

Vec2 placeOf(World const& world, ObjectId id) {
    return world.find<Position>(id)->value;
}

// Where the point `local` (m, in the body's coordinates) of a body is now.
Vec2 carried(World const& world, ObjectId id, Vec2 local) {
    return placeOf(world, id) + rotated(local, world.find<Rotation>(id)->angle);
}

constexpr double linkLength = 0.3;
constexpr double linkWidth = 0.08;
constexpr double linkMass = 1;

std::string linkName(int i) {
    return fmt::format("link {:03}", i);
}

} // namespace

// Interactions make their first calls at the end of the first frame, so gravity acts from the second on: time
// counts from there.
DynamicsScene thrownBall(GameData const& gameData, Solver const& solver) {
    DynamicsScene scene{emptyWorld(gameData, solver), {}};
    ObjectId const ball = body(*scene.world, "ball", circlePiece(0.1), {0, 0}, 1);
    Vec2 const velocity{4, 9};
    scene.world->store().column<Velocity>().set(ball, {velocity});
    scene.error = [ball, velocity](World const& world, int frame) {
        double const fallen = (frame - 1) * frameDuration;
        Vec2 const right = frame * frameDuration * velocity - Vec2{0, g / 2 * fallen * fallen};
        return length(placeOf(world, ball) - right);
    };
    return scene;
}

DynamicsScene pendulum(GameData const& gameData, Solver const& solver) {
    constexpr double arm = 1.5;    // m
    constexpr double radius = 0.2; // m
    constexpr double amplitude = 1.5;
    DynamicsScene scene{emptyWorld(gameData, solver), {}};
    ObjectId const bob = body(*scene.world, "bob", circlePiece(radius),
                              {arm * std::sin(amplitude), -arm * std::cos(amplitude)}, 1);
    hinge(*scene.world, "pivot", bob, {}, {0, 0});
    // θ'' = -g L sin θ / (r²/2 + L²), by the classical fourth-order Runge-Kutta method in 500 steps a frame.
    struct Motion {
        double angle = amplitude;
        double speed = 0;
    };
    auto const motion = std::make_shared<Motion>();
    scene.error = [bob, motion](World const& world, int frame) {
        constexpr int steps = 500;
        constexpr double factor = g * arm / (radius * radius / 2 + arm * arm);
        double const h = frameDuration / steps;
        auto const pull = [](double angle) { return -factor * std::sin(angle); };
        for (int i = 0; i < steps && frame > 1; ++i) {
            double const a = motion->angle;
            double const v = motion->speed;
            double const k1 = pull(a);
            double const k2 = pull(a + h / 2 * v);
            double const k3 = pull(a + h / 2 * (v + h / 2 * k1));
            double const k4 = pull(a + h * (v + h / 2 * k2));
            motion->angle = a + h * v + h * h / 6 * (k1 + k2 + k3);
            motion->speed = v + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        Vec2 const right{arm * std::sin(motion->angle), -arm * std::cos(motion->angle)};
        return length(placeOf(world, bob) - right);
    };
    return scene;
}

DynamicsScene loadedChain(GameData const& gameData, Solver const& solver, int links, double ballMass) {
    DynamicsScene scene{emptyWorld(gameData, solver), {}};
    World& world = *scene.world;
    struct Pin {
        ObjectId a;
        Vec2 localA;
        ObjectId b; ///< invalid: the world, at localB
        Vec2 localB;
    };
    std::vector<Pin> pins;
    ObjectId before;
    Vec2 beforeAt;
    for (int i = 0; i < links; ++i) {
        Vec2 const at{(i + 0.5) * linkLength, 0};
        Vec2 const joint{i * linkLength, 0};
        ObjectId const link = body(world, linkName(i), boxPiece(linkLength, linkWidth), at, linkMass);
        hinge(world, fmt::format("pin {:03}", i), link, before, joint);
        pins.push_back({link, joint - at, before, before.valid() ? joint - beforeAt : joint});
        before = link;
        beforeAt = at;
    }
    Vec2 const end{links * linkLength, 0};
    hinge(world, "last pin", before, {}, end);
    pins.push_back({before, end - beforeAt, {}, end});
    Vec2 const middle{links / 2 * linkLength, 0};
    ObjectId const held = world.store().find(linkName(links / 2));
    Vec2 const heldAt = world.store().column<Position>()[held].value;
    Vec2 const ballAt = middle - Vec2{0, 0.5};
    ObjectId const ball = body(world, "weight", circlePiece(0.3), ballAt, ballMass);
    hinge(world, "weight pin", ball, held, middle);
    pins.push_back({ball, middle - ballAt, held, middle - heldAt});
    scene.error = [pins](World const& after, int) {
        double widest = 0;
        for (Pin const& pin : pins) {
            Vec2 const other = pin.b.valid() ? carried(after, pin.b, pin.localB) : pin.localB;
            widest = std::max(widest, length(carried(after, pin.a, pin.localA) - other));
        }
        return widest;
    };
    return scene;
}

DynamicsScene stack(GameData const& gameData, Solver const& solver, int boxes) {
    Solver awake = solver;
    awake.settings.sleeping = false;
    DynamicsScene scene{emptyWorld(gameData, awake), {}};
    ObjectId const floor = body(*scene.world, "floor", boxPiece(20, 1), {0, -0.5}, 1);
    scene.world->store().column<Fixed>().set(floor, {});
    std::vector<std::pair<ObjectId, Vec2>> all;
    for (int i = 0; i < boxes; ++i) {
        Vec2 const at{0, 0.5 + i};
        all.emplace_back(body(*scene.world, fmt::format("box {:02}", i), boxPiece(1, 1), at, 100), at);
    }
    scene.error = [all](World const& world, int) {
        double farthest = 0;
        for (auto const& [box, at] : all) {
            farthest = std::max(farthest, std::abs(placeOf(world, box).x - at.x));
        }
        return farthest;
    };
    return scene;
}

DynamicsScene fallingChain(GameData const& gameData, Solver const& solver, int links,
                           std::shared_ptr<ChainPath> path, bool record) {
    DynamicsScene scene{emptyWorld(gameData, solver), {}};
    std::vector<ObjectId> all;
    for (int i = 0; i < links; ++i) {
        Vec2 const at{(i + 0.5) * linkLength, 0};
        ObjectId const link = body(*scene.world, linkName(i), boxPiece(linkLength, linkWidth), at, linkMass);
        hinge(*scene.world, fmt::format("pin {:03}", i), link, all.empty() ? ObjectId{} : all.back(),
              {i * linkLength, 0});
        all.push_back(link);
    }
    scene.error = [all, path = std::move(path), record](World const& world, int frame) {
        if (record) {
            path->places.emplace_back();
            for (ObjectId const link : all) {
                path->places.back().push_back(placeOf(world, link));
            }
            return 0.0;
        }
        double farthest = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            Vec2 const right = path->places[static_cast<std::size_t>(frame - 1)][i];
            farthest = std::max(farthest, length(placeOf(world, all[i]) - right));
        }
        return farthest;
    };
    return scene;
}

} // namespace trembler::accuracy
