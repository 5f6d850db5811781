// Substeps: the estimated error compared with a falling body, and the least number that is allowed.
#include "physics/dynamics/properties/settings.hpp"
#include "tests/game/budget/knob_kit.hpp"

#include <fmt/format.h>

namespace trembler::budget {
namespace dynamics_knob_test {
namespace {

class DynamicsKnob : public KnobTest {
protected:
    static RecordedChange toSubsteps(int substeps) {
        RecordedChange change;
        change.kind = RecordedChange::Kind::setting;
        change.subject = "solver";
        change.field = "substeps";
        change.value = substeps;
        return change;
    }
    static LevelFile withSubsteps(LevelFile level, int substeps) {
        DynamicsSettings settings;
        settings.substeps = substeps;
        level.world.set(settings);
        return level;
    }
};

TEST_F(DynamicsKnob, ErrorIsThatOfAFallingBody) {
    open(levelOf(R"("world": {"gravity": [0, -9.81], "solver": {"substeps": 4}}, "objects": [
        {"name": "ball", "at": [0, 0], "properties": {"shape": [{"form": "circle", "radius": 0.1}]}}])"));
    MotionLog log;
    for (int i = 0; i <= 60; ++i) {
        log.look(world());
        step();
    }
    auto const knob = dynamicsKnob(world(), log);
    ASSERT_TRUE(knob);
    ASSERT_EQ(knob->options.size(), 5U);
    int steps = 1;
    for (Option const& option : knob->options) {
        // Semi-implicit Euler with the step h is g t h / 2 ahead of g t² / 2 after the time t.
        double const h = 1.0 / 60 / steps;
        EXPECT_NEAR(option.error.metres, 9.81 * h / 2, 0.02 * 9.81 * h / 2) << option.name;
        EXPECT_NEAR(option.error.share, h, 1e-12) << option.name;
        steps *= 2;
    }
    EXPECT_FALSE(knob->options[0].cannot.empty()) << "one step topples stacks";
    EXPECT_TRUE(knob->options[1].cannot.empty());
}

// The budget can reduce a number of steps that it has increased, but not below the level's number while there
// are joints.
TEST_F(DynamicsKnob, StepsAreNeverFewerThanStatedWhereThereAreJoints) {
    open(withSubsteps(load("4-raft.json"), 4));
    MotionLog log;
    log.look(world());
    runTo(5);
    session().change(toSubsteps(16));
    log.look(world());
    auto const knob = dynamicsKnob(world(), log);
    ASSERT_TRUE(knob);
    EXPECT_EQ(knob->options[knob->current].name, "16 steps");
    for (Option const& option : knob->options) {
        bool const fewer = option.name == "1 step" || option.name == "2 steps";
        EXPECT_EQ(option.cannot.empty(), !fewer) << option.name;
    }
}

// A taut chain needs many steps: no option with fewer is offered.
TEST_F(DynamicsKnob, StepsAreNeverFewerThanTheSceneNeeds) {
    std::string objects;
    std::string joints;
    for (int i = 0; i < 8; ++i) {
        objects += fmt::format(
            R"({{"name": "link {}", "at": [0, {}], "properties": {{"shape": [{{"form": "box", "width": 0.05,)"
            R"( "height": 0.2}}], "mass": 1, "collision": {{"group": -1}}}}}}, )",
            i, -0.1 - 0.2 * i);
        joints += fmt::format(R"({{"form": "hinge", "a": "link {}", {}"at": [0, {}]}}, )", i,
                              i == 0 ? "" : fmt::format(R"("b": "link {}", )", i - 1), -0.2 * i);
    }
    open(levelOf(
        R"("world": {"gravity": [0, -9.81]}, "objects": [)" + objects +
        R"({"name": "weight", "at": [0, -1.6], "properties": {"shape": [{"form": "circle", "radius": 0.1}],
            "mass": 2000, "collision": {"group": -1}}}], "joints": [)" +
        joints + R"({"form": "hinge", "a": "weight", "b": "link 7", "at": [0, -1.6]}])"));
    MotionLog log;
    for (int i = 0; i < 12; ++i) {
        log.look(world());
        step();
    }
    auto const knob = dynamicsKnob(world(), log);
    ASSERT_TRUE(knob);
    EXPECT_EQ(knob->current, 0U);
    EXPECT_EQ(knob->options[0].name, fmt::format("automatic: {} steps", log.automaticSteps()));
    EXPECT_GT(log.automaticSteps(), 8);
    EXPECT_FALSE(named(*knob, "8 steps").cannot.empty());
    EXPECT_TRUE(named(*knob, fmt::format("automatic: {} steps", log.automaticSteps())).cannot.empty());
}

TEST_F(DynamicsKnob, EveryOptionCanBeMadeAndIsThenTheCurrentOne) {
    for (int const stated : {2, 4, 5}) {
        open(withSubsteps(starDisc(gameData(), 10), stated));
        MotionLog log;
        runTo(2);
        log.look(world());
        expectOptionsAreMade([&](World const& of) { return dynamicsKnob(of, log); });
    }
}

TEST_F(DynamicsKnob, MoreStepsCostMoreAndHaveASmallerError) {
    open(withSubsteps(starDisc(gameData(), 20), 4));
    MotionLog log;
    for (int i = 0; i < 30; ++i) {
        log.look(world());
        step();
    }
    auto const knob = dynamicsKnob(world(), log);
    ASSERT_TRUE(knob);
    for (std::size_t i = 1; i < knob->options.size(); ++i) {
        EXPECT_GT(knob->options[i].work, knob->options[i - 1].work);
        EXPECT_LT(knob->options[i].error.metres, knob->options[i - 1].error.metres);
    }
}

TEST_F(DynamicsKnob, OfAWorldWithoutBodiesThereIsNone) {
    open(levelOf(R"("world": {"gravity": [0, -9.81]}, "objects": [])"));
    runTo(1);
    EXPECT_FALSE(dynamicsKnob(world(), MotionLog()));
}

} // namespace
} // namespace dynamics_knob_test
} // namespace trembler::budget
