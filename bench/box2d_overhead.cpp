// What the methodology costs: two scenes of Box2D's own testbed through a Trembler world (gravity as an
// effect of its own, forces by interaction, contacts kept, every property in its column) against the same
// scenes on bare Box2D. Both run in this process, turn by turn in blocks of frames, with the same substeps
// and iterations, and bit for bit the same motion, which is checked. CPU time of this thread, medians over
// blocks.
#include "bench/measure.hpp"
#include "physics/dynamics/body.hpp"
#include "physics/dynamics/joint.hpp"
#include "physics/dynamics/settings.hpp"
#include "physics/dynamics/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/register_physics.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <box2d/box2d.h>

#include <array>
#include <cstring>
#include <ctime>
#include <memory>
#include <string>

namespace {

using namespace trembler;

constexpr double gravity = -10;
constexpr int blockFrames = 10;
constexpr int warmUpFrames = 60;

struct Piece {
    Vec2 at;
    double halfWidth;
    double halfHeight;
};

// One object of a scene, for either side. All numbers are sums of few powers of two: nothing is rounded.
struct Item {
    std::vector<Piece> pieces;
    Vec2 at;
    double density = 0;    // kg/m²; 0: fixed
    double motorSpeed = 0; // not 0: turned about its origin by a motor
};

struct SceneOf {
    std::string name;
    std::vector<Item> items;
    int blocks;
};

double areaOf(Item const& item) {
    double area = 0;
    for (Piece const& piece : item.pieces) {
        area += 4 * piece.halfWidth * piece.halfHeight;
    }
    return area;
}

SceneOf largePyramid() {
    constexpr int base = 40;
    SceneOf scene{"large_pyramid", {}, 60};
    scene.items.push_back({{{{0, 0}, 100, 1}}, {0, -1}});
    for (int i = 0; i < base; ++i) {
        for (int j = i; j < base; ++j) {
            Vec2 const at{0.5 * (i + 1) + (j - i) - 0.5 * base, 0.5 * (2 * i + 1)};
            scene.items.push_back({{{{0, 0}, 0.5, 0.5}}, at, 1});
        }
    }
    return scene;
}

SceneOf tumbler() {
    SceneOf scene{"tumbler", {}, 120};
    Item drum{{{{10, 0}, 0.5, 10}, {{-10, 0}, 0.5, 10}, {{0, 10}, 10, 0.5}, {{0, -10}, 10, 0.5}}, {0, 10}, 5};
    drum.motorSpeed = 0.05 * pi;
    scene.items.push_back(drum);
    for (int i = 0; i < 25; ++i) {
        for (int j = 0; j < 20; ++j) {
            scene.items.push_back({{{{0, 0}, 0.125, 0.125}}, {0.5 * (i - 12), 10 + 0.5 * (j - 10)}, 1});
        }
    }
    return scene;
}

constexpr int velocityIterations = 8;
constexpr int positionIterations = 3;

class Bare {
public:
    explicit Bare(SceneOf const& scene) : world_(b2Vec2_zero) {
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
        // What interactions say is done in the next frame: the first one knows no gravity, here as there.
        world_.SetGravity({0, static_cast<float>(gravity)});
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
    std::vector<b2Body*> bodies_;
};

class Trembler {
public:
    Trembler(Registry const& registry, SceneOf const& scene)
        : world_(registry, {.threads = 1, .detail = {}, .periods = {}, .trace = false}) {
        Store& store = world_.store();
        ObjectId const settings = store.create("world");
        store.column<GravityField>().set(settings, {{0, gravity}});
        store.column<DynamicsSettings>().set(settings, {.substeps = 1,
                                                        .velocityIterations = velocityIterations,
                                                        .positionIterations = positionIterations,
                                                        .scale = 1,
                                                        .sleeping = false});
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

double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Side>
double timeBlock(Side& side) {
    double const before = cpuSeconds();
    for (int frame = 0; frame < blockFrames; ++frame) {
        side.step();
    }
    return (cpuSeconds() - before) / blockFrames;
}

bool run(Registry const& registry, SceneOf const& scene, int repetitions, bool verbose) {
    bench::Series bare;
    bench::Series ours;
    bench::Series ratio;
    bool same = true;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        Bare a(scene);
        Trembler b(registry, scene);
        for (int frame = 0; frame < warmUpFrames; ++frame) {
            a.step();
            b.step();
        }
        for (int block = 0; block < scene.blocks; ++block) {
            double timeA = 0;
            double timeB = 0;
            if (block % 2 == 0) {
                timeA = timeBlock(a);
                timeB = timeBlock(b);
            } else {
                timeB = timeBlock(b);
                timeA = timeBlock(a);
            }
            bare.add(timeA);
            ours.add(timeB);
            ratio.add(timeB / timeA);
        }
        same = same && a.places() == b.places();
        if (verbose && repetition + 1 == repetitions) {
            for (ComponentStatus const& status : b.world().status()) {
                if (status.updates > 0) {
                    std::printf("    %-32s %9.2f us mean, %llu updates\n", status.info->text.name.data(),
                                status.totalMicroseconds / static_cast<double>(status.updates),
                                static_cast<unsigned long long>(status.updates));
                }
            }
        }
    }
    bench::Table table(scene.name + ": " + std::to_string(scene.items.size() - 1) + " boxes, " +
                       std::to_string(repetitions) + " x " + std::to_string(scene.blocks) + " blocks of " +
                       std::to_string(blockFrames) + " frames");
    double const overhead = 100 * (ratio.median() - 1);
    table.row("bare Box2D, per frame", 1e6 * bare.median(), "us");
    table.row("through Trembler, per frame", 1e6 * ours.median(), "us");
    table.row("overhead", overhead, "%", overhead, 5);
    table.print();
    std::printf("  motion is %s\n\n",
                same ? "the same, bit for bit" : "NOT THE SAME: the comparison is void");
    return same && overhead <= 5;
}

} // namespace

// bench_box2d_overhead [repetitions] [--verbose]; ends with 1 if a limit is missed.
int main(int argc, char** argv) {
    int repetitions = 5;
    bool verbose = false;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--verbose") == 0) {
            verbose = true;
        } else if (int const asked = std::atoi(argv[i]); asked > 0) {
            repetitions = asked;
        }
    }
    Registry registry;
    registerEverything(registry);
    bool held = true;
    for (SceneOf const& scene : {largePyramid(), tumbler()}) {
        held = run(registry, scene, repetitions, verbose) && held;
    }
    return held ? 0 : 1;
}
