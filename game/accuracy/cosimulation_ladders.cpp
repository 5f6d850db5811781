// What one frame of lag between simulations costs: a magnet and a float on a spring, whose springs are the
// engine's own and whose other force stands for a frame. Nothing in them loses energy, so whatever they gain
// or lose is the computation's.
#include "game/accuracy/effect_clock.hpp"
#include "game/accuracy/ladder.hpp"
#include "game/core/workshop.hpp"
#include "physics/buoyancy/liquid.hpp"
#include "physics/buoyancy/settings.hpp"
#include "physics/dynamics/body.hpp"
#include "physics/dynamics/joint.hpp"
#include "physics/dynamics/settings.hpp"
#include "physics/dynamics/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <cmath>

namespace trembler::accuracy {
namespace {

constexpr int second = 60;
constexpr int window = 2 * second; // frames, many swings

using Maker = ObjectId (*)(Store& store); ///< returns what swings

void spring(Store& store, ObjectId body, Vec2 at, Vec2 from, double stiffness) {
    Joint joint;
    joint.form = JointForm::spring;
    joint.a = body;
    joint.at = at;
    joint.atB = from;
    joint.stiffness = stiffness;
    store.column<Joint>().set(store.create("spring"), joint);
}

void magnet(Store& store, ObjectId id, double angle) {
    store.column<Rotation>().set(id, {angle});
    store.column<MagneticStrength>().set(id, {1000, 0});
    store.column<MagneticPoles>().set(id, {PoleSet::both, {0.09, 0}, {-0.09, 0}});
}

// A bar between two others, whose like poles face it.
ObjectId magnetOnSpring(Store& store) {
    for (double const side : {-1.0, 1.0}) {
        ObjectId const id = store.create(side < 0 ? "left" : "right");
        store.column<Position>().set(id, {{0.4 * side, 0}});
        magnet(store, id, pi);
    }
    ObjectId const id = store.create("swinging");
    store.column<Shape>().set(id, {{boxPiece(0.2, 0.05)}});
    store.column<Mass>().set(id, {0.5});
    store.column<Position>().set(id, {});
    store.column<Velocity>().set(id, {{0.1, 0}});
    magnet(store, id, 0);
    Joint slider; // or it would turn round
    slider.form = JointForm::slider;
    slider.a = id;
    store.column<Joint>().set(store.create("slider"), slider);
    spring(store, id, {}, {-1, 0}, 2);
    return id;
}

// A box half in water that resists nothing, at rest but for a push.
ObjectId floatOnSpring(Store& store) {
    store.column<GravityField>().set(store.find("world"), {{0, -9.81}});
    ObjectId const water = store.create("water");
    store.column<Shape>().set(water, {{boxPiece(10, 5)}});
    store.column<Position>().set(water, {{0, -2.5}});
    store.column<Density>().set(water, {1000});
    Liquid liquid;
    liquid.linearDrag = liquid.quadraticDrag = 0;
    store.column<Liquid>().set(water, liquid);
    ObjectId const id = store.create("swinging");
    store.column<Shape>().set(id, {{boxPiece(0.4, 0.2)}});
    store.column<Density>().set(id, {500});
    store.column<Position>().set(id, {});
    store.column<Velocity>().set(id, {{0, 0.1}});
    spring(store, id, {}, {0, 2}, 10);
    return id;
}

// Square speeds over the first window and over the last.
Rung measure(Workshop const& workshop, Maker make, std::string level, int substeps, bool ahead, int frames) {
    World world(workshop.registry);
    Store& store = world.store();
    DynamicsSettings settings;
    settings.substeps = substeps;
    settings.sleeping = false;
    ObjectId const self = store.create("world");
    store.column<DynamicsSettings>().set(self, settings);
    BuoyancySettings buoyancy;
    buoyancy.lookAhead = ahead;
    store.column<BuoyancySettings>().set(self, buoyancy);
    ObjectId const id = make(store);
    world.start();
    EffectClock clock("dynamics");
    double early = 0;
    double late = 0;
    for (int frame = 0; frame < frames; ++frame) {
        world.step();
        clock.frame(world);
        double const square = lengthSquared(world.find<Velocity>(id)->value);
        early += frame < window ? square : 0;
        late += frame >= frames - window ? square : 0;
    }
    double const seconds = static_cast<double>(frames - window) / second;
    return {
        std::move(level), clock.median(), 100 * std::abs(std::log(late / early)) / seconds, {}, false, {}};
}

Plan plan(std::string const& scene, Maker make, bool canLag, std::string const& remark) {
    return {"dynamics", [=](Workshop const& workshop, Effort effort) {
                int const frames = effort.brief ? 4 * second : 8 * second;
                Ladder ladder{"",
                              scene,
                              "% a second",
                              "energy that it gains or loses",
                              "an oscillator without friction, which does neither",
                              false,
                              {},
                              remark};
                for (int const substeps : {1, 2, 4, 8, 16}) {
                    std::string const name = fmt::format("{} substep{}", substeps, substeps == 1 ? "" : "s");
                    ladder.rungs.push_back(measure(workshop, make, name, substeps, true, frames));
                    if (canLag) {
                        ladder.rungs.push_back(
                            measure(workshop, make, name + ", not looking ahead", substeps, false, frames));
                    }
                }
                ladder.rungs.push_back(
                    measure(workshop, make, "automatic substeps", DynamicsSettings::automatic, true, frames));
                return ladder;
            }};
}

} // namespace

void addCosimulationPlans(std::vector<Plan>& plans) {
    plans.push_back(
        plan("a magnet on a spring", magnetOnSpring, false,
             "The magnets' force is of the beginning of the frame. Magnets look ahead by what that "
             "lags; what is left is the engine's own spring, which is damped by its substeps."));
    plans.push_back(plan("a float on a spring", floatOnSpring, true,
                         "Buoyancy looks ahead, too; the rest is the engine's spring."));
}

} // namespace trembler::accuracy
