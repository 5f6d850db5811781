// Dynamics around an engine: the settings for its calls, and the behaviour after its failure.
#include "physics/dynamics/core/simulation.hpp"
#include "runtime/component/component.hpp"
#include "tests/physics/dynamics/core/hand_columns.hpp"
#include "tests/physics/dynamics/core/recording_engine.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace trembler::test {
namespace simulation_test {
namespace {

/// The engines that were made since the last begin(), by the names of their makers and their scales.
struct Made {
    std::string by;
    double scale;
};
std::vector<Made>& made() {
    static std::vector<Made> all;
    return all;
}
RecordingEngine*& latest() {
    static RecordingEngine* engine = nullptr;
    return engine;
}
std::unique_ptr<Engine> make(std::string const& by, double scale) {
    made().push_back({by, scale});
    auto engine = std::make_unique<RecordingEngine>();
    engine->isAwake = {1};
    latest() = engine.get();
    return engine;
}
std::unique_ptr<Engine> first(double scale) {
    return make("first", scale);
}
std::unique_ptr<Engine> standIn(double scale) {
    return make("stand-in", scale);
}

class SimulationTest : public ::testing::Test {
protected:
    void SetUp() override { made().clear(); }
    /// A frame, or a part of one.
    bool step(double duration = frameDuration) {
        refused = simulation.follow(columns.view());
        if (simulation.loadsStale()) {
            simulation.startLoads();
            simulation.endLoads();
        }
        return simulation.step(duration, columns.view(), {});
    }
    void settings(DynamicsSettings const& stated) { columns.settings.set({99, 0}, stated); }

