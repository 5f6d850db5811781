// The effect that docs/contributors.md builds step by step, so that the page is tested. The code between the
// markers is the code that the page shows.
#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/force_rates.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/register_physics.hpp"
#include "runtime/notation/notation.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

// [properties]
/// The air's motion, a property of the world.
struct Wind {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Wind", "wind", "The velocity of the air.", PropertyPlace::world};
    Vec2 velocity;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "m/s",
                        .meaning = "velocity of the air",
                        .minimum = -200,
                        .maximum = 200},
              self.velocity);
    }
};

/// What the wind can push.
struct Sail {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Sail", "sail", "How much wind the object catches."};
    double dragArea = 1;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "m²",
                        .meaning = "drag coefficient times area",
                        .minimum = 0,
                        .maximum = 1e4},
              self.dragArea);
    }
};
// [properties]

// [derived]
/// F_W, offered by whichever detail level of wind is at work.
struct WindForce {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"F_W", "wind_force", "The force of the wind on each sail."};
    struct Entry {
        ObjectId object;
        Vec2 force;      ///< N
        double rate = 0; ///< 1/s, at which the wind alone would bring the sail to its own speed
    };
    std::vector<Entry> forces;
};

class QuadraticWind final : public Dps<QuadraticWind, Reads<Wind, Sail, Velocity, Mass>, Derives<WindForce>> {
public:
    static constexpr ComponentText text{
        .name = "Wind Forces",
        .effect = "wind",
        .level = "quadratic",
        .work = "Drag: half the density of air times drag area times speed squared, "
                "along the velocity of the air relative to the sail.",
        .rank = 1};
    using Activation = NeedsAll<Wind, Sail>;

    void update(Access& access) {
        constexpr double airDensity = 1.2; // kg/m³
        Vec2 const wind = access.read<Wind>().values().front().velocity;
        auto& forces = access.derive<WindForce>().forces;
        forces.clear();
        forEach(
            [&](ObjectId id, Sail const& sail, Velocity const& velocity, Mass const& mass) {
                Vec2 const relative = wind - velocity.value;
                double const perSpeed = 0.5 * airDensity * sail.dragArea * length(relative); // N s/m
                forces.push_back({id, perSpeed * relative, 2 * perSpeed / mass.value}); // d(v²) = 2 v dv
            },
            access.read<Sail>(), access.read<Velocity>(), access.read<Mass>());
    }
};
// [derived]

// [interaction]
class DynamicsFromWind final : public Interaction<DynamicsFromWind, DynamicsRole, Reads<WindForce>> {
public:
    static constexpr ComponentText text{.name = "Dynamics <- Wind",
                                        .effect = "wind",
                                        .level = "",
                                        .work =
                                            "Applies the force of the wind at each sail's centre of mass."};
    using Activation = NeedsAll<Sail>;

    void apply(Access& access) {
        for (WindForce::Entry const& entry : access.read<WindForce>().forces) {
            access.call(AddForce{entry.object, entry.force});
            access.call(StateRate{entry.object, entry.rate});
        }
    }
};

void registerWind(Registry& registry) {
    registry.component<QuadraticWind>();
    registry.component<DynamicsFromWind>();
}
// [interaction]

TEST(ExampleEffect, BlowsASailUpToTheSpeedOfTheWind) {
    Registry registry;
    registerEverything(registry);
    registerWind(registry);
    World world(registry);
    Store& store = world.store();
    store.column<Wind>().set(store.create("world"), {{10, 0}});
    ObjectId const boat = store.create("boat");
    store.column<Position>().set(boat, {});
    store.column<Shape>().set(boat, {{boxPiece(1, 1)}});
    store.column<Sail>().set(boat, {2});
    world.start();
    for (int frame = 0; frame < 60 * 600; ++frame) {
        world.step();
        if (frame == 1) {
            double const stated = 2 * 0.5 * 1.2 * 2 * 10 / world.find<Mass>(boat)->value;
            EXPECT_NEAR(world.find<ForceRates>()->greatest, stated, 1e-3 * stated);
        }
    }
    // m dv/dt = c (w - v)²  gives  v = w (1 - 1 / (1 + c w t / m)),  c = half density times drag area.
    double const mass = world.find<Mass>(boat)->value;
    double const rate = 0.5 * 1.2 * 2 * 10 / mass;
    double const expected = 10 * (1 - 1 / (1 + rate * world.time()));
    EXPECT_NEAR(world.find<Velocity>(boat)->value.x, expected, 0.01);
    EXPECT_NE(notationText(registry).find("(Dynamics <- Wind) Interaction"), std::string::npos);
}

TEST(ExampleEffect, IsAbsentWithoutItsProperties) {
    Registry registry;
    registerEverything(registry);
    registerWind(registry);
    World world(registry);
    world.store().column<Wind>().set(world.store().create("world"), {{10, 0}});
    world.start();
    for (ComponentStatus const& status : world.status()) {
        if (status.info->text.effect == "wind") {
            EXPECT_EQ(status.activity, Activity::absent);
        }
    }
}

} // namespace
} // namespace trembler
