// Automatic settings follow from the scene, and change with it.
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/motion_causes.hpp"
#include "physics/dynamics/properties/solver_choice.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::test {
namespace {

// Our own engine chooses its substeps by itself: this is what the program chooses for Box2D.
class Automatic : public ::testing::Test {
protected:
    WithEngine const box2d{"box2d"};
    [[nodiscard]] static SolverChoice choiceOf(Scene const& scene) {
        return *scene.world->find<SolverChoice>();
    }
    static ObjectId hinge(Scene& scene, std::string const& name, ObjectId a, ObjectId b, Vec2 at) {
        Joint joint;
        joint.a = a;
        joint.b = b;
        joint.at = at;
        return scene.joint(name, joint);
    }
    /// Links of 1 kg and 0.2 m hang from the world, a ball of that mass (kg) at their end. Returns the ball.
    static ObjectId chain(Scene& scene, int links, double ball, std::vector<ObjectId>* joints = nullptr) {
        ObjectId above;
        for (int i = 0; i <= links; ++i) {
            Vec2 const top{0, -0.2 * i};
            bool const last = i == links;
            std::string const name = std::to_string(100 + i);
            ObjectId const id = last ? scene.body("ball", circlePiece(0.1), top)
                                     : scene.body("link " + name, boxPiece(0.05, 0.2), top - Vec2{0, 0.1});
            scene.give(id, Mass{last ? ball : 1});
            scene.give(id, CollisionGroups{.category = 1, .mask = 0xffff, .group = -1});
            ObjectId const joint = hinge(scene, "joint " + name, id, above, top);
            if (joints != nullptr) {
                joints->push_back(joint);
            }
            above = id;
        }
        return above;
    }
};

TEST_F(Automatic, AnOrdinarySceneGetsFourSubsteps) {
    Scene scene;
    scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    for (int i = 0; i < 4; ++i) {
        scene.body("box " + std::to_string(i), boxPiece(0.2, 0.2), {0, 0.1 + 0.2 * i});
    }
    scene.run(30);
    EXPECT_EQ(choiceOf(scene).substeps, 4);
    EXPECT_EQ(choiceOf(scene).scale, 4);
    EXPECT_FALSE(choiceOf(scene).jointsAtOnce);
}

TEST_F(Automatic, ObjectsWithoutABodyNeedNoSubsteps) {
    Scene scene;
    scene.ball({0, 0});
    ObjectId const ghost = scene.world->store().create("ghost");
    scene.give(ghost, Position{});
    scene.give(ghost, Velocity{{1e4, 0}});
    scene.give(ghost, AngularVelocity{1e4});
    scene.run(2);
    EXPECT_EQ(choiceOf(scene).substeps, 4);
}

// A link of length l between joints under the tension T oscillates in a zigzag with ω² = 12 T / (m l); two
// substeps for each radian.
TEST_F(Automatic, ATautChainGetsSubstepsByItsZigzagWhileItIsLoaded) {
    Scene scene;
    ObjectId const ball = chain(scene, 10, 2000);
    scene.run(2);
    // The width of a link adds to its moment of inertia.
    double const inertia = (0.2 * 0.2 + 0.05 * 0.05) / 12;
    double const omega = std::sqrt((2000 + 9) * 9.81 * 0.2 / inertia);
    EXPECT_GE(choiceOf(scene).substeps, omega / 60);
    EXPECT_LE(choiceOf(scene).substeps, 1.5 * omega / 60 + 1);
    EXPECT_TRUE(choiceOf(scene).jointsAtOnce);
    scene.of<Mass>(ball).value = 1;
    scene.run(2);
    EXPECT_EQ(choiceOf(scene).substeps, 4);
    EXPECT_FALSE(choiceOf(scene).jointsAtOnce);
}

// The tension follows from the acting forces, not from the masses and a constant of nature.
TEST_F(Automatic, OnTheMoonAChainIsAsTautAsItsWeightThere) {
    std::vector<int> found;
    for (double const g : {9.81, 1.62}) {
        Scene scene;
        scene.gravity = g;
        chain(scene, 10, 20000);
        scene.run(2);
        double const omega = std::sqrt((20000 + 9) * g * 0.2 / ((0.2 * 0.2 + 0.05 * 0.05) / 12));
        found.push_back(choiceOf(scene).substeps);
        EXPECT_GE(found.back(), std::min(64.0, omega / 60)) << g;
        EXPECT_LE(found.back(), 1.5 * omega / 60 + 1) << g;
    }
    EXPECT_LT(found[1], found[0]);
}

TEST_F(Automatic, AnUnloadedChainIsNotTaut) {
    Scene scene;
    scene.gravity = 0;
    chain(scene, 10, 2000);
    scene.run(10);
    EXPECT_EQ(choiceOf(scene).substeps, 4);
    EXPECT_FALSE(choiceOf(scene).jointsAtOnce);
}

TEST_F(Automatic, AnyForceOnAChainMakesItTaut) {
    Scene scene;
    scene.gravity = 0;
    ObjectId const ball = chain(scene, 10, 1);
    scene.run(2);
    EXPECT_EQ(choiceOf(scene).substeps, 4);
    scene.give(ball, Pull{.force = {0, -20000}});
    scene.run(2);
    double const omega = std::sqrt(20000 * 0.2 / ((0.2 * 0.2 + 0.05 * 0.05) / 12));
    EXPECT_GE(choiceOf(scene).substeps, omega / 60);
    EXPECT_LE(choiceOf(scene).substeps, 1.5 * omega / 60 + 1);
}

TEST_F(Automatic, JointsSolvedAtOnceCarryTheirLoad) {
    Scene scene;
    std::vector<ObjectId> joints;
    chain(scene, 60, 500, &joints);
    Subscription const wantedJointForces = scene.world->want<JointForces>();
    scene.run(3);
    ASSERT_TRUE(choiceOf(scene).jointsAtOnce);
    auto const& entries = scene.world->find<JointForces>()->entries;
    ASSERT_EQ(entries.size(), joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        double const weight = (500 + 60 - static_cast<double>(i)) * 9.81;
        auto const entry = std::find_if(entries.begin(), entries.end(),
                                        [&](auto const& one) { return one.joint == joints[i]; });
        ASSERT_NE(entry, entries.end());
        EXPECT_NEAR(entry->force.y / weight, 1, 0.001) << i;
        EXPECT_NEAR(entry->force.x / weight, 0, 0.001) << i;
    }
    // Nothing moves, not even in the first frame under the load.
    scene.run(120);
    EXPECT_LT(length(scene.velocity(scene.world->store().find("ball"))), 1e-3);
}

TEST_F(Automatic, SmallBodiesAreScaledUp) {
    Scene scene;
    scene.body("small", boxPiece(0.01, 0.1), {0, 0});
    scene.run(1);
    EXPECT_EQ(choiceOf(scene).scale, 8);
    Scene heap;
    for (int i = 0; i < 20; ++i) {
        heap.body("small " + std::to_string(i), boxPiece(0.02, 0.1), {1.0 * i, 0});
    }
    heap.run(1);
    EXPECT_EQ(choiceOf(heap).scale, 32);
}

TEST_F(Automatic, FastBodiesGetShortSteps) {
    Scene scene;
    ObjectId const ball = scene.ball({0, 0});
    scene.give(ball, Velocity{{300, 0}});
    scene.run(1);
    // Box2D limits motion to 2 of its units in a step; a unit is a quarter of a metre here.
    EXPECT_GE(choiceOf(scene).substeps, 300 / 60.0 * 4 / 2);
    EXPECT_NEAR(scene.at(ball).x, 5, 0.01);
}

TEST_F(Automatic, AWeightOnALightBodyGetsSubstepsWhenItTouches) {
    Scene scene;
    scene.fixed("floor", boxPiece(10, 1), {0, -0.5});
    scene.give(scene.body("light", boxPiece(0.5, 0.5), {0, 0.25}), Mass{1});
    scene.give(scene.body("heavy", boxPiece(0.5, 0.5), {0, 0.85}), Mass{1000});
    scene.run(2);
    EXPECT_EQ(choiceOf(scene).substeps, 4);
    scene.run(58);
    EXPECT_GE(choiceOf(scene).substeps, 12);
}

// A body pressed against a wall, or up against a ceiling, counts as well.
TEST_F(Automatic, AWeightCountsInAnyDirectionOfItsForce) {
    for (Vec2 const way : {Vec2{0, -1}, Vec2{1, 0}, Vec2{0, 1}}) {
        for (double const g : {9.81, 1.62}) {
            Scene scene;
            scene.gravity = 0;
            scene.fixed("wall", boxPiece(10, 1), 0.5 * way, std::atan2(way.x, way.y));
            ObjectId const light = scene.body("light", boxPiece(0.5, 0.5), -0.25 * way);
            ObjectId const heavy = scene.body("heavy", boxPiece(0.5, 0.5), -0.85 * way);
            scene.give(light, Mass{1});
            scene.give(heavy, Mass{1000});
            scene.give(light, Pull{.acceleration = g * way});
            scene.give(heavy, Pull{.acceleration = g * way});
            scene.run(2);
            EXPECT_EQ(choiceOf(scene).substeps, 4);
            scene.run(98);
            EXPECT_GE(choiceOf(scene).substeps, 12) << way.x << " " << way.y << " " << g;
        }
    }
}

TEST_F(Automatic, ABodyThatOnlyTouchesIsNoWeight) {
    Scene scene;
    scene.gravity = 0;
    scene.give(scene.body("light", boxPiece(0.5, 0.5), {0, 0.25}), Mass{1});
    scene.give(scene.body("heavy", boxPiece(0.5, 0.5), {0, 0.75}), Mass{1000});
    scene.run(30);
    EXPECT_EQ(choiceOf(scene).substeps, 4);
}

TEST_F(Automatic, AFixedNumberOfSubstepsIsKept) {
    Scene::Options options;
    options.solver.substeps = 2;
    Scene scene(options);
    chain(scene, 40, 1000);
    scene.run(2);
    EXPECT_EQ(choiceOf(scene).substeps, 2);
    EXPECT_FALSE(choiceOf(scene).jointsAtOnce);
}

TEST_F(Automatic, IsTheSameOnAnyNumberOfThreads) {
    std::vector<std::uint64_t> hashes;
    for (int const threads : {1, 2, 4}) {
        Scene::Options options;
        options.threads = threads;
        Scene scene(options);
        ObjectId const ball = chain(scene, 40, 300);
        scene.give(ball, Velocity{{3, 0}});
        scene.run(120);
        EXPECT_TRUE(choiceOf(scene).jointsAtOnce);
        hashes.push_back(scene.world->stateHash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

// Contacts are solved after the joints, without their solution: both together must be stable.
TEST_F(Automatic, AChainThatIsSolvedAtOnceFallsOnTheGroundWithoutTearing) {
    Scene scene;
    scene.fixed("floor", boxPiece(40, 1), {0, -0.5});
    scene.fixed("block", boxPiece(1, 1), {3, 0.5});
    ObjectId before;
    std::vector<ObjectId> links;
    for (int i = 0; i < 40; ++i) {
        links.push_back(scene.body("link " + std::to_string(100 + i), boxPiece(0.2, 0.05), {0.2 * i, 2}));
        if (i > 0) {
            hinge(scene, "joint " + std::to_string(100 + i), links.back(), before, {0.2 * i - 0.1, 2});
        }
        before = links.back();
    }
    scene.run(2);
    ASSERT_TRUE(choiceOf(scene).jointsAtOnce);
    scene.run(900);
    for (std::size_t i = 0; i < links.size(); ++i) {
        // On the block's edges it slides to and fro by 0.1 to 0.3 m/s, also if joints are solved one by one.
        EXPECT_LT(length(scene.velocity(links[i])), 0.25) << i;
        EXPECT_GT(scene.at(links[i]).y, 0.015) << i;
        if (i > 0) {
            Vec2 const end = scene.at(links[i - 1]) + rotated({0.1, 0}, scene.angle(links[i - 1]));
            Vec2 const start = scene.at(links[i]) + rotated({-0.1, 0}, scene.angle(links[i]));
            EXPECT_LT(length(end - start), 0.005) << i;
        }
    }
}

// A chain held at both ends, with a weight thrown at its middle: a joint must carry, a contact must hold.
TEST_F(Automatic, AWeightComesToRestOnAChainThatIsSolvedAtOnce) {
    Scene scene;
    ObjectId before;
    for (int i = 0; i < 40; ++i) {
        ObjectId const link =
            scene.body("link " + std::to_string(100 + i), boxPiece(0.2, 0.05), {0.2 * i - 3.9, 0});
        scene.give(link, Mass{2});
        hinge(scene, "joint " + std::to_string(100 + i), link, before, {0.2 * i - 4, 0});
        before = link;
    }
    hinge(scene, "last", before, {}, {4, 0});
    ObjectId const weight = scene.body("weight", boxPiece(0.5, 0.5), {0, 1});
    scene.give(weight, Mass{100});
    scene.give(weight, Damping{0.5, 0.5});
    scene.run(1500);
    ASSERT_TRUE(choiceOf(scene).jointsAtOnce);
    EXPECT_LT(length(scene.velocity(weight)), 0.05);
    EXPECT_GT(scene.at(weight).y, -1) << "it should lie on the chain";
}

// A body welded to a wall stays level under any weight that is welded to it.
TEST_F(Automatic, WeldsSolvedAtOnceDoNotSag) {
    Scene scene;
    ObjectId before;
    ObjectId plank;
    for (int i = 0; i < 12; ++i) {
        plank = scene.body("plank " + std::to_string(100 + i), boxPiece(0.5, 0.1), {0.5 * i + 0.25, 0});
        Joint joint;
        joint.form = JointForm::weld;
        joint.a = plank;
        joint.b = before;
        joint.at = {0.5 * i, 0};
        scene.joint("weld " + std::to_string(100 + i), joint);
        before = plank;
    }
    scene.run(300);
    EXPECT_TRUE(choiceOf(scene).jointsAtOnce);
    EXPECT_NEAR(scene.at(plank).y, 0, 0.01);
    EXPECT_NEAR(scene.angle(plank), 0, 0.01);
}

} // namespace
} // namespace trembler::test
