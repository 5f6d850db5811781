#include "measure/accuracy/ladders/co_simulation.hpp"

#include "measure/accuracy/ladders/effect_clock.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/settings.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/properties.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/frame/settings.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <cmath>
#include <functional>

namespace trembler::accuracy {
namespace {

constexpr int oscillations = 6; // the first and the last one are compared
constexpr int settling = 2;     // frames, until every interaction has made its calls

DynamicsSettings solverOf(int substeps) {
    DynamicsSettings solver;
    solver.substeps = substeps;
    solver.sleeping = false;
    return solver;
}

ObjectId spring(Store& store, ObjectId body, Vec2 at, Vec2 to, double restLength, double stiffness) {
    Joint joint;
    joint.form = JointForm::spring;
    joint.a = body;
    joint.at = at;
    joint.atB = to;
    joint.length = restLength;
    joint.stiffness = stiffness;
    ObjectId const id = store.create("spring");
    store.column<Joint>().set(id, joint);
    return id;
}

// The energy of the conserved motion, averaged over a whole oscillation, so that the ripple within an
// oscillation, which every method has, is not counted.
Swing swing(World& world, Stiffness const& stiffness, std::function<double()> const& place,
            std::function<double()> const& speed) {
    double const omega2 = stiffness.lagged + stiffness.own;
    double const oscillation = 2 * pi / std::sqrt(omega2) / frameDuration; // frames
    auto const window = static_cast<int>(std::lround(oscillation));
    auto const last = static_cast<int>(std::lround((oscillations - 1) * oscillation));
    EffectClock clock("");
    double first = 0;
    double end = 0;
    world.start();
    for (int frame = 0; frame < settling + last + window; ++frame) {
        world.step();
        clock.frame(world);
        int const n = frame - settling;
        double const energy = (speed() * speed() + omega2 * place() * place()) / 2;
        first += n >= 0 && n < window ? energy : 0;
        end += n >= last ? energy : 0;
    }
    Swing found;
    found.growth = std::pow(end / first, oscillation / last) - 1;
    found.microseconds = clock.median();
    return found;
}

} // namespace

double predictedGrowth(Stiffness const& stiffness, int substeps, int period, bool lookAhead, int parts) {
    double const oscillation = 2 * pi / std::sqrt(stiffness.lagged + stiffness.own);
    double const stands = period * frameDuration / parts;
    double const step = frameDuration / parts / std::ceil(static_cast<double>(substeps) / parts);
    double const lag = lookAhead ? 0 : (stands - step) / 2;
    return std::exp(oscillation * (stiffness.lagged * lag - stiffness.own * step)) - 1;
}

Swing magnetOnSpring(GameData const& gameData, int substeps, bool lookAhead, int parts) {
    constexpr double distance = 1;    // m
    constexpr double strength = 5500; // A m
    constexpr double stiffness = 1;   // N/m, of the spring; the mass is 1 kg
    constexpr double anchor = 2;      // m
    World world(gameData.registry, {.threads = 1, .detail = {}, .periods = {}});
    Store& store = world.store();
    ObjectId const settings = store.create("world");
    store.column<DynamicsSettings>().set(settings, solverOf(substeps));
    store.column<FrameSettings>().set(settings, {parts});
    MagnetismSettings magnetism;
    magnetism.lookAhead = lookAhead;
    store.column<MagnetismSettings>().set(settings, magnetism);
    auto const magnet = [&](std::string const& name, Vec2 at) {
        ObjectId const id = store.create(name);
        store.column<Shape>().set(id, {{circlePiece(0.1)}});
        store.column<Position>().set(id, {at});
        store.column<Mass>().set(id, {1});
        store.column<MagneticStrength>().set(id, {strength, 0});
        store.column<MagneticPoles>().set(id, {PoleSet::north, {0, 0}, {0, 0}});
        return id;
    };
    store.column<Fixed>().set(magnet("fixed magnet", {-distance, 0}), {});
    ObjectId const body = magnet("magnet", {0, 0});
    // F = µ0/4π q² r / (r² + s²)^(3/2) at r = 1 m, and its slope there.
    constexpr double softened = distance * distance + magneticSoftening * magneticSoftening;
    double const push = 1e-7 * strength * strength / std::pow(softened, 1.5);
    Stiffness const found{push * (3 * distance * distance / softened - 1), stiffness};
    // The compressed spring balances the magnetic force, so the body would rest. In the first frame only the
    // spring acts, which starts the oscillation.
    spring(store, body, {0, 0}, {anchor, 0}, anchor + push * distance / stiffness, stiffness);
    Swing result = swing(
        world, found, [&] { return world.find<Position>(body)->value.x; },
        [&] { return world.find<Velocity>(body)->value.x; });
    result.predicted = predictedGrowth(found, substeps, 1, lookAhead, parts);
    return result;
}

Swing floatOnSpring(GameData const& gameData, int substeps, int period, bool lookAhead) {
    constexpr double g = earthGravity;
    constexpr double width = 3;     // m: so wide that it does not roll
    constexpr double height = 1.2;  // m
    constexpr double draught = 1;   // m
    constexpr double water = 1000;  // kg/m³
    constexpr double lifted = 0.01; // m, initial displacement
    constexpr double mass = water * draught * width * worldDepth;
    constexpr double own = 1; // 1/s², of the spring alone
    WorldOptions options;
    options.detail["buoyancy"] = "exact";
    options.periods["Buoyancy"] = period;
    World world(gameData.registry, options);
    Store& store = world.store();
    ObjectId const settings = store.create("world");
    store.column<DynamicsSettings>().set(settings, solverOf(substeps));
    store.column<GravityField>().set(settings, {{0, -g}});
    BuoyancySettings buoyancy;
    buoyancy.lookAhead = lookAhead;
    store.column<BuoyancySettings>().set(settings, buoyancy);
    ObjectId const sea = store.create("sea");
    store.column<Shape>().set(sea, {{boxPiece(20, 10)}});
    store.column<Position>().set(sea, {{0, -5}});
    store.column<Density>().set(sea, {water});
    store.column<Liquid>().set(sea, {0, 0, {}});
    constexpr double rest = height / 2 - draught; // m, the float's centre above the surface
    Vec2 const at{0, rest + lifted};
    ObjectId const body = store.create("float");
    store.column<Shape>().set(body, {{boxPiece(width, height)}});
    store.column<Position>().set(body, {at});
    store.column<Density>().set(body, {water * draught / height});
    spring(store, body, at, {0, 5}, 5 - rest, own * mass);
    Stiffness const found{g / draught, own};
    Swing result = swing(
        world, found, [&] { return world.find<Position>(body)->value.y - rest; },
        [&] { return world.find<Velocity>(body)->value.y; });
    result.predicted = predictedGrowth(found, substeps, period, lookAhead);
    return result;
}

} // namespace trembler::accuracy
