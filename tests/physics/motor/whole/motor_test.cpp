// Electric motors and generators compared with the equations of a direct-current motor.
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/motor/electricity_from_rotation.hpp"
#include "physics/register_physics.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"
#include "tests/support/initial_wire.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace trembler {
namespace {

/// A world without gravity, with a battery, in which bodies turn about their centres.
class Bench {
public:
    explicit Bench(bool trace = false) {
        registerEverything(registry);
        WorldOptions options;
        options.trace = trace;
        world = std::make_unique<World>(registry, options);
        plus = store().create("plus");
        store().column<Conductor>().set(plus, {});
        store().column<ElectricalSource>().set(plus, {});
        minus = store().create("minus");
        store().column<Conductor>().set(minus, {});
        store().column<ElectricalReturn>().set(minus, {});
    }
    Store& store() { return world->store(); }
    ObjectId disc(std::string const& name, Vec2 at, double radius = 0.5, double mass = 8) {
        ObjectId const id = store().create(name);
        store().column<Position>().set(id, {at});
        store().column<Shape>().set(id, {{circlePiece(radius)}});
        store().column<Mass>().set(id, {mass});
        store().column<Conductor>().set(id, {});
        return id;
    }
    void wire(ObjectId a, ObjectId b) { ASSERT_EQ(connectInitially(store(), a, b), std::nullopt); }
    void power(ObjectId id) {
        wire(plus, id);
        wire(id, minus);
    }
    void run(int frames) {
        if (world->frame() == 0) {
            world->start();
        }
        for (int i = 0; i < frames; ++i) {
            world->step();
        }
    }
    [[nodiscard]] double spin(ObjectId id) const { return world->find<AngularVelocity>(id)->value; }
    [[nodiscard]] bool on(ObjectId id) const { return world->find<ElectricalState>()->isOn(id); }
    [[nodiscard]] double inertia(ObjectId id) const {
        return world->find<Mass>(id)->value * massPropertiesOf(*world->find<Shape>(id)).inertiaPerMass;
    }
    [[nodiscard]] int events(std::string const& what) const {
        auto const& all = world->tracer()->events();
        return static_cast<int>(
            std::count_if(all.begin(), all.end(), [&](Event const& e) { return e.event == what; }));
    }

