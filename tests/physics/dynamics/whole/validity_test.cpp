// Values on which Box2D would abort never reach it.
#include "tests/physics/dynamics/ngon.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>

namespace trembler::test {
namespace {

class Validity : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Validity);

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

// Arbitrary numbers, as in a malicious file.
double wild() {
    return *rc::gen::weightedOneOf<double>(
        {{6, rc::gen::map(rc::gen::inRange(-300, 300), [](int i) { return i * 0.01; })},
         {1, rc::gen::element(0.0, -0.0, nan, inf, -inf, 1e300, -1e300, 1e9, 1e-9, 1e-300, 1e6, 5e3, -1e4)}});
}

Vec2 wildVector() {
    return {wild(), wild()};
}

ShapePiece wildPiece() {
    ShapePiece piece;
    piece.form = static_cast<ShapeForm>(*rc::gen::inRange(0, 5));
    piece.at = *rc::gen::inRange(0, 3) == 0 ? wildVector() : Vec2{};
    piece.angle = *rc::gen::inRange(0, 3) == 0 ? wild() : 0;
    piece.radius = std::abs(wild());
    piece.width = std::abs(wild());
    piece.height = std::abs(wild());
    if (*rc::gen::inRange(0, 2) == 0) {
        piece.corners = ngon(*rc::gen::inRange(0, 10), std::abs(wild()), *rc::gen::inRange(0, 4) == 0);
    } else {
        for (int i = *rc::gen::inRange(0, 10); i > 0; --i) {
            piece.corners.push_back(wildVector());
        }
    }
    return piece;
}

Joint wildJoint(std::vector<ObjectId> const& all) {
    Joint joint;
    joint.form = static_cast<JointForm>(*rc::gen::inRange(0, 10));
    joint.a = *rc::gen::elementOf(all);
    joint.b = *rc::gen::elementOf(all);
    joint.at = wildVector();
    joint.atB = wildVector();
    joint.axis = wildVector();
    joint.limited = *rc::gen::arbitrary<bool>();
    joint.lower = wild();
    joint.upper = wild();
    joint.motor = *rc::gen::arbitrary<bool>();
    joint.motorSpeed = wild();
    joint.motorStrength = wild();
    joint.length = wild();
    joint.stiffness = wild();
    joint.dampingRate = wild();
    joint.ratio = wild();
    joint.groundA = wildVector();
    joint.groundB = wildVector();
    joint.jointA = *rc::gen::elementOf(all);
    joint.jointB = *rc::gen::elementOf(all);
    joint.breakForce = wild();
    return joint;
}

void addWildJoints(Scene& scene, std::vector<ObjectId>& all) {
    for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
        all.push_back(scene.joint("joint " + std::to_string(i), wildJoint(all)));
    }
}

TEST_P(Validity, NoValuesOfAnObjectAbort) {
    EXPECT_TRUE(rc::check([] {
        Scene scene({.trace = true});
        std::vector<ObjectId> all{ObjectId{}};
        int const bodies = *rc::gen::inRange(1, 6);
        for (int i = 0; i < bodies; ++i) {
            Shape shape;
            for (int n = *rc::gen::inRange(0, 4); n > 0; --n) {
                shape.pieces.push_back(wildPiece());
            }
            ObjectId const id = scene.body("body " + std::to_string(i), shape, wildVector(), wild());
            if (*rc::gen::inRange(0, 2) == 0) {
                scene.give(id, Velocity{wildVector()});
                scene.give(id, AngularVelocity{wild()});
            }
            if (*rc::gen::inRange(0, 3) == 0) {
                scene.give(id, Mass{wild()});
                scene.give(id, Friction{wild()});
                scene.give(id, Restitution{wild()});
                scene.give(id, Damping{wild(), wild()});
                scene.give(id, CollisionGroups{*rc::gen::arbitrary<int>(), *rc::gen::arbitrary<int>(), 0});
            }
            if (*rc::gen::inRange(0, 4) == 0) {
                scene.give(id, Fixed{});
            }
            Pull pull;
            pull.force = wildVector();
            pull.torque = wild();
            pull.point = wildVector();
            pull.pointForce = wildVector();
            scene.give(id, pull);
            scene.give(id, Kick{wildVector(), wildVector(), 1});
            all.push_back(id);
        }
        addWildJoints(scene, all);
        scene.run(3);
        scene.world->feed({.kind = PlayerInput::Kind::remove, .object = all[1], .other = {}, .at = {}});
        scene.run(10);
    }));
}

// The valid bodies of a random world stay valid: finite at the start, finite for ever.
TEST_P(Validity, ValidBodiesStayFinite) {
    EXPECT_TRUE(rc::check([] {
        Scene scene;
        std::vector<ObjectId> all{ObjectId{}};
        for (int i = 0; i < 6; ++i) {
            ObjectId const id = scene.body("body " + std::to_string(i), wildPiece(),
                                           {*rc::gen::inRange(-9, 9) * 0.1, *rc::gen::inRange(-9, 9) * 0.1});
            Pull pull;
            pull.force = wildVector();
            pull.point = wildVector();
            pull.pointForce = wildVector();
            pull.torque = wild();
            scene.give(id, pull);
            scene.give(id, Kick{wildVector(), wildVector(), 1});
            all.push_back(id);
        }
        addWildJoints(scene, all);
        scene.run(30);
        for (Position const& position : scene.world->store().column<Position>().values()) {
            RC_ASSERT(isFinite(position.value));
        }
        for (Rotation const& rotation : scene.world->store().column<Rotation>().values()) {
            RC_ASSERT(std::isfinite(rotation.angle));
        }
    }));
}

// An editor writes one of two limits first, while the other is still 0.
TEST_P(Validity, ExchangedLimitsDoNotAbort) {
    for (JointForm const form : {JointForm::hinge, JointForm::slider, JointForm::wheel}) {
        for (bool const limited : {false, true}) {
            Scene scene({.trace = true});
            Joint joint;
            joint.form = form;
            joint.a = scene.ball({0, 1});
            joint.stiffness = 10;
            joint.limited = limited;
            joint.upper = -1;
            ObjectId const id = scene.joint("joint", joint);
            scene.run(3);
            EXPECT_NE(scene.world->tracer()->events().size(), 0U);
            joint.lower = -1;
            scene.give(id, joint);
            scene.run(3);
        }
    }
}

TEST_P(Validity, RefusalsAreReportedOnceAndTheOthersContinue) {
    Scene scene({.trace = true});
    ObjectId const bad = scene.body("bad", polygonPiece(ngon(9, 0.3)), {0, 5});
    ObjectId const good = scene.ball({3, 5});
    Joint joint;
    joint.a = good;
    joint.b = bad;
    scene.joint("dangling", joint);
    scene.run(5);
    scene.ball({7, 5});
    scene.run(5);
    EXPECT_EQ(scene.at(bad), (Vec2{0, 5}));
    EXPECT_LT(scene.at(good).y, 5);
    int reported = 0;
    for (Event const& event : scene.world->tracer()->events()) {
        reported += event.event.starts_with("refused") && event.objects[0] == "bad" ? 1 : 0;
    }
    EXPECT_EQ(reported, 1);
}

} // namespace
} // namespace trembler::test
