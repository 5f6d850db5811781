// Properties that follow from an object's material, and values that the object states instead.
#include "physics/depth.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/look.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/material.hpp"
#include "physics/register_physics.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/object/without.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

class MaterialTest : public ::testing::Test {
protected:
    MaterialTest() { registerEverything(registry_); }

    std::unique_ptr<World> build(std::string const& objects, std::string const& more = "") {
        std::string const text =
            R"({"version": 2, "title": "t", "world": {"gravity": [0, -9.81]}, "objects": [)" + objects + "]" +
            more + "}";
        return buildWorld(registry_, readLevel(registry_, JsonDocument::parse(text, "material.json")),
                          parts_);
    }
    static std::string object(std::string const& name, std::string const& properties) {
        return R"({"name": ")" + name +
               R"(", "at": [0, 0], "properties": {"shape": [{"form": "box", "width": 0.5, "height": 0.2}], )" +
               properties + "}}";
    }
    template <class P>
    static P const* of(World const& world, std::string const& name) {
        return world.find<P>(world.store().find(name));
    }

    Registry registry_;
    PartLibrary parts_;
};

TEST_F(MaterialTest, DeterminesPropertiesThatAreNotStated) {
    for (std::size_t i = 0; i < choiceNames<Material>.size(); ++i) {
        std::string_view const name = choiceNames<Material>[i];
        auto const material = static_cast<Material>(i);
        MaterialFacts const& facts = materialFacts(material);
        auto const world = build(object("thing", R"("material": ")" + std::string(name) + "\""));
        EXPECT_EQ(of<Density>(*world, "thing")->value, facts.density) << name;
        EXPECT_EQ(of<Friction>(*world, "thing")->coefficient, facts.friction) << name;
        EXPECT_EQ(of<Restitution>(*world, "thing")->coefficient, facts.restitution) << name;
        EXPECT_DOUBLE_EQ(of<Mass>(*world, "thing")->value, facts.density * 0.1 * worldDepth) << name;
        EXPECT_EQ(of<Conductor>(*world, "thing") != nullptr, facts.conducts) << name;
        EXPECT_EQ(of<ElectricityGraph>(*world, "thing") != nullptr, facts.conducts) << name;
        EXPECT_EQ(of<MagneticStrength>(*world, "thing") != nullptr, facts.saturation > 0) << name;
    }
    // Iron, saturated: poles of 1.7e6 A/m times a cross-section of √0.1 m × 0.1 m.
    auto const iron = build(object("thing", R"("material": "iron")"));
    EXPECT_NEAR(of<MagneticStrength>(*iron, "thing")->susceptibility, 53759, 1);
    EXPECT_EQ(of<MagneticStrength>(*iron, "thing")->strength, 0);
}

TEST_F(MaterialTest, IsOverriddenByStatedProperties) {
    auto const world = build(object("thing", R"("material": "steel", "density": 100, "friction": 0.9,
        "restitution": 0.7, "conductor": {"network": "mains"}, "magnetic_strength": {"susceptibility": 3})"));
    EXPECT_EQ(of<Density>(*world, "thing")->value, 100);
    EXPECT_EQ(of<Friction>(*world, "thing")->coefficient, 0.9);
    EXPECT_EQ(of<Restitution>(*world, "thing")->coefficient, 0.7);
    EXPECT_EQ(of<Conductor>(*world, "thing")->network, "mains");
    EXPECT_EQ(of<MagneticStrength>(*world, "thing")->susceptibility, 3);
    EXPECT_DOUBLE_EQ(of<Mass>(*world, "thing")->value, 100 * 0.1 * worldDepth);
    auto const weighed = build(object("thing", R"("material": "steel", "mass": 2)"));
    EXPECT_EQ(of<Mass>(*weighed, "thing")->value, 2);
}

TEST_F(MaterialTest, IsOverriddenByExcludedProperties) {
    auto const world = build(object("thing", R"("material": "steel", "conductor": false,
        "magnetic_strength": false, "restitution": false)"));
    EXPECT_EQ(of<Conductor>(*world, "thing"), nullptr);
    EXPECT_EQ(of<ElectricityGraph>(*world, "thing"), nullptr);
    EXPECT_EQ(of<MagneticStrength>(*world, "thing"), nullptr);
    EXPECT_EQ(of<Restitution>(*world, "thing"), nullptr);
    EXPECT_NE(of<Friction>(*world, "thing"), nullptr);
    EXPECT_EQ(of<Without>(*world, "thing")->keys,
              (std::vector<std::string>{"conductor", "magnetic_strength", "restitution"}));
}

// Wires and terminals are checked before completions, but must recognise metals.
TEST_F(MaterialTest, ConductsWellEnoughForWiresAndTerminals) {
    std::string const two =
        object("plus", R"("material": "copper", "fixed": true, "electrical_source": true)") + ", " +
        object("bar", R"("material": "steel", "fixed": true, "resistance": 2)");
    EXPECT_NO_THROW(build(two, R"(, "connections": [["plus", "bar"]])"));
    std::string const wood =
        object("plus", R"("material": "copper", "fixed": true, "electrical_source": true)") + ", " +
        object("bar", R"("material": "wood", "fixed": true)");
    EXPECT_THROW(build(wood, R"(, "connections": [["plus", "bar"]])"), InputError);
    EXPECT_THROW(build(object("plus", R"("material": "wood", "electrical_source": true)")), InputError);
    EXPECT_THROW(
        build(object("plus", R"("material": "steel", "conductor": false, "electrical_source": true)")),
        InputError);
}

// A wall's mass follows from its material; a fixed body has a mass, but never moves.
TEST_F(MaterialTest, DeterminesTheMassOfFixedBodies) {
    auto const world = build(object("wall", R"("material": "brick", "fixed": true)") + ", " +
                             object("sea", R"("material": "water", "liquid": true)"));
    EXPECT_DOUBLE_EQ(of<Mass>(*world, "wall")->value, 1900 * 0.1 * worldDepth);
    EXPECT_DOUBLE_EQ(of<Mass>(*world, "sea")->value, 1000 * 0.1 * worldDepth);
    for (int frame = 0; frame < 60; ++frame) {
        world->step();
    }
    EXPECT_EQ(of<Position>(*world, "wall")->value, Vec2{});
    EXPECT_EQ(of<Velocity>(*world, "wall"), nullptr);
    // It has a weight, but this keeps no component awake.
    GravityForce const& gravity = *world->find<GravityForce>();
    ASSERT_EQ(gravity.forces.size(), 2U);
    for (ComponentStatus const& status : world->status()) {
        EXPECT_NE(status.activity, Activity::active) << title(*status.info);
    }
}

} // namespace
} // namespace trembler
