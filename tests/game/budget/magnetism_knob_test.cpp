// Estimated errors of magnetism's options, compared with the world's own forces pair by pair.
#include "physics/dynamics/properties/body.hpp"
#include "physics/magnetism/properties.hpp"
#include "tests/game/budget/knob_kit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace trembler::budget {
namespace magnetism_knob_test {
namespace {

class MagnetismKnob : public KnobTest {
protected:
    static LevelFile spiralOf(int magnets) {
        std::string objects;
        for (int i = 0; i < magnets; ++i) {
            double const radius = 0.5 * std::sqrt(static_cast<double>(i));
            double const angle = i * pi * (3 - std::sqrt(5.0));
            objects += fmt::format(
                R"({}{{"name": "magnet {:02}", "part": "bar magnet", "at": [{}, {}], "angle_deg": {}}})",
                i == 0 ? "" : ", ", i, radius * std::cos(angle), radius * std::sin(angle), 97 * i);
        }
        return levelOf(R"("world": {}, "objects": [)" + objects + "]");
    }
};

TEST_F(MagnetismKnob, OffersItsLadderInAScene) {
    open(spiralOf(60));
    runTo(2);
    auto const knob = magnetismKnob(world());
    ASSERT_TRUE(knob);
    auto const error = [&](std::string const& name) { return named(*knob, name).error; };
    EXPECT_EQ(knob->options[knob->current].name, "pairwise");
    EXPECT_EQ(error("pairwise").share, 0);
    EXPECT_LT(error("tree, opening angle 0.15").share, 0.02);
    EXPECT_LT(error("tree, opening angle 0.15").share, error("tree, opening angle 0.7").share);
    EXPECT_LT(error("grid, cutoff 8 m").share, error("grid, cutoff 1 m").share);
    EXPECT_GT(error("grid, cutoff 1 m").share, 0.02);
    EXPECT_LT(named(*knob, "pairwise, every 4 frames").work, named(*knob, "pairwise").work);
    EXPECT_GT(error("pairwise, every 4 frames").metres, 0);
}

TEST_F(MagnetismKnob, EveryOptionCanBeMadeAndIsThenTheCurrentOne) {
    open(spiralOf(12));
    runTo(2);
    expectOptionsAreMade(magnetismKnob);
}

// Their nearest poles are 2.3 m apart: a cutoff below that removes all forces, and one of which four fifths
// exceed 3.7 m, the distance of the farthest poles, removes none.
TEST_F(MagnetismKnob, ACutoffKeepsAllForcesOfTwoMagnetsOrNone) {
    open(levelOf(R"("world": {"magnetism": {"look_ahead": false}, "detail": {"magnetism": "pairwise"}},
        "objects": [{"name": "one", "part": "bar magnet", "at": [0, 0]},
                    {"name": "two", "part": "bar magnet", "at": [3, 0]}])"));
    runTo(1);
    auto const knob = magnetismKnob(world());
    ASSERT_TRUE(knob);
    std::map<ObjectId, Vec2> forces; // of the frame that has just been computed
    for (MagneticForce::Entry const& entry : world().find<MagneticForce>()->forces) {
        forces[entry.object] += entry.force;
    }
    ASSERT_EQ(forces.size(), 2U);
    double squares = 0;
    for (auto const& [object, force] : forces) {
        squares += lengthSquared(force) / std::pow(2 * world().find<Mass>(object)->value, 2);
    }
    double const all = std::sqrt(squares / 2);
    EXPECT_GT(all, 0);
    for (char const* const near : {"grid, cutoff 1 m", "grid, cutoff 2 m"}) {
        EXPECT_NEAR(named(*knob, near).error.share, 1, 1e-9) << near;
        EXPECT_NEAR(named(*knob, near).error.metres, all, 1e-6 * all) << near;
    }
    EXPECT_NEAR(named(*knob, "grid, cutoff 8 m").error.share, 0, 1e-9);
    EXPECT_GT(named(*knob, "grid, cutoff 4 m").error.share, 0);
    EXPECT_LT(named(*knob, "grid, cutoff 4 m").error.share, 1);
}

TEST_F(MagnetismKnob, WithoutMagnetsThereIsNone) {
    open(levelOf(R"("world": {"gravity": [0, -9.81]}, "objects": [
        {"name": "ball", "at": [0, 0], "properties": {"shape": [{"form": "circle", "radius": 0.1}]}}])"));
    runTo(1);
    EXPECT_FALSE(magnetismKnob(world()));
}

} // namespace
} // namespace magnetism_knob_test
} // namespace trembler::budget
