// Joints that break, and joints whose objects are destroyed.
#include "physics/dynamics/properties/motion_causes.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

class Breaking : public OnEveryEngine {};
TREMBLER_ON_EVERY_ENGINE(Breaking);

struct ReadsJointForces final : Interaction<ReadsJointForces, DynamicsRole, Reads<JointForces>> {
    static constexpr ComponentText text{
        .name = "Dynamics <- Forces of joints", .effect = "test", .level = "", .work = "Looks."};
    using Activation = NeedsAll<>;
    void apply(Access&) {}
};

Joint ropeOf(ObjectId weight, Vec2 from, Vec2 to, double breakForce) {
    Joint joint;
    joint.form = JointForm::rope;
    joint.a = weight;
    joint.at = from;
    joint.atB = to;
    joint.breakForce = breakForce;
    return joint;
}

TEST_P(Breaking, ARopeBreaksAboveItsStrength) {
    for (double const strength : {1.02, 0.98}) {
        Scene scene;
        ObjectId const weight = scene.ball({0, -1});
        scene.give(weight, Mass{3});
        ObjectId const rope = scene.joint("rope", ropeOf(weight, {0, -1}, {0, 0}, strength * 3 * 9.81));
        scene.run(120);
        EXPECT_EQ(scene.world->store().alive(rope), strength > 1);
        EXPECT_EQ(scene.at(weight).y < -1.1, strength < 1);
    }
}

TEST_P(Breaking, TheForceOfAJointIsItsLoad) {
    for (int const substeps : {1, 4, 10}) {
        Scene scene({.solver = {.substeps = substeps},
                     .extend = [](Registry& r) { r.component<ReadsJointForces>(); }});
        ObjectId const upper = scene.ball({0, -1});
        ObjectId const lower = scene.ball({0, -2});
        scene.give(upper, Mass{3});
        scene.give(lower, Mass{2});
        scene.joint("rope 1", ropeOf(upper, {0, -1}, {0, 0}, 0));
        Joint second = ropeOf(lower, {0, -2}, {0, -1}, 0);
        second.b = upper;
        scene.joint("rope 2", second);
        scene.run(60);
        auto const& forces = scene.world->find<JointForces>()->entries;
        ASSERT_EQ(forces.size(), 2U);
        EXPECT_NEAR(length(forces[0].force), 5 * 9.81, 0.1);
        EXPECT_NEAR(length(forces[1].force), 2 * 9.81, 0.1);
    }
}

TEST_P(Breaking, TheTraceLeadsFromTheBreakToThePull) {
    Scene scene({.trace = true});
    scene.gravity = 0;
    ObjectId const weight = scene.ball({0, -1});
    ObjectId const rope = scene.joint("rope", ropeOf(weight, {0, -1}, {0, 0}, 10));
    Pull pull;
    pull.force = {0, -50};
    scene.give(weight, pull);
    scene.run(10);
    EXPECT_FALSE(scene.world->store().alive(rope));
    Tracer const& tracer = *scene.world->tracer();
    bool found = false;
    for (Event const& event : tracer.events()) {
        if (event.event == "destroyed") {
            std::set<std::string> whats;
            for (EventId const id : tracer.chain(event.id)) {
                whats.insert(tracer.find(id)->event);
            }
            found = whats.contains("joint overloaded") && whats.contains("addForce");
        }
    }
    EXPECT_TRUE(found);
}

TEST_P(Breaking, JointsAreRemovedWithTheirObjectsAndGearsWithTheirJoints) {
    Scene scene;
    ObjectId const a = scene.ball({0, 0});
    ObjectId const b = scene.ball({1, 0});
    auto const hinge = [&](ObjectId object, Vec2 at) {
        Joint joint;
        joint.a = object;
        joint.at = at;
        return joint;
    };
    ObjectId const axleA = scene.joint("axle a", hinge(a, {0, 0}));
    ObjectId const axleB = scene.joint("axle b", hinge(b, {1, 0}));
    Joint gear;
    gear.form = JointForm::gear;
    gear.a = a;
    gear.b = b;
    gear.jointA = axleA;
    gear.jointB = axleB;
    ObjectId const coupling = scene.joint("coupling", gear);
    scene.run(5);
    scene.world->feed({.kind = PlayerInput::Kind::remove, .object = a, .other = {}, .at = {}});
    scene.run(6);
    EXPECT_FALSE(scene.world->store().alive(a));
    EXPECT_FALSE(scene.world->store().alive(axleA));
    EXPECT_FALSE(scene.world->store().alive(coupling));
    EXPECT_TRUE(scene.world->store().alive(axleB));
    scene.run(30);
    EXPECT_NEAR(length(scene.at(b) - Vec2{1, 0}), 0, 1e-3);
}

} // namespace
} // namespace trembler::test
