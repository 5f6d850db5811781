// A level in which noise closes a circuit.
#include "audio/effect/properties/loudness.hpp"
#include "tests/support/experiment.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace trembler {
namespace {

class LoudEnough : public Experiment {
protected:
    void openWith(std::string const& solution) {
        open(loadLevel(gameData().registry, gameData().home / "levels/sound/1-loud-enough.json"), solution,
             true);
    }

    /// The frame in which the bell was struck first: a ball that bounces within a frame touches it only
    /// briefly.
    std::uint64_t struckBy(std::string const& ball) const {
        std::uint64_t frame = 0;
        for (char const* const touch : {"contact begun", "contact brief"}) {
            for (Event const* const event : events(touch, {"bell", ball})) {
                frame = frame == 0 ? event->frame : std::min(frame, event->frame);
            }
        }
        return frame;
    }
};

TEST_F(LoudEnough, TheBellLightsTheLampForAsLongAsItIsLoud) {
    openWith("ring the bell");
    int lit = 0;
    std::vector<bool> loud; // by frame
    while (world().frame() < 300) {
        step();
        loud.push_back(world().find<Loudness>()->at(id("sound sensor 1")) >= 85);
        lit += on("lamp") ? 1 : 0;
        if (loud.size() > 2) {
            // A sound level that is exceeded in a frame closes the circuit in the next one.
            EXPECT_EQ(on("lamp"), bool{loud[loud.size() - 2]} && touching("sound sensor 1", "left contact"))
                << world().frame();
        }
    }
    EXPECT_GT(lit, 120);
    EXPECT_LT(lit, 240) << "it should die away";
    EXPECT_FALSE(session().solved()) << "one stroke is not enough";
    std::uint64_t const hit = struckBy("steel ball 1");
    EXPECT_GT(hit, 30U);
    // First the sensor hears its own landing.
    EXPECT_TRUE(led(first("contact begun", {"right contact", "sound sensor 1"}), first("on", {"lamp"})));
    // The noise of the bell lasts longer.
    EXPECT_GT(first("off", {"lamp"}, hit).frame, hit + 60);
}

TEST_F(LoudEnough, ASecondStrokeKeepsTheLampLit) {
    openWith("two strokes");
    runTo(480);
    EXPECT_TRUE(session().solved());
    std::uint64_t const steel = struckBy("steel ball 1");
    std::uint64_t const iron = struckBy("iron ball 1");
    EXPECT_GT(steel, 0U);
    EXPECT_GT(iron, steel + 120) << "the board gives it time";
    EXPECT_GT(first("off", {"lamp"}).frame, iron) << "before the first stroke has faded";
}

TEST_F(LoudEnough, BehindTheWallTheDoorbellIsTooQuiet) {
    openWith("the doorbell behind the wall");
    runTo(120);
    while (world().frame() < 300) {
        step();
        double const level = world().find<Loudness>()->at(id("sound sensor 1"));
        EXPECT_GT(level, 40) << "it rings";
        EXPECT_LT(level, 80);
    }
    EXPECT_FALSE(session().solved());
}

TEST_F(LoudEnough, ItsOwnThudIsHeardButNotForLong) {
    openWith("nobody rings");
    int lit = 0;
    while (world().frame() < 300) {
        step();
        lit += on("lamp") ? 1 : 0;
    }
    EXPECT_GT(lit, 5);
    EXPECT_LT(lit, 80);
    EXPECT_FALSE(session().solved());
}

TEST_F(LoudEnough, NoiseWithoutASensorHasNoEffect) {
    openWith("a noise, and nothing that hears it");
    runTo(300);
    EXPECT_FALSE(on("lamp"));
    EXPECT_EQ(world().find<Loudness>(), nullptr) << "without listeners no loudness is computed";
}

} // namespace
} // namespace trembler
