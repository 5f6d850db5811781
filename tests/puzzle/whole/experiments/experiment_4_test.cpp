// Experiment IV, the raft: it carries cargo, heels, spills and settles (6.11, 6.12), for any gravity and any
// detail level of buoyancy.
#include "tests/support/experiment.hpp"

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
    // Values of the level and its parts.
    static constexpr double raft = 2.4 * 0.1 * 600;   // kg per m of depth
    static constexpr double floats = 2 * 0.24 * 100;  // the same
    static constexpr double box = 0.18 * 0.18 * 2000; // the same
    static constexpr double water = 1000;             // kg/m³
    static constexpr double beam = 2 * 0.6;           // m of waterline, while the floats are upright
    static constexpr double high = 0.4;               // m, a float

    /// The level with one change.
    static LevelFile variant(std::string const& said, std::string const& instead) {
        std::ifstream in(gameData().home / "levels/experiments" / file);
        std::stringstream all;
        all << in.rdbuf();
        std::string text = all.str();
        auto const at = text.find(said);
        EXPECT_NE(at, std::string::npos) << said;
        text.replace(at, said.size(), instead);
        return readLevel(gameData().registry, JsonDocument::parse(text, file));
    }
    /// The expected height of the middle of the floats with this load: a floating body displaces its own
    /// weight.
    static double expectedHeight(double cargo) { return high / 2 - (raft + floats + cargo) / (water * beam); }
    [[nodiscard]] double height() const {
        return (at("flotation device A").y + at("flotation device B").y) / 2;
    }
    /// The input of the hand in one frame.
    void hand(PlayerInput::Kind kind, Vec2 where, std::string const& object = "") {
        session().feed({kind, object.empty() ? ObjectId{} : id(object), {}, where});
        step();
    }
    /// Moves the hand evenly for this number of frames.
    void carry(Vec2 from, Vec2 to, int frames) {
        for (int i = 1; i <= frames; ++i) {
            hand(PlayerInput::Kind::move, from + static_cast<double>(i) / frames * (to - from));
        }
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

// For any load on the raft: it heels until the centre of mass is above the centre of the displaced water,
// which for upright walls is tan θ (GM + BM/2 tan²θ) = lever (the wall-sided formula of naval architecture),
// here for a waterline in two pieces.
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
    EXPECT_GT(tangent, 0.02) << "else this tests nothing";
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
    EXPECT_NEAR(height(), expectedHeight(0), 0.003) << "it floats as high as without cargo";
    EXPECT_NEAR(angle("raft body"), 0, 0.01);
    EXPECT_NEAR(spin("raft body"), 0, 0.001);
    EXPECT_FALSE(session().solved());
}

// 6.12.2: a box from the ground of the basin is picked up and put on the raft, which then floats deeper by
// the draught of the box.
TEST_F(ExperimentFour, CargoFromTheGroundGoesOnBoard) {
    open(file);
    runTo(900);
    double const before = height();
    ASSERT_EQ(aboard(), 3);
    Vec2 const found = at("cargo 8");
    Vec2 const clear{-2, 1};
    double const deck = at("raft body").y + 0.05;
    Vec2 const place{at("cargo 1").x / 2 + at("cargo 2").x / 2, deck + 0.3};
    ASSERT_GT(at("cargo 2").x - at("cargo 1").x, 0.4) << "there must be room between the two";
    hand(PlayerInput::Kind::grab, found, "cargo 8");
    carry(found, {clear.x, found.y + 0.2}, 60);
    carry({clear.x, found.y + 0.2}, clear, 180);
    EXPECT_GT(at("cargo 8").y, 0.5) << "the hand lifts it out of the water";
    carry(clear, place, 120);
    hand(PlayerInput::Kind::release, place);
    runTo(world().frame() + 1200);
    EXPECT_TRUE(touching("cargo 8", "raft body"));
    EXPECT_EQ(aboard(), 4);
    EXPECT_NEAR(before - height(), box / (water * beam), 0.003);
    EXPECT_NEAR(height(), expectedHeight(4 * box), 0.003);
}

// 6.12.3: the raft reacts to new forces from any source.
TEST_F(ExperimentFour, BobsUpAgainWhereAHandPushedItDown) {
    open(file);
    step();
    for (std::string const number : {"1", "2", "3"}) {
        hand(PlayerInput::Kind::remove, {}, "cargo " + number);
    }
    runTo(900);
    double const rest = height();
    EXPECT_NEAR(rest, expectedHeight(0), 0.003);
    Vec2 const deck = at("raft body");
    hand(PlayerInput::Kind::grab, deck, "raft body");
    carry(deck, deck - Vec2{0, 0.6}, 60);
    runTo(world().frame() + 60);
    EXPECT_LT(height(), rest - 0.1);
    hand(PlayerInput::Kind::release, {});
    double highest = -10;
    for (int i = 0; i < 240; ++i) {
        step();
        highest = std::max(highest, height());
    }
    EXPECT_GT(highest, rest + 0.02) << "it overshoots";
    runTo(world().frame() + 1200);
    EXPECT_NEAR(height(), rest, 0.002);
}

TEST_F(ExperimentFour, TipsItsCargoOffWithoutAFloat) {
    open(file);
    runTo(600);
    ASSERT_EQ(aboard(), 3);
    session().feed({PlayerInput::Kind::remove, id("flotation device A"), {}, {}});
    double most = 0;
    while (world().frame() < 1200) {
        step();
        most = std::max(most, angle("raft body"));
    }
    EXPECT_GT(most, 0.3) << "left end down";
    EXPECT_EQ(aboard(), 0);
    EXPECT_GT(at("flotation device B").y, -0.3) << "the other one still floats";
}

TEST_F(ExperimentFour, SinksIfItDisplacesTooLittle) {
    ASSERT_LT(200 * (2.4 * 0.1 + 2 * 0.24), raft + floats);
    open(variant(R"("density": 1000)", R"("density": 200)"));
    runTo(1800);
    EXPECT_NEAR(height(), -2 + high / 2, 0.02) << "it lies on the ground";
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
