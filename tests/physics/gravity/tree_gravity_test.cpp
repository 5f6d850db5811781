// The gravity level "tree" in a world, compared with the level "real", which sums over all pairs.
#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/gravity/tree_gravity.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"
#include "tests/physics/gravity/mass_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler {
namespace tree_gravity_test {
namespace {

struct Body {
    double mass;
    Vec2 at;
};

// A disc of stars, denser towards its middle (sunflower spiral), with a heavy one there.
std::vector<Body> galaxy(int count) {
    std::vector<Body> bodies{{1e4, {0, 0}}};
    for (int i = 1; i < count; ++i) {
        double const radius = 50 * std::pow(static_cast<double>(i) / count, 0.8);
        double const angle = i * pi * (3 - std::sqrt(5.0));
        bodies.push_back({1.0 + i % 5, {radius * std::cos(angle), radius * std::sin(angle)}});
    }
    return bodies;
}

std::vector<Vec2> forces(std::vector<Body> const& bodies, std::string const& level, double angle,
                         int threads = 1) {
    World world(test::gravityOnly(), {.threads = threads, .detail = {{"gravity", level}}, .periods = {}});
    world.store().column<GravityLaw>().set(world.store().create("law"), {1, 0.1, angle});
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        ObjectId const id = world.store().create("body " + std::to_string(i));
        world.store().column<Position>().set(id, {bodies[i].at});
        world.store().column<Mass>().set(id, {bodies[i].mass});
    }
    world.start();
    world.step();
    std::vector<Vec2> found;
    for (GravityForce::Entry const& entry : world.find<GravityForce>()->forces) {
        found.push_back(entry.force);
    }
    return found;
}

TEST(TreeGravity, IsRealGravityWithinTheErrorOfTheOpeningAngle) {
    auto const bodies = galaxy(900);
    auto const real = forces(bodies, "real", 0);
    double before = 1;
    for (double const angle : {1.0, 0.5, 0.25, 0.0}) {
        auto const tree = forces(bodies, "tree", angle);
        ASSERT_EQ(tree.size(), real.size());
        double wrong = 0;
        double all = 0;
        for (std::size_t i = 0; i < real.size(); ++i) {
            wrong += lengthSquared(tree[i] - real[i]);
            all += lengthSquared(real[i]);
        }
        double const error = std::sqrt(wrong / all);
        EXPECT_LT(error, before) << angle;
        before = error;
    }
    EXPECT_LT(before, 1e-13) << "at the angle 0 all pairs are added up";
}

TEST(TreeGravity, NearlyConservesMomentum) {
    auto const bodies = galaxy(900);
    for (double const angle : {0.5, 0.25}) {
        Vec2 total;
        double scale = 0;
        for (Vec2 const force : forces(bodies, "tree", angle)) {
            total += force;
            scale += length(force);
        }
        EXPECT_LT(length(total), 1e-4 * scale);
    }
}

TEST(TreeGravity, AcceptsOneMassAndManyInOnePlace) {
    EXPECT_EQ(forces({{5, {1, 2}}}, "tree", 0.5), (std::vector<Vec2>{{0, 0}}));
    std::vector<Body> heap(100, Body{1e9, {1, 1}});
    for (Vec2 const force : forces(heap, "tree", 0.5)) {
        EXPECT_EQ(force, (Vec2{0, 0}));
    }
}

TEST(TreeGravity, IsPickedForManyMassesUnlessAnotherLevelIsRequested) {
    auto const levelAtWork = [](int count, std::string const& asked) {
        World world(test::gravityOnly(), {.threads = 1, .detail = {}, .periods = {}});
        world.store().column<GravityLaw>().addDefault(world.store().create("law"));
        for (int i = 0; i < count; ++i) {
            ObjectId const id = world.store().create("body " + std::to_string(i));
            world.store().column<Position>().set(id, {{1.0 * i, 0}});
            world.store().column<Mass>().set(id, {1});
        }
        world.setDetail("gravity", asked);
        world.start();
        world.step();
        for (ComponentStatus const& status : world.status()) {
            if (status.info->kind == ComponentKind::dps && status.activity != Activity::absent) {
                return std::string(status.info->text.level);
            }
        }
        return std::string("none");
    };
    int const many = static_cast<int>(TreeGravity::worthwhile);
    EXPECT_EQ(levelAtWork(many - 1, ""), "real");
    EXPECT_EQ(levelAtWork(many, ""), "tree");
    EXPECT_EQ(levelAtWork(many, "real"), "real");
    EXPECT_EQ(levelAtWork(10, "tree"), "tree");
}

TEST(TreeGravityParallel, IsTheSameBitsForAnyNumberOfThreads) {
    auto const bodies = galaxy(6000);
    auto const first = forces(bodies, "tree", 0.5);
    for (int const threads : {2, 3, 8}) {
        EXPECT_EQ(forces(bodies, "tree", 0.5, threads), first) << threads;
    }
}

// The forces depend on the positions of the masses, not on the ids of their objects.
TEST(TreeGravity, DoesNotDependOnTheOrderOfObjects) {
    auto bodies = galaxy(900);
    auto first = forces(bodies, "tree", 0.5);
    std::reverse(bodies.begin(), bodies.end());
    auto again = forces(bodies, "tree", 0.5);
    std::reverse(again.begin(), again.end());
    EXPECT_EQ(again, first);
}

} // namespace
} // namespace tree_gravity_test
} // namespace trembler
