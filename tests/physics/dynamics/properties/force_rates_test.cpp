// Rates and lags of forces: as stated by interactions, as combined by Dynamics, as offered to readers.
#include "physics/dynamics/properties/force_lag.hpp"
#include "physics/dynamics/properties/force_rates.hpp"
#include "physics/dynamics/properties/solver_choice.hpp"
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace trembler::test {
namespace {

/// The rates of the forces on an object, stated by the test.
struct Varying {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Varying", "test_varying", "How fast a force varies, for tests.",
                                       PropertyPlace::hidden};
    double rate = 0; ///< 1/s
    bool foreseen = false;
};
class DynamicsFromVarying final : public Interaction<DynamicsFromVarying, DynamicsRole, Reads<Varying>> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics <- Varying", .effect = "test", .level = "", .work = "States rates."};
    using Activation = NeedsAll<Varying>;
    void apply(Access& access) {
        auto const& all = access.read<Varying>();
        for (std::size_t row = 0; row < all.size(); ++row) {
            access.call(StateRate{all.owners()[row], all.values()[row].rate, all.values()[row].foreseen});
        }
    }
};

struct RateScene : Scene {
    explicit RateScene(Options options = {})
        : Scene([&] {
              options.extend = [](Registry& registry) { registry.component<DynamicsFromVarying>(); };
              return options;
          }()) {}
    [[nodiscard]] ForceRates rates() const { return *world->find<ForceRates>(); }
    [[nodiscard]] int substeps() const { return world->find<SolverChoice>()->substeps; }
};

TEST(ForceRates, AreTheGreatestStatedForMovableBodies) {
    RateScene scene;
    ObjectId const slow = scene.ball({0, 0});
    ObjectId const fast = scene.ball({5, 0});
    ObjectId const wall = scene.fixed("wall", boxPiece(1, 1), {9, 0});
    ObjectId const ghost = scene.world->store().create("ghost");
    scene.give(slow, Varying{3, false});
    scene.give(fast, Varying{7, true});
    scene.give(wall, Varying{100, false});
    scene.give(ghost, Varying{200, false});
    scene.run(1);
    EXPECT_EQ(scene.rates(), (ForceRates{})) << "interactions make their first calls at the end of frame 1";
    scene.run(1);
    EXPECT_EQ(scene.rates(), (ForceRates{7, 3, fast, 7, 7}));
    scene.of<Varying>(slow).rate = std::numeric_limits<double>::infinity();
    scene.of<Varying>(fast).foreseen = false;
    scene.run(2);
    EXPECT_EQ(scene.rates(), (ForceRates{7, 7, fast, 7, 0})) << "rates that are not finite do not count";
    scene.world->store().column<Varying>().remove(fast);
    scene.world->store().column<Varying>().remove(slow);
    scene.run(2);
    EXPECT_EQ(scene.rates(), (ForceRates{}));
}

// With substeps, a held force would lag behind; the usual 4 are for contacts and joints.
TEST(ForceRates, FreeBodiesUnderAVaryingForceGetOneStep) {
    WithEngine const box2d("box2d");
    for (bool const foreseen : {false, true}) {
        RateScene scene;
        ObjectId const ball = scene.ball({0, 0});
        scene.run(2);
        EXPECT_EQ(scene.substeps(), 4) << "constant forces do not lag";
        scene.give(ball, Varying{1, foreseen});
        scene.run(3);
        EXPECT_EQ(scene.substeps(), foreseen ? 4 : 1);
        Joint joint;
        joint.a = scene.body("held", boxPiece(1, 1), {20, 0});
        joint.at = {20, 0};
        ObjectId const hinge = scene.joint("hinge", joint);
        scene.world->store().complete(joint.a);
        scene.world->store().complete(hinge);
        scene.run(1);
        EXPECT_EQ(scene.substeps(), 4) << "joints need more";
    }
}

TEST(ForceRates, TouchingBodiesGetSubsteps) {
    RateScene scene;
    scene.fixed("floor", boxPiece(20, 1), {0, -0.5});
    ObjectId const box = scene.body("box", boxPiece(0.5, 0.5), {0, 0.25});
    scene.give(box, Varying{1, false});
    scene.run(10);
    EXPECT_EQ(scene.substeps(), 4);
}

TEST(ForceLag, IsThatOfTheSemiImplicitEulerMethodInSubsteps) {
    WithEngine const box2d("box2d");
    for (int const substeps : {1, 2, 4, 16}) {
        Scene::Options options;
        options.solver.substeps = substeps;
        Scene scene(options);
        scene.ball({0, 0});
        scene.run(1);
        ForceLag const lag = *scene.world->find<ForceLag>();
        EXPECT_DOUBLE_EQ(lag.turn, frameDuration);
        EXPECT_DOUBLE_EQ(lag.ofTurn(), frameDuration / 2 * (1 - 1.0 / substeps)) << substeps;
        EXPECT_DOUBLE_EQ(lag.of(3 * frameDuration), 3 * frameDuration / 2 * (1 - 1.0 / (3 * substeps)));
    }
    EXPECT_EQ(ForceLag{}.ofTurn(), 0) << "nothing lags without moving bodies";
}

TEST(ForceLag, IsHalfOfTheTimeIfConstantForcesAreExact) {
    WithEngine const native("native");
    for (int const substeps : {1, 4}) {
        Scene::Options options;
        options.solver.substeps = substeps;
        Scene scene(options);
        scene.ball({0, 0});
        scene.run(1);
        ForceLag const lag = *scene.world->find<ForceLag>();
        EXPECT_DOUBLE_EQ(lag.ofTurn(), frameDuration / 2);
        EXPECT_DOUBLE_EQ(lag.of(3 * frameDuration), 3 * frameDuration / 2);
    }
}

} // namespace
} // namespace trembler::test
