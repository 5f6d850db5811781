// Experiment III, the electric motor: it starts by itself, runs steadily, and stops for the same reasons as a
// real motor (6.10).
#include "physics/magnetism/properties.hpp"
#include "physics/motor/properties.hpp"
#include "tests/support/experiment.hpp"
#include "tests/support/motor_kit.hpp"
#include "tests/support/sanitizer.hpp"

#include <algorithm>

namespace trembler {
namespace {

class ExperimentThree : public Experiment {
protected:
    static constexpr char const* eight = "3-electric-motor.json";
    static constexpr char const* four = "3b-four-spokes.json";
    static constexpr char const* bare = "3c-no-base-magnet.json";
    static constexpr char const* cheap = "3d-motor-and-generator.json";
    static constexpr int angles = test::underSanitizer ? 16 : 64;

    Tachometer follow(std::uint64_t frame) {
        Tachometer tachometer(world());
        while (world().frame() < frame) {
            step();
            tachometer.look(world());
        }
        return tachometer;
    }
    /// Whether the motor, rotated to this initial angle, makes three turns anticlockwise within half a
    /// minute.
    bool starts(LevelFile const& level, int index) {
        open(turnedMotor(level, 2 * pi * index / angles));
        return follow(1800).turns() > 3;
    }
};

TEST_F(ExperimentThree, TurnsAnticlockwiseByItself) {
    open(eight, "", true);
    Tachometer const tachometer = follow(600);
    EXPECT_GT(tachometer.turns(), 2);
    EXPECT_TRUE(session().solved());
    // The sliding contact falls onto the top spoke, a north one, and that switches upper electromagnet on.
    Event const& touched = first("contact begun", {"sliding contact", "spoke 1"});
    Event const& north = first("on", {"upper electromagnet"});
    EXPECT_EQ(north.frame, touched.frame + 1);
    EXPECT_TRUE(led(touched, north));
    EXPECT_LT(north.frame, first("on", {"lower electromagnet"}).frame);
    EXPECT_TRUE(led(north, first("magnet on", {"upper electromagnet"})));
    // The next spoke is a south one, which switches the other electromagnet on.
    EXPECT_TRUE(
        led(first("contact begun", {"sliding contact", "spoke 8"}), first("on", {"lower electromagnet"})));
}

TEST_F(ExperimentThree, StartsFromAnyAngle) {
    LevelFile const level = load(eight);
    for (int i = 0; i < angles; ++i) {
        EXPECT_TRUE(starts(level, i)) << i << " of " << angles;
    }
}

TEST_F(ExperimentThree, KeepsItsSpeedForTenMinutes) {
    open(eight);
    Tachometer const tachometer = follow(36000);
    std::vector<double> const durations = tachometer.durations(20);
    ASSERT_GT(durations.size(), 100U);
    auto const half = static_cast<std::ptrdiff_t>(durations.size() / 2);
    double const early = mean({durations.begin(), durations.begin() + half});
    double const late = mean({durations.begin() + half, durations.end()});
    RecordProperty("seconds_per_turn", std::to_string(mean(durations)));
    RecordProperty("relative_deviation", std::to_string(relativeDeviation(durations)));
    RecordProperty("drift", std::to_string(late / early - 1));
    EXPECT_LE(relativeDeviation(durations), 0.05);
    EXPECT_NEAR(late / early, 1, 0.01);
}

TEST_F(ExperimentThree, StopsWhenTheAxisIsJammed) {
    open(eight, "a block in its way");
    EXPECT_LT(std::abs(follow(600).turns()), 0.1);
    Tachometer const jammed = follow(1800); // the electromagnets go on pushing it against the block
    EXPECT_LT(std::abs(jammed.turns()), 0.01);
    for (double const speed : jammed.speeds(0)) {
        EXPECT_LT(std::abs(speed), 0.5);
    }
    EXPECT_FALSE(session().solved());
}

TEST_F(ExperimentThree, StopsWhileAHandHoldsItAndGoesOnAfterwards) {
    open(eight, "hold the axle");
    EXPECT_GT(follow(900).turns(), 4);
    EXPECT_LT(std::abs(follow(1200).turns()), 0.25) << "five seconds in the hand";
    EXPECT_GT(follow(1800).turns(), 2) << "let go, it should start again";
}

TEST_F(ExperimentThree, StopsWhenTheCircuitIsBroken) {
    open(eight, "cut the wire");
    EXPECT_GT(follow(900).turns(), 4);
    EXPECT_LT(follow(6000).turns(), 4) << "its damping brings it to a stop";
    EXPECT_FALSE(on("upper electromagnet"));
    EXPECT_FALSE(on("lower electromagnet"));
    EXPECT_EQ(spin("main axle"), 0);
}

TEST_F(ExperimentThree, StopsWhenTheSlidingContactIsLifted) {
    open(eight, "lift the sliding contact");
    EXPECT_GT(follow(900).turns(), 4);
    EXPECT_LT(follow(6000).turns(), 4);
    EXPECT_EQ(spin("main axle"), 0);
}

TEST_F(ExperimentThree, WithoutABaseMagnetSometimesDoesNotStart) {
    LevelFile level = load(eight);
    std::erase_if(level.objects, [](LevelObject const& object) { return object.name == "base magnet"; });
    int started = 0;
    int stuck = 0;
    for (int i = 0; i < angles; ++i) {
        if (starts(level, i)) {
            ++started;
        } else {
            ++stuck;
            EXPECT_LT(std::abs(spin("main axle")), 0.02) << "figure 6-13 shows a motor at rest";
        }
    }
    RecordProperty("started", started);
    EXPECT_GT(started, angles / 4);
    EXPECT_GT(stuck, angles / 8);
}

TEST_F(ExperimentThree, StandsStillWhereNoSpokeReachesTheContact) {
    open(bare);
    EXPECT_LT(std::abs(follow(1800).turns()), 0.01);
    EXPECT_FALSE(touching("sliding contact", "spoke 1"));
    EXPECT_FALSE(session().solved());
    open(bare, "put the base magnet back");
    EXPECT_GT(follow(1800).turns(), 3);
    open(bare, "give it a push");
    EXPECT_GT(follow(1800).turns(), 3);
}

// "The start up phase in such a configuration is a bit longer and the motion during the operation phase is
// far less smooth."
TEST_F(ExperimentThree, RunsRougherWithFourSpokes) {
    open(eight);
    Tachometer const smooth = follow(7200);
    open(four);
    Tachometer const rough = follow(7200);
    EXPECT_TRUE(session().solved());
    double const rippleOfEight = relativeDeviation(smooth.speeds(20));
    double const rippleOfFour = relativeDeviation(rough.speeds(20));
    RecordProperty("ripple_of_eight", std::to_string(rippleOfEight));
    RecordProperty("ripple_of_four", std::to_string(rippleOfFour));
    ASSERT_GE(rough.marks().size(), 20U);
    EXPECT_GT(rippleOfFour, 2 * rippleOfEight);
    EXPECT_GT(relativeDeviation(rough.durations(20)), 2 * relativeDeviation(smooth.durations(20)));
}

// The cheap version of 6.10.4: the motor turns the generator, and that lights the lamp.
TEST_F(ExperimentThree, HasAMotorThatDrivesAGenerator) {
    open(cheap, "cut the wire", true);
    runTo(900);
    EXPECT_TRUE(on("lamp"));
    EXPECT_TRUE(session().solved());
    EXPECT_NEAR(spin("motor"), -2 * spin("dynamo"), 0.01) << "the wheels are geared";
    EXPECT_LT(spin("motor"), world().find<ElectricMotor>(id("motor"))->idleSpeed);
    EXPECT_TRUE(led(first("contact begun", {"object 1", "switch"}), first("on", {"lamp"})))
        << "the switch should be among the reasons why the lamp shines";
    runTo(1500);
    EXPECT_FALSE(on("motor"));
    EXPECT_FALSE(on("lamp")) << "the generator has stopped";
    EXPECT_LT(std::abs(spin("dynamo")), world().find<Generator>(id("dynamo"))->speed);

    open(cheap, "hold the wheel");
    runTo(1200);
    EXPECT_TRUE(on("motor"));
    EXPECT_NEAR(spin("motor"), 0, 1e-3) << "jammed";
    EXPECT_FALSE(on("lamp"));
    runTo(1500);
    EXPECT_TRUE(on("lamp"));

    open(cheap, "cut the wire before the switch falls");
    runTo(600);
    EXPECT_FALSE(on("lamp"));
}

} // namespace
} // namespace trembler
