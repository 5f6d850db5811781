// Sound modes: estimated errors compared with the page of measurements and with rendered sound.
#include "audio/effect/properties/sounds.hpp"
#include "tests/game/budget/knob_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace trembler::budget {
namespace sound_knob_test {
namespace {

class SoundKnob : public KnobTest {
protected:
    static LevelFile bellOver(double height) {
        return levelOf(R"("world": {"gravity": [0, -9.81]}, "objects": [
            {"name": "floor", "at": [0, -0.5], "properties": {"material": "stone", "fixed": true,
             "shape": [{"form": "box", "width": 10, "height": 1}]}},
            {"name": "bar", "at": [0, )" +
                       std::to_string(height) + R"(], "angle_deg": 20, "properties": {"material": "steel",
             "shape": [{"form": "box", "width": 0.4, "height": 0.06}]}}])");
    }
    /// Error (Hz) by level, of the sound ladder in docs/measurements/accuracy.md.
    static std::map<std::string, double> measured() {
        std::ifstream page(std::string(TREMBLER_SOURCE_DIR) + "/docs/measurements/accuracy.md");
        std::map<std::string, double> found;
        std::string line;
        while (std::getline(page, line)) {
            std::istringstream row(line);
            std::string level;
            std::string bar;
            double microseconds = 0;
            double hertz = 0;
            if (line.find("-mode") != std::string::npos &&
                (row >> bar >> level >> bar >> microseconds >> bar >> hertz)) {
                found[level] = hertz;
            }
        }
        return found;
    }
};

TEST_F(SoundKnob, ErrorIsThatOfThePageOfMeasurements) {
    std::map<std::string, double> const page = measured();
    ASSERT_EQ(page.size(), 5U);
    open(bellOver(1)); // nothing has fallen yet, so the pitch is taken to be 1000 Hz
    Subscription const wanted = world().want<Sounds>();
    runTo(1);
    auto const knob = soundKnob(world());
    ASSERT_TRUE(knob);
    ASSERT_EQ(knob->options.size(), page.size());
    for (auto const& [level, hertz] : page) {
        EXPECT_NEAR(named(*knob, level).error.share * 1000, hertz, 1e-9) << level;
    }
}

TEST_F(SoundKnob, ErrorIsAShareOfTheAudiblePitch) {
    open(bellOver(0.2));
    Subscription const wanted = world().want<Sounds>();
    runTo(1);
    auto const silent = soundKnob(world());
    ASSERT_TRUE(silent);
    // Until the bar has fallen and rings.
    do {
        step();
        ASSERT_LT(world().frame(), 120U);
    } while (world().find<Sounds>()->silent());
    runTo(world().frame() + 3);
    double loudness = 0;
    double pitch = 0;
    for (Sounds::Body const& body : world().find<Sounds>()->bodies) {
        loudness += body.loudness;
        pitch += body.loudness * body.brightness;
    }
    ASSERT_GT(loudness, 0);
    pitch /= loudness;
    auto const ringing = soundKnob(world());
    ASSERT_TRUE(ringing);
    for (std::size_t i = 0; i < ringing->options.size(); ++i) {
        Error const now = ringing->options[i].error;
        EXPECT_NEAR(now.share * pitch, silent->options[i].error.share * 1000, 1e-6);
        EXPECT_LE(now.metres, 0.01 * now.share + 1e-15) << "sound moves no body";
    }
}

TEST_F(SoundKnob, MoreModesCostMoreAndHaveASmallerError) {
    open(bellOver(1));
    Subscription const wanted = world().want<Sounds>();
    runTo(1);
    auto const knob = soundKnob(world());
    ASSERT_TRUE(knob);
    double const all = named(*knob, "32-modes").error.share;
    EXPECT_EQ(all, 0);
    std::map<int, Option const*> byModes;
    for (Option const& option : knob->options) {
        byModes[std::stoi(option.name)] = &option;
    }
    Option const* before = nullptr;
    for (auto const& [modes, option] : byModes) {
        if (before != nullptr) {
            EXPECT_GT(option->work, before->work) << modes;
            EXPECT_LT(option->error.share, before->error.share) << modes;
        }
        before = option;
    }
}

TEST_F(SoundKnob, EveryOptionCanBeMadeAndIsThenTheCurrentOne) {
    open(bellOver(1));
    Subscription const wanted = world().want<Sounds>();
    runTo(1);
    expectOptionsAreMade(soundKnob);
}

TEST_F(SoundKnob, WithoutListenersThereIsNone) {
    open(bellOver(1));
    runTo(1);
    EXPECT_FALSE(soundKnob(world()));
}

} // namespace
} // namespace sound_knob_test
} // namespace trembler::budget
