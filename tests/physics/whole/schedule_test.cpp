// The schedule of 6.13.5 with the real effects: Electricity and Magnetics parallel to each other and to
// Dynamics, and a buoyancy like the thesis's after Dynamics.
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/register_physics.hpp"
#include "runtime/notation/notation.hpp"
#include "runtime/placement.hpp"
#include "runtime/schedule/schedule.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler {
namespace {

// The Buoyancy of 6.13.2, with the real properties of the other effects.
struct TestLiquid {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Liquid", "test_liquid",
                                       "This will flag the object to be a body of liquid."};
};
struct TestBuoyantForce {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"F_B", "test_buoyant_force", "Per object buoyancy force."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "empty";
};
struct TestBuoyancyRole {
    static constexpr std::string_view name = "Test Buoyancy";
    using Calls = CallList<>;
};
struct TestBuoyancy final
    : Resolver<TestBuoyancy, TestBuoyancyRole, Reads<Position, Rotation, Shape, Density, TestLiquid>,
               Writes<>, Provides<TestBuoyantForce>> {
    static constexpr ComponentText text{
        .name = "Test Buoyancy", .effect = "test", .level = "", .work = "Calculates F_B."};
    using Activation = NeedsAll<TestLiquid>;
    void advance(Access&) {}
};

struct RealSchedule : testing::Test {
    Registry registry;
    RealSchedule() {
        registerEverything(registry);
        registry.component<TestBuoyancy>();
    }
    [[nodiscard]] ComponentInfo const& named(std::string_view wanted) const {
        auto const at = std::find_if(registry.components().begin(), registry.components().end(),
                                     [&](Registration const& r) { return title(*r.info) == wanted; });
        if (at == registry.components().end()) {
            throw std::logic_error("there is no " + std::string(wanted));
        }
        return *at->info;
    }
    [[nodiscard]] std::size_t place(std::string_view wanted) const {
        return static_cast<std::size_t>(
            std::find_if(registry.components().begin(), registry.components().end(),
                         [&](Registration const& r) { return title(*r.info) == wanted; }) -
            registry.components().begin());
    }
};

TEST_F(RealSchedule, PassesAllRules) {
    EXPECT_NO_THROW(registry.check());
}

TEST_F(RealSchedule, RunsElectricityAndMagneticsInParallelWithDynamics) {
    ComponentInfo const& electricity = named("Electricity Resolver");
    ComponentInfo const& magnetics = named("Magnetics Resolver");
    ComponentInfo const& dynamics = named("Dynamics Resolver");
    EXPECT_TRUE(mayRunTogether(electricity, magnetics));
    EXPECT_TRUE(mayRunTogether(electricity, dynamics));
    EXPECT_TRUE(mayRunTogether(magnetics, dynamics));
}

TEST_F(RealSchedule, RunsBuoyancyAfterDynamicsAndInParallelWithTheOthers) {
    ComponentInfo const& dynamics = named("Dynamics Resolver");
    EXPECT_FALSE(mayRunTogether(dynamics, TestBuoyancy::describeSelf()));
    EXPECT_LT(place("Dynamics Resolver"), place("Test Buoyancy Resolver"))
        << "conflicts run in registration order";
    EXPECT_TRUE(mayRunTogether(named("Electricity Resolver"), TestBuoyancy::describeSelf()));
    EXPECT_TRUE(mayRunTogether(named("Magnetics Resolver"), TestBuoyancy::describeSelf()));
    std::string const text = notationText(registry);
    EXPECT_NE(
        text.find("Dynamics Resolver before Test Buoyancy Resolver: Position is written, then read, Rotation "
                  "is written, then read"),
        std::string::npos);
    EXPECT_NE(text.find("Electricity Resolver in parallel with Magnetics Resolver"), std::string::npos);
}

TEST_F(RealSchedule, RunsPopulationBeforeAllThatTouchObjects) {
    ComponentInfo const& population = named("Population Resolver");
    for (std::string_view const other : {"Dynamics Resolver", "Electricity Resolver", "Magnetics Resolver"}) {
        EXPECT_FALSE(mayRunTogether(population, named(other)));
        EXPECT_LT(place("Population Resolver"), place(other));
    }
}

// The sets of 6.13.2, as far as the property names are the thesis's: Dynamics writes the state of motion.
TEST_F(RealSchedule, DynamicsWritesExactlyWhatTheThesisLists) {
    auto const& writes = named("Dynamics Resolver").writes;
    for (PropertyInfo const* p : {&propertyInfo<Position>(), &propertyInfo<Velocity>(),
                                  &propertyInfo<AngularVelocity>(), &propertyInfo<Rotation>()}) {
        EXPECT_NE(std::find(writes.begin(), writes.end(), p), writes.end()) << p->text.name;
    }
    EXPECT_EQ(writes.size(), 4U);
}

} // namespace
} // namespace trembler