    Registry registry;
    std::unique_ptr<World> world;
    ObjectId plus;
    ObjectId minus;
};

// I dω/dt = τ (1 - ω/ω0)  gives  ω = ω0 (1 - exp(-t τ / (I ω0))).
TEST(ElectricMotor, RunsUpByTheEquationOfADirectCurrentMotor) {
    Bench bench;
    ObjectId const rotor = bench.disc("rotor", {});
    bench.store().column<ElectricMotor>().set(rotor, {3, 12, {}});
    bench.power(rotor);
    bench.run(2); // frame 1: on; frame 2: the torque acts
    double const time = bench.inertia(rotor) * 12 / 3;
    EXPECT_NEAR(bench.inertia(rotor), 1, 1e-12); // m r²/2
    for (int frame = 2; frame < 1200; ++frame) {
        bench.run(1);
        double const t = static_cast<double>(frame) / 60;
        EXPECT_NEAR(bench.spin(rotor), 12 * (1 - std::exp(-t / time)), 0.04) << frame;
    }
    EXPECT_NEAR(bench.spin(rotor), 12 * (1 - std::exp(-20 / time)), 0.01);
}

TEST(ElectricMotor, WithoutAnIdlingSpeedHasAConstantTorque) {
    Bench bench;
    ObjectId const rotor = bench.disc("rotor", {});
    bench.store().column<ElectricMotor>().set(rotor, {-0.5, 0, {}});
    bench.power(rotor);
    bench.run(601);
    EXPECT_NEAR(bench.spin(rotor), -0.5 * 10 / bench.inertia(rotor), 1e-3);
}

TEST(ElectricMotor, TurnsOnlyWhileTheCircuitIsClosed) {
    Bench bench;
    ObjectId const rotor = bench.disc("rotor", {});
    ObjectId const idle = bench.disc("not wired", {5, 0});
    bench.store().column<ElectricMotor>().set(rotor, {1, 0, {}});
    bench.store().column<ElectricMotor>().set(idle, {1, 0, {}});
    bench.power(rotor);
    bench.run(120);
    EXPECT_GT(bench.spin(rotor), 1);
    EXPECT_EQ(bench.spin(idle), 0);
    bench.world->feed({PlayerInput::Kind::cut, bench.plus, rotor, {}});
    bench.run(3);
    double const left = bench.spin(rotor);
    bench.run(120);
    EXPECT_EQ(bench.spin(rotor), left) << "without friction it keeps its speed";
}

TEST(ElectricMotor, TurnsItsSupportTheOtherWay) {
    Bench bench;
    ObjectId const rotor = bench.disc("rotor", {}, 0.5, 8);
    ObjectId const frame = bench.disc("frame", {5, 0}, 1, 6);
    bench.store().column<ElectricMotor>().set(rotor, {2, 6, frame});
    bench.power(rotor);
    bench.run(1200);
    double const l1 = bench.inertia(rotor) * bench.spin(rotor);
    double const l2 = bench.inertia(frame) * bench.spin(frame);
    EXPECT_NEAR(l1 + l2, 0, 1e-3) << "total angular momentum is conserved";
    EXPECT_NEAR(bench.spin(rotor) - bench.spin(frame), 6, 0.01);
    EXPECT_LT(bench.spin(frame), -0.5);
}

TEST(ElectricMotor, NeverOvershootsWithALightRotor) {
    Bench bench;
    ObjectId const rotor = bench.disc("rotor", {}, 0.05, 0.01);
    bench.store().column<ElectricMotor>().set(rotor, {50, 20, {}});
    bench.power(rotor);
    for (int frame = 0; frame < 120; ++frame) {
        bench.run(1);
        EXPECT_LE(bench.spin(rotor), 20 * 1.0001);
    }
    EXPECT_NEAR(bench.spin(rotor), 20, 1e-3);
}

TEST(ElectricMotor, StallsAtAnObstacle) {
    Bench bench;
    ObjectId const rotor = bench.store().create("rotor");
    bench.store().column<Position>().set(rotor, {});
    bench.store().column<Shape>().set(rotor, {{boxPiece(1, 0.1)}});
    bench.store().column<Conductor>().set(rotor, {});
    bench.store().column<ElectricMotor>().set(rotor, {20, 10, {}});
    ObjectId const pin = bench.store().create("pin");
    Joint hinge;
    hinge.a = rotor;
    bench.store().column<Joint>().set(pin, hinge);
    ObjectId const stop = bench.store().create("stop");
    bench.store().column<Position>().set(stop, {{0.4, 0.6}});
    bench.store().column<Shape>().set(stop, {{boxPiece(0.4, 0.4)}});
    bench.store().column<Fixed>().set(stop, {});
    bench.power(rotor);
    bench.run(600);
    EXPECT_TRUE(bench.on(rotor));
    EXPECT_NEAR(bench.spin(rotor), 0, 1e-3);
    EXPECT_GT(bench.world->find<Rotation>(rotor)->angle, 0.5) << "it turned until it met the stop";
}

class GeneratorBench : public Bench {
public:
    explicit GeneratorBench(bool trace = false) : Bench(trace) {
        rotor = disc("dynamo", {});
        lamp = store().create("lamp");
        store().column<Conductor>().set(lamp, {});
        wire(rotor, lamp);
        wire(lamp, minus);
    }
    ObjectId rotor;
    ObjectId lamp;
};

TEST(Generator, GivesElectricityWhileItTurnsFastEnough) {
    GeneratorBench bench(true);
    bench.store().column<Generator>().set(bench.rotor, {bench.plus, 5, 0});
    bench.store().column<AngularVelocity>().set(bench.rotor, {-8});
    bench.store().column<Damping>().set(bench.rotor, {0, 0.2});
    bench.run(2);
    EXPECT_TRUE(bench.on(bench.lamp)) << "in either direction of rotation";
    double before = 8;
    while (bench.on(bench.lamp) && bench.world->frame() < 1200) {
        before = -bench.spin(bench.rotor);
        bench.run(1);
    }
    // Off two frames after it became too slow: the graph changes in the next frame.
    EXPECT_NEAR(before, 5 * ElectricityFromRotation::lettingGo, 0.05);
    EXPECT_EQ(bench.events("turns fast enough"), 1);
    EXPECT_EQ(bench.events("turns too slowly"), 1);
    bench.run(600);
    EXPECT_FALSE(bench.on(bench.lamp));
    EXPECT_EQ(bench.events("turns fast enough"), 1) << "it must not switch on and off repeatedly";
}

TEST(Generator, GivesNothingWhileItTurnsTooSlowly) {
    GeneratorBench bench;
    bench.store().column<Generator>().set(bench.rotor, {bench.plus, 5, 0});
    bench.store().column<AngularVelocity>().set(bench.rotor, {4.9});
    bench.run(60);
    EXPECT_FALSE(bench.on(bench.lamp));
}

// I dω/dt = -M while there is current: it slows down evenly until the current ends.
TEST(Generator, IsHardToTurnWhileCurrentFlows) {
    GeneratorBench bench;
    bench.store().column<Generator>().set(bench.rotor, {bench.plus, 2, 1});
    bench.store().column<AngularVelocity>().set(bench.rotor, {8});
    bench.run(62);
    EXPECT_NEAR(bench.spin(bench.rotor), 8 - 1 / bench.inertia(bench.rotor), 0.04);
    bench.run(600);
    EXPECT_NEAR(bench.spin(bench.rotor), 2 * ElectricityFromRotation::lettingGo, 0.06);
    EXPECT_FALSE(bench.on(bench.lamp));

    GeneratorBench open;
    open.store().column<Generator>().set(open.rotor, {open.plus, 2, 1});
    open.store().column<AngularVelocity>().set(open.rotor, {8});
    open.run(1);
    open.world->feed({PlayerInput::Kind::cut, open.lamp, open.minus, {}});
    open.run(600);
    EXPECT_GT(open.spin(open.rotor), 7.9) << "without a circuit there is no resistance";
}

// A motor that drives the generator that feeds it: no perpetual motion, if the generator brakes as hard as
// the motor turns.
TEST(Generator, CannotFeedTheMotorThatTurnsIt) {
    GeneratorBench bench;
    bench.store().column<Generator>().set(bench.rotor, {bench.plus, 2, 1});
    bench.store().column<ElectricMotor>().set(bench.rotor, {1, 10, {}});
    bench.store().column<AngularVelocity>().set(bench.rotor, {8});
    bench.run(60 * 60);
    EXPECT_LT(bench.spin(bench.rotor), 2);
    EXPECT_FALSE(bench.on(bench.rotor));
}

TEST(Motors, AreRefusedIfTheyCouldNotWork) {
    Bench bench;
    ObjectId const good = bench.disc("good", {});
    ObjectId const wooden = bench.disc("wooden", {5, 0});
    bench.store().column<Conductor>().remove(wooden);
    ObjectId const fixed = bench.disc("fixed", {9, 0});
    bench.store().column<Fixed>().set(fixed, {});
    auto const refusal = [&](ObjectId id) {
        for (ObjectRule const& rule : bench.registry.rules()) {
            ColumnBase const* const column = bench.store().findColumn(*rule.property);
            if (rule.check != nullptr && column != nullptr && column->has(id)) {
                if (auto const why = rule.check(bench.store(), id)) {
                    return *why;
                }
            }
        }
        return std::string();
    };
    for (ObjectId const id : {good, wooden, fixed}) {
        bench.store().column<ElectricMotor>().set(id, {1, 1, {}});
    }
    EXPECT_EQ(refusal(good), "");
    EXPECT_NE(refusal(wooden).find("'wooden' is no conductor"), std::string::npos);
    EXPECT_NE(refusal(fixed).find("'fixed' cannot turn"), std::string::npos);
    bench.store().column<ElectricMotor>().set(good, {1, 1, good});
    EXPECT_NE(refusal(good).find("against itself"), std::string::npos);
    bench.store().column<ElectricMotor>().remove(good);
    bench.store().column<Generator>().set(good, {wooden, 1, 0});
    EXPECT_NE(refusal(good).find("source of 'good' is not an electrical source"), std::string::npos);
    bench.store().column<Generator>().set(good, {bench.plus, 1, 0});
    EXPECT_EQ(refusal(good), "");
}

TEST(Motors, AreAbsentWithoutTheirProperties) {
    Bench bench;
    bench.disc("disc", {});
    bench.run(10);
    int found = 0;
    for (ComponentStatus const& status : bench.world->status()) {
        if (status.info->text.effect == "motor") {
            EXPECT_EQ(status.activity, Activity::absent);
            ++found;
        }
    }
    EXPECT_EQ(found, 3);
}

} // namespace
} // namespace trembler
