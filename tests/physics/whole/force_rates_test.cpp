// The rate of forces that each effect states, compared with the oscillation or decay of bodies.
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/force_rates.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/motor/properties.hpp"
#include "physics/register_physics.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"
#include "tests/support/initial_wire.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace trembler {
namespace {

class EffectRates : public ::testing::Test {
protected:
    EffectRates() { registerEverything(registry); }

    template <class P>
    void give(ObjectId id, P property) {
        store().column<P>().set(id, std::move(property));
    }
    ObjectId body(std::string const& name, ShapePiece piece, Vec2 at, double mass) {
        ObjectId const id = store().create(name);
        give(id, Shape{{std::move(piece)}});
        give(id, Position{at});
        give(id, Mass{mass});
        return id;
    }
    Store& store() { return world().store(); }
    World& world() {
        if (!world_) {
            world_ = std::make_unique<World>(registry);
            settings = world_->store().create("world");
        }
        return *world_;
    }
    void run(int frames) {
        if (world().frame() == 0) {
            world().start();
        }
        for (int i = 0; i < frames; ++i) {
            world().step();
        }
    }
    [[nodiscard]] ForceRates rates() { return *world().find<ForceRates>(); }
    /// rad/s, from the crossings of zero in a run of 30 s.
    template <class Place>
    double swing(Place&& place) {
        double before = place();
        double first = 0;
        double last = 0;
        int crossings = -1;
        for (int frame = 0; frame < 1800; ++frame) {
            run(1);
            double const now = place();
            if (before < 0 && now >= 0) {
                last = frame - now / (now - before);
                first = crossings < 0 ? last : first;
                ++crossings;
            }
            before = now;
        }
        EXPECT_GT(crossings, 2);
        return 2 * pi * crossings / ((last - first) * frameDuration);
    }

