// Circuits that are open for another reason than a missing contact: the answer names it, and no gap.
#include "insight/miss/current/switched_links.hpp"
#include "insight/why/words/words.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/explained_miss.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::insight {
namespace switched_links_test {
namespace {

/// The explanation for a recorded solution that does not solve its level.
Miss missIn(std::string const& file, std::string const& solution) {
    LevelFile const level = loadLevel(gameData().registry, testedFile(file));
    Solution const& asked = *level.findSolution(solution);
    return explainedMiss(level, LevelRuns::framesFor(asked), {asked});
}

std::string told(Miss const& miss, AnswerLanguage const& language = AnswerLanguage()) {
    std::string all;
    for (std::string const& sentence : sentencesOf(miss, language)) {
        all += sentence + " ";
    }
    return all;
}

// The generator's coil and its source are always 15 cm apart, also while they are connected.
TEST(SwitchedLinks, AGeneratorThatStandsIsNoGap) {
    Miss const miss = missIn("2-electricity/6-slowly-does-it.json", "no hand turns the crank");
    ASSERT_EQ(miss.lack, Lack::gap);
    ASSERT_EQ(miss.gaps.size(), 1U) << told(miss);
    CircuitGap const& gap = miss.gaps.front();
    EXPECT_EQ(gap.reason, GapReason::slow);
    EXPECT_EQ(gap.nameBy, "generator coil");
    EXPECT_NEAR(gap.needed, 90, 1e-9) << "as the part states";
    EXPECT_LT(gap.is, gap.needed);
    EXPECT_EQ(miss.by, 0) << "no touch is missing";
    EXPECT_NE(told(miss).find("the generator coil turned at "), std::string::npos) << told(miss);
    EXPECT_NE(told(miss).find(" degrees a second, and needs 90"), std::string::npos) << told(miss);
    EXPECT_EQ(told(miss).find("cm"), std::string::npos) << told(miss);
    Catalogue const german(gameData().home / "assets" / "text", "de");
    EXPECT_NE(told(miss, AnswerLanguage(german)).find(": Die Spule (Generator) drehte sich mit "),
              std::string::npos)
        << told(miss, AnswerLanguage(german));
}

// The fuse is in its holder, and no contact would help.
TEST(SwitchedLinks, ABlownFuseIsNoGap) {
    Miss const miss = missIn("2-electricity/4-one-load-too-many.json", "rubber carries no current");
    std::string const words = told(miss);
    EXPECT_NE(words.find("the fuse had blown"), std::string::npos) << words;
    EXPECT_EQ(words.find(" mm"), std::string::npos) << words;
    EXPECT_NE(words.find("There were 3 too few"), std::string::npos) << words;
}

/// A lamp, a source and a return, wired to each other except for a gap. A sound sensor on two conductors
/// would close it, but it falls onto them too quietly to switch.
LevelFile sensorLevel() {
    std::string const text = R"({"version": 2, "title": "Ear",
  "world": {"gravity": [0, -9.81], "bounds": [-10, -10, 20, 20]},
  "objects": [
    {"name": "source", "at": [-3, 0], "properties": {"conductor": true, "electrical_source": true}},
    {"name": "return", "at": [3, 0], "properties": {"conductor": true, "electrical_return": true}},
    {"name": "lamp", "at": [-2, 0], "properties": {"conductor": true}},
    {"name": "left", "at": [-0.5, 0], "properties": {"material": "copper", "fixed": true,
      "shape": [{"form": "box", "width": 0.2, "height": 0.2}]}},
    {"name": "right", "at": [0.5, 0], "properties": {"material": "copper", "fixed": true,
      "shape": [{"form": "box", "width": 0.2, "height": 0.2}]}},
    {"name": "ear", "part": "sound sensor", "at": [0, 0.22], "properties": {"sound_sensor": {"threshold_db": 140}}}],
  "connections": [["source", "lamp"], ["lamp", "left"], ["right", "return"]],
  "goals": {"on": "lamp"}})";
    return readLevel(gameData().registry, JsonDocument::parse(text, "ear.json"));
}

