// Experiment IV, the raft: it carries cargo, heels, spills and settles (6.11, 6.12), whatever the gravity and
// however the water is reckoned.
#include "tests/game/experiment.hpp"

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
    open(variant(gravity, std::string(gravity) + R"(, "detail": {"buoyancy": "particles"})"));
    runTo(1200);
    EXPECT_EQ(aboard(), 3);
    EXPECT_NEAR(height(), expectedHeight(3 * box), 0.05);
    EXPECT_TRUE(session().solved());
}

} // namespace
} // namespace trembler