    Registry registry;
    ObjectId settings;

private:
    std::unique_ptr<World> world_;
};

TEST_F(EffectRates, OfLinearGravityAreNone) {
    body("ball", circlePiece(0.1), {0, 0}, 1);
    give(settings, GravityField{{0, -9.81}});
    run(3);
    EXPECT_EQ(rates(), (ForceRates{}));
}

// Kepler: ω² = G M / r³.
TEST_F(EffectRates, OfGravityAreTheMeanMotionOnAnOrbit) {
    ObjectId const star = body("star", circlePiece(0.2), {0, 0}, 1e6);
    ObjectId const planet = body("planet", circlePiece(0.1), {5, 0}, 1);
    GravityLaw law;
    law.constant = 125e-6;
    give(settings, law); // ω = 1 rad/s
    give(planet, Velocity{{0, 5}});
    for (char const* level : {"real", "tree"}) {
        world().setDetail("gravity", level);
        run(2);
        // No force acts in the first frames, in which the planet flies straight on and gets farther away.
        // Rates stated in a frame hold in the next one.
        Vec2 const apart = world().find<Position>(planet)->value - world().find<Position>(star)->value;
        run(1);
        EXPECT_NEAR(rates().greatest, std::sqrt(125 / std::pow(length(apart), 3)), 2e-5) << level;
        EXPECT_EQ(rates().unforeseen, rates().greatest);
        EXPECT_EQ(rates().object, planet);
    }
    double const omega = swing([&] { return world().find<Position>(planet)->value.y; });
    EXPECT_NEAR(omega, rates().greatest, 0.02);
    EXPECT_NEAR(world().find<Position>(star)->value.x, 0, 0.01);
}

// Opposite poles, one in the other, are a spring of stiffness µ0/4π q² / s³.
TEST_F(EffectRates, OfMagnetsAreTheirOscillation) {
    auto const pole = [&](char const* name, Vec2 at, PoleSet which) {
        ObjectId const id = body(name, circlePiece(0.05), at, 2);
        give(id, MagneticStrength{.strength = 500, .susceptibility = 0});
        give(id, MagneticPoles{.poles = which, .north = {}, .south = {}});
        give(id, CollisionGroups{.category = 1, .mask = 0xffff, .group = -1});
        return id;
    };
    give(pole("fixed", {0, 0}, PoleSet::north), Fixed{});
    ObjectId const free = pole("free", {0.002, 0}, PoleSet::south);
    for (char const* level : {"pairwise", "tree", "grid"}) {
        world().setDetail("magnetism", level);
        run(3);
        EXPECT_NEAR(rates().greatest, std::sqrt(1e-7 * 500 * 500 / std::pow(0.05, 3) / 2), 0.05) << level;
        EXPECT_EQ(rates().unforeseen, 0) << "they look ahead";
        EXPECT_EQ(rates().object, free);
    }
    double const omega = swing([&] { return world().find<Position>(free)->value.x; });
    EXPECT_NEAR(omega / rates().greatest, 1, 0.03);
    give(settings, MagnetismSettings{.lookAhead = false});
    run(2);
    EXPECT_EQ(rates().unforeseen, rates().greatest);
}

// A pole far out on a bar turns the bar more easily than it moves it.
TEST_F(EffectRates, OfMagnetsIncludeTheirRotation) {
    auto const bar = [&](char const* name, Vec2 at) {
        ObjectId const id = body(name, boxPiece(0.4, 0.02), at, 1);
        give(id, MagneticStrength{.strength = 300, .susceptibility = 0});
        give(id, MagneticPoles{.poles = PoleSet::both, .north = {0.2, 0}, .south = {-0.2, 0}});
        return id;
    };
    ObjectId const post = bar("post", {0, 1});
    give(post, Fixed{});
    give(post, Rotation{pi / 2});
    ObjectId const needle = bar("needle", {0.01, 1});
    give(needle, Rotation{pi / 2 + pi - 0.01});
    for (ObjectId const id : {post, needle}) {
        give(id, CollisionGroups{.category = 1, .mask = 0xffff, .group = -1});
    }
    run(3);
    double const stated = rates().greatest;
    double const turning = swing([&] { return world().find<Rotation>(needle)->angle - 1.5 * pi; });
    EXPECT_GE(stated, 0.98 * turning);
    EXPECT_LE(stated, 1.8 * turning);
}

// A float of draught d oscillates with ω² = g / d; for an upright one the stated rate is at most √3 times
// that.
TEST_F(EffectRates, OfFloatingBodiesAreTheirOscillation) {
    for (double const g : {9.81, 1.62}) {
        World one(registry);
        Store& all = one.store();
        all.column<GravityField>().set(all.create("world"), {{0, -g}});
        ObjectId const sea = all.create("sea");
        all.column<Shape>().set(sea, {{boxPiece(20, 10)}});
        all.column<Position>().set(sea, {{0, -5}});
        all.column<Density>().set(sea, {1000});
        all.column<Liquid>().set(sea, {0, 0, {}});
        ObjectId const raft = all.create("raft");
        all.column<Shape>().set(raft, {{boxPiece(3, 1)}});
        all.column<Position>().set(raft, {{0, 0}});
        all.column<Density>().set(raft, {500});
        one.start();
        for (int frame = 0; frame < 30; ++frame) {
            one.step();
        }
        double const bobbing = std::sqrt(g / 0.5);
        ForceRates const found = *one.find<ForceRates>();
        EXPECT_GE(found.greatest, 0.99 * bobbing) << g;
        EXPECT_LE(found.greatest, std::sqrt(3.0) * bobbing) << g;
        EXPECT_EQ(found.unforeseen, 0);
        EXPECT_EQ(found.object, raft);
    }
}

TEST_F(EffectRates, OfTheHandAreItsSpring) {
    ObjectId const box = body("box", boxPiece(0.5, 0.5), {0, 0}, 3);
    run(1);
    world().feed({.kind = PlayerInput::Kind::grab, .object = box, .other = {}, .at = {0, 0.1}});
    run(3);
    EXPECT_EQ(rates(), (ForceRates{12, 12, box, 12, 0}));
    world().feed({.kind = PlayerInput::Kind::release, .object = box, .other = {}, .at = {}});
    run(3);
    EXPECT_EQ(rates(), (ForceRates{}));
}

// I dω/dt = τ (1 - ω/ω0): it nears its idling speed at the rate τ / (I ω0).
TEST_F(EffectRates, OfMotorsAreTheirRatesOfRunningUp) {
    ObjectId const rotor = body("rotor", circlePiece(0.5), {0, 0}, 8); // I = 1 kg m²
    ObjectId const plus = store().create("plus");
    ObjectId const minus = store().create("minus");
    for (ObjectId const id : {plus, rotor, minus}) {
        give(id, Conductor{});
    }
    give(plus, ElectricalSource{});
    give(minus, ElectricalReturn{});
    give(rotor, ElectricMotor{3, 12, {}});
    ASSERT_EQ(connectInitially(store(), plus, rotor), std::nullopt);
    ASSERT_EQ(connectInitially(store(), rotor, minus), std::nullopt);
    run(3);
    EXPECT_NEAR(rates().greatest, 0.25, 1e-12);
    EXPECT_EQ(rates().swinging, 0) << "a motor that runs up does not oscillate";
    store().column<ElectricMotor>().set(rotor, {3, 0, {}});
    run(2);
    EXPECT_EQ(rates(), (ForceRates{})) << "a constant torque";
}

struct CallsMade {
    bool force = false;
    bool rate = false;
};

/// Runs a new instance of every interaction that calls Dynamics, on the world as it is, and notes which calls
/// it makes. The world's own interactions and calls stay as they are.
void noteCalls(World& world, Registry const& registry, std::map<std::string, CallsMade>& all) {
    Executor executor(1);
    for (Registration const& registration : registry.components()) {
        ComponentInfo const& info = *registration.info;
        if (info.kind != ComponentKind::interaction || info.role != std::type_index(typeid(DynamicsRole))) {
            continue;
        }
        Callers callers;
        Channels channels(callers);
        std::unique_ptr<Component> const component = registration.make();
        component->bind(world.store(), channels);
        FrameContext context;
        context.executor = &executor;
        context.store = &world.store();
        component->run(context);
        CallsMade& made = all[std::string(info.text.name)];
        auto const force = [&made](auto const&, CallOrigin const&) { made.force = true; };
        Channel<DynamicsRole> const& channel = channels.of<DynamicsRole>();
        channel.forCalls<AddForce>(force);
        channel.forCalls<AddForceToPoint>(force);
        channel.forCalls<AddTorque>(force);
        channel.forCalls<AddDrag>(force);
        channel.forCalls<StateRate>([&made](auto const&, CallOrigin const&) { made.rate = true; });
    }
}

// Over the registry, so that an interaction of a new effect is tested as well.
TEST_F(EffectRates, AreReportedByEveryInteractionThatAddsAForce) {
    std::map<std::string, std::string> const reasons{
        {"Dynamics <- Buoyancy", "(Dynamics <- Liquid Drag) reports it with the resistance that looks ahead"},
        {"Dynamics <- Generators", "the torque is constant, and never turns the rotor back"},
    };
    std::map<std::string, CallsMade> calls;

    // A float, for the interactions of buoyancy.
    World wet(registry);
    Store& all = wet.store();
    all.column<GravityField>().set(all.create("world"), {{0, -9.81}});
    ObjectId const sea = all.create("sea");
    all.column<Shape>().set(sea, {{boxPiece(20, 10)}});
    all.column<Position>().set(sea, {{0, -5}});
    all.column<Density>().set(sea, {1000});
    all.column<Liquid>().set(sea, {0, 0, {}});
    ObjectId const raft = all.create("raft");
    all.column<Shape>().set(raft, {{boxPiece(3, 1)}});
    all.column<Position>().set(raft, {{0, 0}});
    all.column<Density>().set(raft, {500});
    wet.start();
    for (int frame = 0; frame < 30; ++frame) {
        wet.step();
    }
    noteCalls(wet, registry, calls);

    // Two masses, two magnetic poles, a motor, a generator and the hand, for the others.
    body("star", circlePiece(0.2), {100, 0}, 1e6);
    body("planet", circlePiece(0.1), {105, 0}, 1);
    GravityLaw law;
    law.constant = 125e-6;
    give(settings, law);
    world().setDetail("gravity", "real");
    for (auto const& [name, x, which] :
         {std::tuple{"north", 0.0, PoleSet::north}, std::tuple{"south", 0.12, PoleSet::south}}) {
        ObjectId const id = body(name, circlePiece(0.05), {x, 0}, 2);
        give(id, MagneticStrength{.strength = 500, .susceptibility = 0});
        give(id, MagneticPoles{.poles = which, .north = {}, .south = {}});
    }
    ObjectId const plus = store().create("plus");
    ObjectId const minus = store().create("minus");
    ObjectId const motor = body("motor", circlePiece(0.5), {10, 0}, 8);
    ObjectId const generator = body("generator", circlePiece(0.5), {20, 0}, 8);
    for (ObjectId const id : {plus, minus, motor, generator}) {
        give(id, Conductor{});
    }
    give(plus, ElectricalSource{});
    give(minus, ElectricalReturn{});
    give(motor, ElectricMotor{3, 12, {}});
    give(generator, Generator{.source = plus, .speed = 1, .braking = 1});
    give(generator, AngularVelocity{5});
    for (ObjectId const id : {motor, generator}) {
        ASSERT_EQ(connectInitially(store(), plus, id), std::nullopt);
        ASSERT_EQ(connectInitially(store(), id, minus), std::nullopt);
    }
    ObjectId const box = body("box", boxPiece(0.5, 0.5), {30, 0}, 3);
    run(1);
    world().feed({.kind = PlayerInput::Kind::grab, .object = box, .other = {}, .at = {30, 0.1}});
    run(3);
    noteCalls(world(), registry, calls);

    EXPECT_GE(calls.size(), 7U);
    for (auto const& [name, made] : calls) {
        EXPECT_TRUE(made.force) << name << " adds no force in these scenes; add what makes it act";
        EXPECT_NE(made.rate, reasons.contains(name)) << name << ": expected a rate, or a reason for none";
    }
    for (auto const& [name, why] : reasons) {
        EXPECT_TRUE(calls.contains(name)) << name << " is listed, but not registered";
    }
}

} // namespace
} // namespace trembler
