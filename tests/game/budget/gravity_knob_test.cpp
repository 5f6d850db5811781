// Estimated errors of gravity's options, compared with Newton's law for two bodies and the sum over all
// pairs.
#include "physics/dynamics/properties/body.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/placement.hpp"
#include "tests/game/budget/knob_kit.hpp"

#include <cmath>

namespace trembler::budget {
namespace gravity_knob_test {
namespace {

class GravityKnob : public KnobTest {};

TEST_F(GravityKnob, EstimatesAgreeWithTheSumOverAllPairs) {
    open(starDisc(gameData(), 300));
    session().setDetail("gravity", "tree");
    runTo(30);
    auto const knob = gravityKnob(world());
    ASSERT_TRUE(knob);
    EXPECT_EQ(knob->options[knob->current].name, "tree, opening angle 0.35");
    // The tree's forces as the world has computed them, for the present positions.
    GravityForce const& found = *world().find<GravityForce>();
    auto const& positions = *world().store().findColumn<Position>();
    auto const& masses = *world().store().findColumn<Mass>();
    double wrong = 0;
    double all = 0;
    double off = 0;
    for (GravityForce::Entry const& entry : found.forces) {
        Vec2 right;
        for (ObjectId const other : masses.owners()) {
            Vec2 const r = positions[other].value - positions[entry.object].value;
            double const d = std::sqrt(lengthSquared(r) + 0.25);
            right += masses[entry.object].value * masses[other].value / (d * d * d) * r;
        }
        wrong += lengthSquared(entry.force - right);
        off += lengthSquared(entry.force - right) / std::pow(2 * masses[entry.object].value, 2);
        all += lengthSquared(right);
    }
    double const share = std::sqrt(wrong / all);
    double const metres = std::sqrt(off / static_cast<double>(found.forces.size()));
    Error const estimate = knob->options[knob->current].error;
    EXPECT_GT(estimate.share, 0.3 * share);
    EXPECT_LT(estimate.share, 3 * share);
    EXPECT_GT(estimate.metres, 0.3 * metres);
    EXPECT_LT(estimate.metres, 3 * metres);
    // Wider angles have larger errors, and so have longer periods.
    auto const off2 = [&](std::string const& name) { return named(*knob, name).error.metres; };
    EXPECT_EQ(off2("real"), 0);
    EXPECT_LT(off2("tree, opening angle 0.15"), off2("tree, opening angle 0.7"));
    EXPECT_LT(off2("real, every 2 frames"), off2("real, every 4 frames"));
}

TEST_F(GravityKnob, EveryOptionCanBeMadeAndIsThenTheCurrentOne) {
    open(starDisc(gameData(), 60));
    runTo(2);
    expectOptionsAreMade(gravityKnob);
}

// Two masses in an external field: linear gravity computes the field alone.
TEST_F(GravityKnob, LinearGravityErrsByTheForcesBetweenTwoMasses) {
    open(levelOf(R"("world": {"gravity": [0, -1], "gravity_law": {"constant": 2, "softening": 1e-6}},
        "objects": [
        {"name": "a", "at": [0, 0], "properties": {"shape": [{"form": "circle", "radius": 0.05}], "mass": 3}},
        {"name": "b", "at": [4, 0], "properties": {"shape": [{"form": "circle", "radius": 0.05}], "mass": 5}}])"));
    runTo(1);
    auto const knob = gravityKnob(world());
    ASSERT_TRUE(knob);
    Vec2 const between = at("b") - at("a");
    Vec2 const along = between / length(between);
    Vec2 const onA = 2 * 5 / lengthSquared(between) * along; // m/s²
    Vec2 const onB = -2 * 3 / lengthSquared(between) * along;
    Vec2 const field{0, -1};
    Error const error = named(*knob, "linear").error;
    // An acceleration displaces by half its value in the first second.
    EXPECT_NEAR(error.metres, std::sqrt((lengthSquared(field - onA) + lengthSquared(field - onB)) / 2) / 2,
                1e-6);
    EXPECT_NEAR(error.share,
                std::sqrt((9 * lengthSquared(field - onA) + 25 * lengthSquared(field - onB)) /
                          (9 * lengthSquared(onA) + 25 * lengthSquared(onB))),
                1e-6);
    EXPECT_EQ(named(*knob, "real").error.metres, 0);
    EXPECT_LT(named(*knob, "tree, opening angle 0.7").error.metres, 1e-9) << "two masses are no cluster";
}

// The force on a body that passes another one depends on the time at which it is computed.
TEST_F(GravityKnob, AHeldForceErrsByTheMotionMeanwhile) {
    open(levelOf(R"("world": {"gravity_law": {"constant": 10, "softening": 1e-6}}, "objects": [
        {"name": "sun", "at": [0, 0], "properties": {"shape": [{"form": "circle", "radius": 0.1}],
         "mass": 1000, "fixed": true}},
        {"name": "comet", "at": [0, 50], "properties": {"shape": [{"form": "circle", "radius": 0.1}],
         "mass": 2, "velocity": [30, 0]}}])"));
    session().setDetail("gravity", "real");
    runTo(1);
    auto const knob = gravityKnob(world());
    ASSERT_TRUE(knob);
    auto const acceleration = [](Vec2 place) { return -10 * 1000 / std::pow(length(place), 3) * place; };
    Vec2 const velocity = world().find<Velocity>(id("comet"))->value;
    for (int const period : {2, 4}) {
        Vec2 const later = at("comet") + (period - 1) / 2.0 / 60 * velocity;
        double const off = length(acceleration(later) - acceleration(at("comet"))) / 2;
        EXPECT_NEAR(named(*knob, "real, every " + std::to_string(period) + " frames").error.metres, off,
                    1e-6 * off + 1e-12);
    }
}

TEST_F(GravityKnob, WorkGrowsWithAccuracyAndIsDividedByThePeriod) {
    open(starDisc(gameData(), 1500)); // enough for the tree to be cheaper
    runTo(1);
    auto const knob = gravityKnob(world());
    ASSERT_TRUE(knob);
    auto const work = [&](std::string const& name) { return named(*knob, name).work; };
    EXPECT_GT(work("real"), work("tree, opening angle 0.15"));
    EXPECT_GT(work("tree, opening angle 0.15"), work("tree, opening angle 0.7"));
    EXPECT_NEAR(work("real, every 4 frames"), work("real") / 4, 1e-12 * work("real"));
}

TEST_F(GravityKnob, WithoutALawThereIsNothingToChoose) {
    open(levelOf(R"("world": {"gravity": [0, -9.81]}, "objects": [
        {"name": "ball", "at": [0, 0], "properties": {"shape": [{"form": "circle", "radius": 0.1}]}}])"));
    runTo(1);
    auto const knob = gravityKnob(world());
    ASSERT_TRUE(knob);
    ASSERT_EQ(knob->options.size(), 1U);
    EXPECT_EQ(knob->options[0].name, "linear");
    EXPECT_EQ(knob->options[0].error.metres, 0);
    open(levelOf(R"("world": {}, "objects": [])"));
    runTo(1);
    EXPECT_FALSE(gravityKnob(world()));
}

} // namespace
} // namespace gravity_knob_test
} // namespace trembler::budget
