// Two scenes of Box2D's own testbed, on bare Box2D and in a Trembler world, where gravity is a separate
// effect, forces come from interactions, contacts are kept, and every property has its column. Both use the
// same substeps and iterations and produce bit for bit the same motion.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <box2d/box2d.h>

#include <ctime>
#include <string>
#include <vector>

namespace bench {

using namespace trembler;

struct Piece {
    Vec2 at;
    double halfWidth;
    double halfHeight;
};

// One object of a scene, for both sides. All numbers are sums of few powers of two, so nothing is rounded.
struct Item {
    std::vector<Piece> pieces;
    Vec2 at;
    double density = 0;    // kg/m²; 0: fixed
    double motorSpeed = 0; // not 0: rotated about its origin by a motor
};

struct SceneOf {
    std::string name;
    std::vector<Item> items;
    int blocks;           // number of blocks to measure
    double gravity = -10; // m/s², upwards; 0: the gravity effect is not activated
};

inline double areaOf(Item const& item) {
    double area = 0;
    for (Piece const& piece : item.pieces) {
        area += 4 * piece.halfWidth * piece.halfHeight;
    }
    return area;
}

inline SceneOf largePyramid() {
    constexpr int base = 40;
    SceneOf scene{"large_pyramid", {}, 60, -10};
    scene.items.push_back({{{{0, 0}, 100, 1}}, {0, -1}});
    for (int i = 0; i < base; ++i) {
        for (int j = i; j < base; ++j) {
            Vec2 const at{0.5 * (i + 1) + (j - i) - 0.5 * base, 0.5 * (2 * i + 1)};
            scene.items.push_back({{{{0, 0}, 0.5, 0.5}}, at, 1});
        }
    }
    return scene;
}

inline SceneOf tumbler() {
    SceneOf scene{"tumbler", {}, 120, -10};
    // In the order in which Trembler sorts the pieces of any shape, see shape_order.hpp: Box2D's broad phase,
    // and so the last bits of the motion, depend on it.
    Item drum{{{{-10, 0}, 0.5, 10}, {{0, 10}, 10, 0.5}, {{0, -10}, 10, 0.5}, {{10, 0}, 0.5, 10}}, {0, 10}, 5};
    drum.motorSpeed = 0.05 * pi;
    scene.items.push_back(drum);
    for (int i = 0; i < 25; ++i) {
        for (int j = 0; j < 20; ++j) {
            scene.items.push_back({{{{0, 0}, 0.125, 0.125}}, {0.5 * (i - 12), 10 + 0.5 * (j - 10)}, 1});
        }
    }
    return scene;
}

inline constexpr int velocityIterations = 8;
inline constexpr int positionIterations = 3;

class Bare {
public:
    explicit Bare(SceneOf const& scene) : world_(b2Vec2_zero), gravity_(static_cast<float>(scene.gravity)) {
        world_.SetAllowSleeping(false);
        b2BodyDef groundDef;
        b2Body* const ground = world_.CreateBody(&groundDef);
        for (Item const& item : scene.items) {
            b2BodyDef def;
            def.type = item.density > 0 ? b2_dynamicBody : b2_staticBody;
            def.position = vector(item.at);
            b2Body* const body = world_.CreateBody(&def);
            double moment = 0;
            for (Piece const& piece : item.pieces) {
                b2PolygonShape shape;
                shape.SetAsBox(static_cast<float>(piece.halfWidth), static_cast<float>(piece.halfHeight),
                               vector(piece.at), 0);
                b2FixtureDef fixture;
                fixture.shape = &shape;
                fixture.friction = 0.5F;
                body->CreateFixture(&fixture);
                double const area = 4 * piece.halfWidth * piece.halfHeight;
                moment +=
                    area * ((piece.halfWidth * piece.halfWidth + piece.halfHeight * piece.halfHeight) / 3 +
                            lengthSquared(piece.at));
            }
            if (item.density > 0) {
                b2MassData mass;
                mass.mass = static_cast<float>(item.density * areaOf(item));
                mass.center = b2Vec2_zero;
                mass.I = static_cast<float>(item.density * moment);
                body->SetMassData(&mass);
            }
            if (item.motorSpeed != 0) {
                b2RevoluteJointDef joint;
                joint.Initialize(ground, body, vector(item.at));
                joint.enableMotor = true;
                joint.motorSpeed = static_cast<float>(item.motorSpeed);
                joint.maxMotorTorque = 1e8F;
                world_.CreateJoint(&joint);
            }
            bodies_.push_back(body);
        }
    }
    void step() {
        world_.Step(static_cast<float>(frameDuration), velocityIterations, positionIterations);
        // Calls of interactions take effect in the next frame: so the first frame has no gravity on either
        // side.
        world_.SetGravity({0, gravity_});
    }
    [[nodiscard]] std::vector<Vec2> places() const {
        std::vector<Vec2> all;
        for (b2Body const* body : bodies_) {
            all.push_back(
                {static_cast<double>(body->GetPosition().x), static_cast<double>(body->GetPosition().y)});
        }
        return all;
    }

private:
    static b2Vec2 vector(Vec2 v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

    b2World world_;
    float gravity_;
    std::vector<b2Body*> bodies_;
};

class Trembler {
public:
    Trembler(Registry const& registry, SceneOf const& scene)
        : world_(registry, {.threads = 1, .detail = {}, .periods = {}, .trace = false}) {
        Store& store = world_.store();
        ObjectId const settings = store.create("world");
        if (scene.gravity != 0) {
            store.column<GravityField>().set(settings, {{0, scene.gravity}});
        }
        DynamicsSettings solver;
        solver.substeps = 1;
        solver.velocityIterations = velocityIterations;
        solver.positionIterations = positionIterations;
        solver.scale = 1;
        solver.sleeping = false;
        store.column<DynamicsSettings>().set(settings, solver);
        for (Item const& item : scene.items) {
            ObjectId const id = store.create("item " + std::to_string(objects_.size()));
            Shape shape;
            for (Piece const& piece : item.pieces) {
                shape.pieces.push_back(boxPiece(2 * piece.halfWidth, 2 * piece.halfHeight, piece.at));
            }
            store.column<Shape>().set(id, shape);
            store.column<Position>().set(id, {item.at});
            store.column<Friction>().set(id, {0.5});
            if (item.density > 0) {
                store.column<Mass>().set(id, {item.density * areaOf(item)});
            } else {
                store.column<Fixed>().set(id, {});
            }
            if (item.motorSpeed != 0) {
                Joint joint;
                joint.a = id;
                joint.at = item.at;
                joint.motor = true;
                joint.motorSpeed = item.motorSpeed;
                joint.motorStrength = 1e8;
                store.column<Joint>().set(store.create("axle"), joint);
            }
            objects_.push_back(id);
        }
        world_.start();
    }
    void step() { world_.step(); }
    [[nodiscard]] std::vector<Vec2> places() const {
        std::vector<Vec2> all;
        for (ObjectId const id : objects_) {
            all.push_back(world_.find<Position>(id)->value);
        }
        return all;
    }
    [[nodiscard]] World const& world() const { return world_; }

private:
    World world_;
    std::vector<ObjectId> objects_;
};

/// CPU time of this thread. Unlike wall time it does not include other processes.
inline double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Mean time of a frame, in s.
template <class Side>
double timeBlock(Side& side, int frames) {
    double const before = cpuSeconds();
    for (int frame = 0; frame < frames; ++frame) {
        side.step();
    }
    return (cpuSeconds() - before) / frames;
}

} // namespace bench