TEST(SwitchedLinks, ASensorThatHearsTooLittleIsNoGap) {
    Miss const miss = explainedMiss(sensorLevel(), 120);
    ASSERT_EQ(miss.gaps.size(), 1U) << told(miss);
    EXPECT_EQ(miss.gaps.front().reason, GapReason::quiet);
    EXPECT_EQ(miss.gaps.front().nameBy, "ear");
    EXPECT_EQ(miss.gaps.front().needed, 140);
    EXPECT_NE(told(miss).find("the ear heard less than the 140 dB that it needs"), std::string::npos)
        << told(miss);
}

/// A lamp in a circuit with a gap, in which a battery lies; with mains in the circuit, or without.
LevelFile batteryLevel(bool mains, bool battery) {
    std::string const ends = R"(
    {"name": "mains plus", "at": [-3, 1], "properties": {"conductor": {"network": "mains"}, "fixed": true,
      "electrical_source": {"network": "mains"}, "shape": [{"form": "box", "width": 0.1, "height": 0.1}]}},
    {"name": "mains minus", "at": [3.5, 1], "properties": {"conductor": {"network": "mains"}, "fixed": true,
      "electrical_return": {"network": "mains"}, "shape": [{"form": "box", "width": 0.1, "height": 0.1}]}},)";
    std::string const text = R"({"version": 2, "title": "A battery across a gap",
  "world": {"gravity": [0, -9.81], "bounds": [-5, -1, 10, 5]},
  "objects": [)" + (mains ? ends : "") +
                             (battery ? R"({"name": "battery", "part": "battery", "at": [0, 0.78]},)" : "") +
                             R"(
    {"name": "left contact", "at": [-0.4, 0.6], "properties": {"material": "copper", "fixed": true,
      "shape": [{"form": "box", "width": 0.3, "height": 0.1}]}},
    {"name": "right contact", "at": [0.4, 0.6], "properties": {"material": "copper", "fixed": true,
      "shape": [{"form": "box", "width": 0.3, "height": 0.1}]}},
    {"name": "lamp", "part": "lamp", "at": [2.5, 0.5]}],
  "connections": [["right contact", "lamp"], )" +
                             (mains ? R"(["mains plus", "left contact"], ["lamp", "mains minus"]])"
                                    : R"(["left contact", "lamp"]])") +
                             R"(, "goals": {"on": "lamp", "for": 1}})";
    return readLevel(gameData().registry, JsonDocument::parse(text, "battery.json"));
}

bool solvedIn(LevelFile const& level) {
    return LevelRuns(gameData(), level).run({}, {.frames = 240}).solved;
}

// Each source drives its current through its own network: alone, the battery lights the lamp; in the circuit
// of the mains, the answer must not suggest laying something across its ends as if it were a gap.
TEST(SwitchedLinks, ABatteryAcrossAGapOfTheMainsIsSaidToPassNoOtherCurrent) {
    EXPECT_TRUE(solvedIn(batteryLevel(false, true)));
    LevelFile const both = batteryLevel(true, true);
    EXPECT_FALSE(solvedIn(both));
    Miss const miss = explainedMiss(both, 240);
    ASSERT_EQ(miss.gaps.size(), 1U) << told(miss);
    EXPECT_EQ(miss.gaps.front().reason, GapReason::foreign);
    EXPECT_NE(
        told(miss).find("no current of another source passes from the battery minus to the battery plus"),
        std::string::npos)
        << told(miss);
}

TEST(SwitchedLinks, ACircuitWithoutASourceIsSaidToHaveNone) {
    Miss const miss = explainedMiss(batteryLevel(false, false), 60);
    EXPECT_EQ(miss.lack, Lack::source);
    EXPECT_EQ(told(miss),
              "No current flowed through the lamp: it has no source within reach, at the start. ");
}

// The faster the generator turns, the nearer the miss, so that a search can improve step by step.
TEST(SwitchedLinks, TheFasterAGeneratorTurnsTheNearerItIs) {
    Miss const standing = missIn("2-electricity/6-slowly-does-it.json", "no hand turns the crank");
    Miss const turning = missIn("2-electricity/6-slowly-does-it.json", "too light");
    EXPECT_GT(turning.gaps.front().is, standing.gaps.front().is);
    EXPECT_LT(turning.measure, standing.measure);
}

} // namespace
} // namespace switched_links_test
} // namespace trembler::insight