    HandColumns columns;
    Simulation simulation{first, "first level", standIn};
    std::vector<Refusal> refused;
};

TEST_F(SimulationTest, TheEngineIsNotCalledIfAllBodiesRest) {
    static_cast<void>(columns.body(0));
    EXPECT_TRUE(step());
    EXPECT_EQ(latest()->steps.size(), 1U);
    latest()->isAwake = {0};
    EXPECT_FALSE(step());
    EXPECT_EQ(latest()->steps.size(), 1U);
    EXPECT_FALSE(simulation.anyAwake());
    EXPECT_EQ(made().size(), 1U) << "one engine for all frames";
}

TEST_F(SimulationTest, StatedSubstepsAreDividedAmongTheParts) {
    static_cast<void>(columns.body(0));
    DynamicsSettings stated;
    stated.substeps = 6;
    stated.velocityIterations = 11;
    stated.scale = 16;
    settings(stated);
    struct Case {
        double duration;
        int substeps;
    };
    for (Case const& c : {Case{frameDuration, 6}, Case{frameDuration / 2, 3}, Case{frameDuration / 4, 2},
                          Case{frameDuration / 8, 1}, Case{3 * frameDuration, 6}}) {
        ASSERT_TRUE(step(c.duration));
        RecordingEngine::Step const& last = latest()->steps.back();
        EXPECT_EQ(last.duration, c.duration);
        EXPECT_EQ(last.settings.substeps, c.substeps) << c.duration;
        EXPECT_EQ(last.settings.velocityIterations, 11);
        EXPECT_DOUBLE_EQ(simulation.lag().step, c.duration / c.substeps);
        EXPECT_DOUBLE_EQ(simulation.lag().turn, c.duration);
    }
    EXPECT_EQ(made().back().scale, 16);
}

// Within a step no body may move by more than 2 units of Box2D, nor turn by more than a quarter.
TEST_F(SimulationTest, FastBodiesGetSubstepsThatLimitTheirMotion) {
    EXPECT_TRUE(rc::check("neither farther nor wider than Box2D allows", [&] {
        HandColumns scene;
        Simulation fresh(first, "first level", standIn);
        auto const speed = [](double most) { return *rc::gen::inRange(-1000, 1001) * most / 1000; };
        for (std::uint32_t i = 0; i < 3; ++i) {
            ObjectId const id = scene.body(i);
            scene.velocity.set(id, Velocity{{speed(200), speed(200)}});
            scene.spin.set(id, AngularVelocity{speed(80)});
        }
        // Fixed bodies and objects without a body do not count.
        scene.fixed.set(scene.body(3), {});
        scene.velocity.set({3, 0}, Velocity{{9e3, 0}});
        scene.velocity.set({4, 0}, Velocity{{9e3, 0}});
        static_cast<void>(fresh.follow(scene.view()));
        fresh.startLoads();
        fresh.endLoads();
        RC_ASSERT(fresh.step(frameDuration, scene.view(), {}));
        DynamicsSettings const& with = latest()->steps.back().settings;
        RC_ASSERT(with.substeps >= 4 && with.substeps <= 64);
        double const h = frameDuration / with.substeps;
        double fastest = 0;
        double widest = 0;
        for (std::uint32_t i = 0; i < 3; ++i) {
            fastest = std::max(fastest, length(scene.velocity[{i, 0}].value));
            widest = std::max(widest, std::abs(scene.spin[{i, 0}].value));
        }
        RC_ASSERT(with.substeps == 64 || fastest * h * with.scale <= 2);
        RC_ASSERT(with.substeps == 64 || widest * h <= std::acos(-1.0) / 2);
        // The number is not much greater than needed.
        RC_ASSERT(with.substeps <= 4 || fastest * h * with.scale > 0.4 || widest * h > 0.4);
        RC_ASSERT(fresh.choice().substeps == with.substeps);
    }));
}

TEST_F(SimulationTest, AnAutomaticUnitOfLengthIsKeptWhileBodiesMove) {
    ObjectId const big = columns.body(0);
    columns.shape.set(big, Shape{{circlePiece(2)}});
    EXPECT_TRUE(step());
    double const scale = made().back().scale;
    ObjectId const small = columns.body(1);
    columns.shape.set(small, Shape{{circlePiece(0.006)}});
    for (std::uint32_t i = 2; i < 9; ++i) {
        columns.shape.set(columns.body(i), Shape{{circlePiece(0.006)}});
    }
    EXPECT_TRUE(step());
    EXPECT_EQ(made().size(), 1U);
    // In a new simulation, the same bodies get a unit that suits small ones.
    Simulation fresh(first, "first level", standIn);
    static_cast<void>(fresh.follow(columns.view()));
    EXPECT_GT(made().back().scale, scale);
    // A stated unit counts at once, and its engine gets every body.
    DynamicsSettings stated;
    stated.scale = 32;
    settings(stated);
    EXPECT_TRUE(step());
    EXPECT_EQ(made().back().scale, 32);
    EXPECT_EQ(latest()->added.size(), 9U);
}

TEST_F(SimulationTest, InvalidObjectsAreRefusedOnceAndNotInEveryFrame) {
    static_cast<void>(columns.body(0));
    ObjectId const bad = columns.body(1);
    columns.mass.set(bad, Mass{-1});
    step();
    ASSERT_EQ(refused.size(), 1U);
    EXPECT_EQ(refused[0].object, bad);
    step();
    EXPECT_TRUE(refused.empty()) << "refused again only after a change";
    static_cast<void>(columns.body(2));
    EXPECT_FALSE(simulation.loadsStale());
    refused = simulation.follow(columns.view());
    EXPECT_EQ(refused.size(), 1U);
    EXPECT_TRUE(simulation.loadsStale()) << "a body was added";
    columns.mass.set(bad, Mass{1});
    step();
    EXPECT_TRUE(refused.empty());
    EXPECT_NE(simulation.bodies().slotOf(bad), noSlot);
}

TEST_F(SimulationTest, RatesAreTheGreatestOfBodiesThatMove) {
    ObjectId const a = columns.body(0);
    ObjectId const b = columns.body(1);
    ObjectId const wall = columns.body(2);
    columns.fixed.set(wall, {});
    step();
    simulation.startLoads();
    EXPECT_EQ(simulation.rates(), ForceRates{});
    simulation.noteRate({.object = wall, .rate = 100});
    simulation.noteRate({.object = {7, 0}, .rate = 100});
    simulation.noteRate({.object = a, .rate = std::numeric_limits<double>::infinity()});
    simulation.noteRate({.object = a, .rate = std::nan("")});
    EXPECT_EQ(simulation.rates(), ForceRates{}) << "no movable body, or not a finite number";
    simulation.noteRate({.object = a, .rate = 5, .foreseen = false, .swings = true});
    simulation.noteRate({.object = b, .rate = 8, .foreseen = true, .swings = true});
    simulation.noteRate({.object = b, .rate = 9, .foreseen = true, .swings = false});
    ForceRates const& rates = simulation.rates();
    EXPECT_EQ(rates.greatest, 9);
    EXPECT_EQ(rates.object, b);
    EXPECT_EQ(rates.unforeseen, 5);
    EXPECT_EQ(rates.swinging, 8);
    EXPECT_EQ(rates.ahead, 8);
    simulation.startLoads();
    EXPECT_EQ(simulation.rates(), ForceRates{});
}

TEST_F(SimulationTest, AnEngineThatFailsIsReplacedAndThenBodiesStandStill) {
    ObjectId const a = columns.body(0);
    ObjectId const b = columns.body(1);
    ObjectId const c = columns.body(2);
    EXPECT_TRUE(step());
    simulation.giveUp(EngineFailure("out of range"));
    EXPECT_EQ(simulation.state().gaveUp, "first level");
    EXPECT_EQ(simulation.state().why, "out of range");
    EXPECT_TRUE(simulation.state().stopped.empty());
    EXPECT_FALSE(simulation.anyAwake()) << "there is no engine before the next follow()";
    EXPECT_TRUE(step());
    EXPECT_EQ(made().back().by, "stand-in");
    EXPECT_EQ(latest()->added.size(), 3U);
    // The replacement fails for one body: this body stands still.
    latest()->hasLost = {simulation.bodies().slotOf(b)};
    simulation.giveUp(EngineFailure("lost a body"));
    EXPECT_EQ(simulation.state().stopped, std::vector<ObjectId>{b});
    EXPECT_EQ(simulation.state().why, "out of range") << "the first reason is kept";
    EXPECT_TRUE(step());
    EXPECT_TRUE(latest()->specs[simulation.bodies().slotOf(b)].fixed);
    EXPECT_FALSE(latest()->specs[simulation.bodies().slotOf(a)].fixed);
    // Without knowing which body failed, all of them stand still.
    simulation.giveUp(EngineFailure("again"));
    EXPECT_EQ(simulation.state().stopped, (std::vector<ObjectId>{a, b, c}));
    static_cast<void>(simulation.follow(columns.view()));
    EXPECT_THROW(simulation.giveUp(EngineFailure("at rest")), std::runtime_error);
}

TEST_F(SimulationTest, ContinuesFromTheStateOfAnEarlierOne) {
    ObjectId const a = columns.body(0);
    simulation.takeOver({.gaveUp = "first level", .why = "earlier", .stopped = {a}});
    step();
    EXPECT_EQ(made().back().by, "stand-in");
    EXPECT_TRUE(latest()->specs[0].fixed);
    Simulation other(first, "another level", standIn);
    other.takeOver({.gaveUp = "first level", .why = "earlier", .stopped = {}});
    static_cast<void>(other.follow(columns.view()));
    EXPECT_EQ(made().back().by, "first") << "another engine had failed";
}

TEST_F(SimulationTest, ABodyAtANonFinitePlaceIsAFailure) {
    static_cast<void>(columns.body(0));
    step();
    double const nan = std::nan("");
    for (Motion const& motion :
         {Motion{{nan, 0}, 0, {}, 0}, Motion{{}, nan, {}, 0}, Motion{{}, 0, {0, nan}, 0},
          Motion{{}, 0, {}, std::numeric_limits<double>::infinity()}}) {
        latest()->hasMoved = {{0, motion}};
        EXPECT_THROW(step(), EngineFailure);
    }
    latest()->hasMoved = {{0, Motion{}}};
    EXPECT_TRUE(step());
}

} // namespace
} // namespace simulation_test
} // namespace trembler::test
