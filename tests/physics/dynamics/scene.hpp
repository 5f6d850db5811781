// Small worlds of rigid bodies for tests, with constant gravity.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/register.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace trembler::test {

/// The detail levels of Dynamics in this program.
[[nodiscard]] std::vector<std::string> engines();
/// The engine of scenes that do not state another one.
[[nodiscard]] std::string& engineUnderTest();

/// The engine of scenes that do not state another one, as long as this lives: for what the program chooses
/// for the packages alone.
class WithEngine {
public:
    explicit WithEngine(std::string const& engine) : before_(engineUnderTest()) {
        engineUnderTest() = engine;
    }
    ~WithEngine() { engineUnderTest() = before_; }
    WithEngine(WithEngine const&) = delete;
    WithEngine& operator=(WithEngine const&) = delete;

private:
    std::string before_;
};

/// A fixture for tests that hold for every engine.
class OnEveryEngine : public ::testing::TestWithParam<std::string> {
protected:
    void SetUp() override { engineUnderTest() = GetParam(); }
    void TearDown() override { engineUnderTest() = "box2d"; }
    [[nodiscard]] static bool on(std::string_view engine) { return GetParam() == engine; }
};

/// Instantiates a suite derived from OnEveryEngine; placed after its tests.
#define TREMBLER_ON_EVERY_ENGINE(suite)                                                                      \
    INSTANTIATE_TEST_SUITE_P(Engines, suite, ::testing::ValuesIn(engines()),                                 \
                             [](auto const& info) { return info.param; })

/// Forces that a test sets: they act on an object as long as it has this property.
struct Pull {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Pull", "test_pull", "A force, for tests.", PropertyPlace::hidden};
    Vec2 force{};        ///< N, at the centre of mass
    Vec2 acceleration{}; ///< m/s², times the mass
    double torque = 0;   ///< N m
    Vec2 pointForce{};   ///< N, at `point`
    Vec2 point{};        ///< m, in the world
};

/// Impulses that are applied once whenever `serial` changes.
struct Kick {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Kick", "test_kick", "An impulse, for tests.", PropertyPlace::hidden};
    Vec2 impulse; ///< N s
    Vec2 point;   ///< m, in the world
    int serial = 0;
};

class DynamicsFromPull final : public Interaction<DynamicsFromPull, DynamicsRole, Reads<Pull, Mass>> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics <- Pull", .effect = "test", .level = "", .work = "Applies pulls."};
    using Activation = NeedsAll<Pull>;
    void apply(Access& access);
};

class DynamicsFromKick final : public Interaction<DynamicsFromKick, DynamicsRole, Reads<Kick>> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics <- Kick", .effect = "test", .level = "", .work = "Applies kicks."};
    static constexpr Coverage memory =
        leftOut("which kicks have been given; a test compares no hashes of it");
    using Activation = NeedsAll<Kick>;
    void apply(Access& access);

private:
    std::map<ObjectId, int> seen_;
};

/// A world with Dynamics, and with pulls and kicks, but without any other physics.
class Scene {
public:
    struct Options {
        bool trace = false;
        int threads = 1;
        DynamicsSettings solver = {};
        void (*extend)(Registry&) = nullptr; ///< registers further components
    };
    Scene() : Scene(Options{}) {}
    explicit Scene(Options options);

    /// Constant downward acceleration for every body added from now on.
    double gravity = 9.81;

    ObjectId body(std::string const& name, ShapePiece piece, Vec2 at, double angle = 0);
    ObjectId body(std::string const& name, Shape shape, Vec2 at, double angle = 0);
    ObjectId fixed(std::string const& name, ShapePiece piece, Vec2 at, double angle = 0);
    ObjectId joint(std::string const& name, Joint joint);
    /// A ball with a generated name.
    ObjectId ball(Vec2 at, double radius = 0.1);
    template <class P>
    void give(ObjectId id, P property) {
        world->store().column<P>().set(id, std::move(property));
    }
    template <class P>
    [[nodiscard]] P& of(ObjectId id) {
        auto& column = world->store().column<P>();
        column.touch();
        return column[id];
    }
    /// Runs frames; the first call starts the world.
    void run(int frames);

    [[nodiscard]] Vec2 at(ObjectId id) const { return world->find<Position>(id)->value; }
    [[nodiscard]] Vec2 velocity(ObjectId id) const { return world->find<Velocity>(id)->value; }
    [[nodiscard]] double angle(ObjectId id) const { return world->find<Rotation>(id)->angle; }
    [[nodiscard]] double spin(ObjectId id) const { return world->find<AngularVelocity>(id)->value; }
    [[nodiscard]] double mass(ObjectId id) const { return world->find<Mass>(id)->value; }
    [[nodiscard]] Contacts const& contacts() const { return *world->find<Contacts>(); }
    [[nodiscard]] bool touching(ObjectId a, ObjectId b) const;
    [[nodiscard]] Activity dynamics() const;

    Registry registry;
    std::unique_ptr<World> world;

private:
    bool started_ = false;
};

/// Everything that Scene registers.
void registerScene(Registry& registry);

} // namespace trembler::test
