// Experiment IV, the raft: it carries cargo, heels, spills and settles (6.11, 6.12), whatever the gravity and
// however the water is reckoned.
#include "tests/game/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace trembler {
namespace {

class ExperimentFour : public Experiment {
protected:
    static constexpr char const* file = "4-raft.json";
    static constexpr char const* gravity = R"("gravity": [0, -9.81])";
    // Of the level and its parts.
    static constexpr double raft = 2.4 * 0.1 * 600;   // kg per m of depth
    static constexpr double floats = 2 * 0.24 * 100;  // the same
    static constexpr double box = 0.18 * 0.18 * 2000; // the same
    static constexpr double water = 1000;             // kg/m³
    static constexpr double beam = 2 * 0.6;           // m of waterline, while the floats are upright
    static constexpr double high = 0.4;               // m, a float

    /// The level with one thing said otherwise.
    static LevelFile variant(std::string const& said, std::string const& instead) {
        std::ifstream in(workshop().home / "levels/experiments" / file);
        std::stringstream all;
        all << in.rdbuf();
        std::string text = all.str();
        auto const at = text.find(said);
        EXPECT_NE(at, std::string::npos) << said;
        text.replace(at, said.size(), instead);
        return readLevel(workshop().registry, JsonDocument::parse(text, file));
    }
    /// Where the middle of the floats should be with so much on board: what floats displaces its own weight.
    static double expectedHeight(double cargo) { return high / 2 - (raft + floats + cargo) / (water * beam); }
    [[nodiscard]] double height() const {
        return (at("flotation device A").y + at("flotation device B").y) / 2;
    }
    [[nodiscard]] int aboard() const {
        int count = 0;
        for (int i = 1; i <= 13; ++i) {
            count += touching("cargo " + std::to_string(i), "raft body") ? 1 : 0;
        }
        return count;
    }
};

TEST_F(ExperimentFour, CarriesItsCargoAtTheDraughtOfArchimedes) {
    open(file);
    runTo(1200);
    EXPECT_TRUE(session().solved());
    EXPECT_EQ(aboard(), 3);
    EXPECT_NEAR(height(), expectedHeight(3 * box), 0.003);
    EXPECT_LT(std::abs(angle("raft body")), 0.1);
    for (int i = 4; i <= 13; ++i) {
        EXPECT_NEAR(at("cargo " + std::to_string(i)).y, -2 + 0.09, 0.01) << "a box sinks by itself";
    }
}

// Whatever lies where on the raft: it heels until the middle of all weight is above the middle of what is
// displaced, which for upright walls is tan θ (GM + BM/2 tan²θ) = lever (the wall-sided formula of naval
// architecture), here for a waterline in two pieces.
TEST_F(ExperimentFour, HeelsByTheWallSidedFormula) {
    open(variant(R"("part": "cargo box", "at": [0.6, 0.85])", R"("part": "cargo box", "at": [-0.2, 0.85])"));
    runTo(2400);
    ASSERT_EQ(aboard(), 3);
    double const heel = angle("raft body");
    double mass = raft + floats;
    Vec2 moment{0, floats * -0.25};
    for (int i = 1; i <= 3; ++i) {
        Vec2 const off = at("cargo " + std::to_string(i)) - at("raft body");
        Vec2 const deck{std::cos(heel) * off.x + std::sin(heel) * off.y,
                        std::cos(heel) * off.y - std::sin(heel) * off.x};
        moment += box * deck;
        mass += box;
    }
    double const displaced = mass / water; // m²
    double const draught = displaced / beam;
    double const second = 2 * (0.6 * 0.6 * 0.6 / 12 + 0.6 * 0.85 * 0.85); // m³, of the waterline
    double const bm = second / displaced;
    double const gm = -0.25 - high / 2 + draught / 2 + bm - moment.y / mass;
    double const lever = -moment.x / mass;
    double tangent = 0;
    for (int i = 0; i < 50; ++i) {
        tangent = lever / (gm + bm / 2 * tangent * tangent);
    }
    EXPECT_GT(tangent, 0.02) << "else there is nothing to see";
    EXPECT_NEAR(heel, std::atan(tangent), 0.02 * std::atan(tangent));
}

TEST_F(ExperimentFour, HeelsSpillsAndSettles) {
    open(file, "load the left end");
    double most = 0;
    while (world().frame() < 300) {
        step();
        most = std::max(most, angle("raft body"));
    }
    EXPECT_GT(most, 0.3) << "left end down";
    runTo(1800);
    EXPECT_EQ(aboard(), 0);
    EXPECT_NEAR(height(), expectedHeight(0), 0.003) << "it has come up";
    EXPECT_NEAR(angle("raft body"), 0, 0.01);
    EXPECT_NEAR(spin("raft body"), 0, 0.001);
    EXPECT_FALSE(session().solved());
}

TEST_F(ExperimentFour, LiesAsDeepOnTheMoon) {
    open(variant(gravity, R"("gravity": [0, -1.62])"));
    runTo(3600);
    EXPECT_EQ(aboard(), 3);
    EXPECT_NEAR(height(), expectedHeight(3 * box), 0.003);
    EXPECT_TRUE(session().solved());
}

TEST_F(ExperimentFour, LiesHigherInBrine) {
    open(variant(R"("density": 1000)", R"("density": 1200)"));
    runTo(1200);
    EXPECT_EQ(aboard(), 3);
    EXPECT_NEAR(height(), high / 2 - (raft + floats + 3 * box) / (1200 * beam), 0.003);
}

// The thesis's own way: particles that stand for a body (6.12).
TEST_F(ExperimentFour, CarriesItsCargoOnParticlesToo) {
    open(variant(gravity, fmt::format(R"({}, "detail": {{"buoyancy": "particles"}})", gravity)));
    runTo(1200);
    EXPECT_EQ(aboard(), 3);
    EXPECT_NEAR(height(), expectedHeight(3 * box), 0.05);
    EXPECT_TRUE(session().solved());
}

} // namespace
} // namespace trembler
