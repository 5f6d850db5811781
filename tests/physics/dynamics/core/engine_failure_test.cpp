// After the failure of an engine the world continues with another, deterministically.
#include "physics/dynamics/properties/engine_state.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <chrono>
#include <cmath>

namespace trembler::test {
namespace engine_failure_test {
namespace {

class EngineFailures : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(EngineFailures);

EngineState const& stateOf(Scene const& scene) {
    return *scene.world->find<EngineState>();
}

void expectFinite(Scene const& scene) {
    Store& store = scene.world->store();
    for (Position const& position : store.column<Position>().values()) {
        ASSERT_TRUE(isFinite(position.value));
    }
    for (Velocity const& velocity : store.column<Velocity>().values()) {
        ASSERT_TRUE(isFinite(velocity.value));
    }
    for (Rotation const& rotation : store.column<Rotation>().values()) {
        ASSERT_TRUE(std::isfinite(rotation.angle));
    }
    for (AngularVelocity const& spin : store.column<AngularVelocity>().values()) {
        ASSERT_TRUE(std::isfinite(spin.value));
    }
}

Joint between(ObjectId a, ObjectId b, JointForm form) {
    Joint joint;
    joint.form = form;
    joint.a = a;
    joint.b = b;
    return joint;
}

// A stiff spring between a polygon and a body on a slider: Chipmunk used to abort on a place that was not
// finite.
void stiffSpring(Scene& scene) {
    ObjectId const polygon = scene.body("polygon", polygonPiece({{-1, -1}, {1, -1}, {0, 1}}), {0, 3});
    ObjectId const slide = scene.body("slide", circlePiece(30), {3, 0});
    Joint slider = between(slide, {}, JointForm::slider);
    slider.at = {3, 0};
    scene.joint("slider", slider);
    Joint spring = between(polygon, slide, JointForm::spring);
    spring.at = {0, 3};
    spring.atB = {3, 0};
    spring.length = 1;
    spring.stiffness = 1e9;
    scene.joint("spring", spring);
}

// A rope and a weld between a heavy box and a light, thin one: ODE used to abort in its factorisation.
void ropeAndWeld(Scene& scene) {
    ObjectId const heavy = scene.body("heavy", boxPiece(1, 1), {0, 2});
    ObjectId const light = scene.body("light", boxPiece(1, 0.05), {1.2, 2});
    scene.give(light, Mass{1 * 0.05 * 0.1 * 1e-3});
    Joint rope = between(heavy, light, JointForm::rope);
    rope.at = {0, 2};
    rope.atB = {1.2, 2};
    rope.length = 0.5;
    scene.joint("rope", rope);
    Joint weld = between(light, heavy, JointForm::weld);
    weld.at = {0.6, 2};
    scene.joint("weld", weld);
    scene.fixed("floor", boxPiece(10, 1), {0, 0});
}

TEST_P(EngineFailures, AStiffSpringOnASliderDoesNotEndTheProgram) {
    Scene scene;
    stiffSpring(scene);
    for (int frame = 0; frame < 120; ++frame) {
        scene.run(1);
        expectFinite(scene);
    }
}

TEST_P(EngineFailures, ARopeAndAWeldOnAFeatherDoNotEndTheProgram) {
    Scene scene;
    ropeAndWeld(scene);
    for (int frame = 0; frame < 120; ++frame) {
        scene.run(1);
        expectFinite(scene);
    }
}

TEST_P(EngineFailures, AHundredBoxesInOnePlaceAreMovedInBoundedSteps) {
    Scene scene;
    scene.fixed("floor", boxPiece(20, 1), {0, -0.5});
    for (int i = 0; i < 100; ++i) {
        scene.body("box " + std::to_string(i), boxPiece(0.2, 0.2), {0, 1});
    }
    for (int frame = 0; frame < 20; ++frame) {
        scene.run(1);
        expectFinite(scene);
    }
}

// Values that a level may state, at the ends of their ranges.
double extreme(std::initializer_list<double> values) {
    return *rc::gen::elementOf(std::vector<double>(values));
}

ShapePiece extremePiece() {
    switch (*rc::gen::inRange(0, 4)) {
    case 0:
        return circlePiece(extreme({0.005, 0.1, 1, 1000}));
    case 1:
        return boxPiece(extreme({0.01, 0.2, 3, 1e4}), extreme({0.01, 0.2, 3, 1e4}));
    case 2:
        return capsulePiece(extreme({0.02, 0.4, 1e4}), 0.01);
    default: {
        double const size = extreme({0.02, 0.5, 1000});
        return polygonPiece({{-size, -size}, {size, -size}, {0, size}});
    }
    }
}

Vec2 extremePlace() {
    double const x = extreme({0, 0, 0.1, 1, -2, 50, 1e6, -1e6});
    double const y = extreme({0, 0, 0.1, 1, -2, 50, 1e6, -1e6});
    return {x, y};
}

void extremeScene(Scene& scene) {
    std::vector<ObjectId> all;
    int const bodies = *rc::gen::inRange(2, 7);
    for (int i = 0; i < bodies; ++i) {
        ObjectId const id =
            scene.body("body " + std::to_string(i), extremePiece(), extremePlace(), extreme({0, 0.3, 1e3}));
        if (*rc::gen::inRange(0, 2) == 0) {
            scene.give(id, Mass{extreme({1e-6, 1e-3, 1, 1e9})});
        }
        if (*rc::gen::inRange(0, 3) == 0) {
            double const x = extreme({-1e4, 0, 1, 1e4});
            scene.give(id, Velocity{{x, extreme({-1e4, 0, 1, 1e4})}});
            scene.give(id, AngularVelocity{extreme({-1e4, 0, 1e4})});
        }
        if (*rc::gen::inRange(0, 5) == 0) {
            scene.give(id, Fixed{});
        }
        scene.give(id, Friction{extreme({0, 1, 100})});
        scene.give(id, Restitution{extreme({0, 0.5, 1})});
        if (*rc::gen::inRange(0, 3) == 0) {
            scene.give(id, Damping{extreme({0, 1, 1e3}), extreme({0, 1, 1e3})});
        }
        all.push_back(id);
    }
    std::vector<ObjectId> joints{ObjectId{}};
    for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
        Joint joint = between(*rc::gen::elementOf(all), *rc::gen::elementOf(all),
                              static_cast<JointForm>(*rc::gen::inRange(0, 9)));
        if (*rc::gen::inRange(0, 3) == 0) {
            joint.b = {};
        }
        joint.at = extremePlace();
        joint.atB = extremePlace();
        joint.groundA = extremePlace();
        joint.groundB = extremePlace();
        joint.axis = {extreme({1, 0, 1e6}), extreme({1, 0, -1e6})};
        joint.limited = *rc::gen::arbitrary<bool>();
        joint.lower = extreme({-1e6, -1, 0, 1});
        joint.upper = extreme({-1, 0, 1, 1e6});
        joint.motor = *rc::gen::arbitrary<bool>();
        joint.motorSpeed = extreme({-1e6, 1, 1e6});
        joint.motorStrength = extreme({0, 1, 1e9});
        joint.length = extreme({0, 1e-3, 1, 1e6});
        joint.stiffness = extreme({1, 1e3, 1e9});
        joint.dampingRate = extreme({0, 1, 1e9});
        joint.ratio = extreme({-1e3, 1e-3, 1, 1e3});
        joint.collide = *rc::gen::arbitrary<bool>();
        joint.jointA = *rc::gen::elementOf(joints);
        joint.jointB = *rc::gen::elementOf(joints);
        joints.push_back(scene.joint("joint " + std::to_string(i), joint));
    }
}

TEST_P(EngineFailures, WorldsAtTheEndsOfAllRangesContinue) {
    EXPECT_TRUE(rc::check([] {
        Scene scene({.solver = {.substeps = *rc::gen::element(0, 1, 4)}});
        scene.gravity = extreme({0, 9.81, 1e3});
        extremeScene(scene);
        for (int frame = 0; frame < 20; ++frame) {
            scene.run(1);
            expectFinite(scene);
            RC_ASSERT(!::testing::Test::HasFailure());
        }
    }));
}

// A failure is reported in the world's state and in the trace, and the other engine continues.
TEST_P(EngineFailures, AreReportedAndReproducible) {
    std::vector<Vec2> paths[2];
    for (auto& path : paths) {
        Scene scene({.trace = true});
        stiffSpring(scene);
        ropeAndWeld(scene);
        for (int frame = 0; frame < 60; ++frame) {
            scene.run(1);
            for (Position const& position : scene.world->store().column<Position>().values()) {
                path.push_back(position.value);
            }
        }
        EngineState const& state = stateOf(scene);
        bool reported = false;
        for (Event const& event : scene.world->tracer()->events()) {
            reported = reported || event.event.starts_with("engine gave up");
        }
        EXPECT_EQ(reported, state.troubled());
        EXPECT_EQ(state.troubled(), !state.why.empty());
        EXPECT_TRUE(state.gaveUp.empty() || state.gaveUp == GetParam());
    }
    EXPECT_EQ(paths[0], paths[1]);
}

} // namespace
} // namespace engine_failure_test
} // namespace trembler::test
