// Of several bodies that dip into water, the answer distinguishes necessary ones from coincidences.
#include "insight/why/answer.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace dips_tests {
namespace {

/// A heavy bar that falls into water, with two boxes of these widths welded below it: a goal requires that it
/// stays up for two seconds.
LevelFile raft(double left, double right, double density) {
    auto const box = [](std::string const& name, double at, double width) {
        return R"({"name": ")" + name + R"(", "at": [)" + std::to_string(at) +
               R"(, -0.05], "properties": {"shape": [{"form": "box", "width": )" + std::to_string(width) +
               R"(, "height": 0.4}], "density": 100}})";
    };
    std::string const text = R"({"version": 2, "title": "Raft",
  "world": {"gravity": [0, -9.81], "bounds": [-10, -10, 20, 20]},
  "objects": [
    {"name": "water", "at": [0, -3.5],
     "properties": {"shape": [{"form": "box", "width": 16, "height": 6.5}], "density": 1000, "liquid": {}}},
    {"name": "bar", "at": [0, 0.2],
     "properties": {"shape": [{"form": "box", "width": 0.4, "height": 0.1}], "density": )" +
                             std::to_string(density) + R"(}},
)" + box("left", -left / 2, left) +
                             ", " + box("right", right / 2, right) + R"(],
  "joints": [{"form": "weld", "a": "bar", "b": "left", "at": [0, 0.15]},
             {"form": "weld", "a": "bar", "b": "right", "at": [0, 0.15]}],
  "goals": {"inside": {"object": "bar", "area": [-5, -1.5, 10, 8]}, "for": 2, "id": "afloat"}})";
    return readLevel(gameData().registry, JsonDocument::parse(text, "raft.json"));
}

Answer whyAfloat(LevelFile const& level) {
    LevelRuns const runs(gameData(), level);
    AskOptions options;
    options.frames = 600;
    Question question;
    question.goal = "afloat";
    return why(runs, {}, question, options);
}

/// The proof that an object's dip is a cause; nothing if the answer lacks it.
std::optional<Proof> proofOfDip(Answer const& answer, std::string const& object) {
    for (ChainStep const& one : answer.chain) {
        if (one.step.kind == StepKind::liquid && one.step.objects.front() == object) {
            return one.proof;
        }
    }
    return std::nullopt;
}

TEST(Dips, TheOneThatCarriesIsConfirmedAndTheOtherIsACoincidence) {
    Answer const answer = whyAfloat(raft(1.2, 0.05, 2000));
    ASSERT_TRUE(answer.happened);
    EXPECT_EQ(proofOfDip(answer, "left"), Proof::confirmed);
    EXPECT_EQ(proofOfDip(answer, "right"), std::nullopt);
    EXPECT_GE(answer.dropped, 1U);
}

TEST(Dips, TwoOfWhichEachWouldDoAreCausesTogether) {
    Answer const answer = whyAfloat(raft(0.8, 0.8, 2000));
    ASSERT_TRUE(answer.happened);
    EXPECT_EQ(proofOfDip(answer, "left"), Proof::together);
    EXPECT_EQ(proofOfDip(answer, "right"), Proof::together);
}

TEST(Dips, TwoOfWhichNeitherSufficesAreBothConfirmed) {
    Answer const answer = whyAfloat(raft(0.25, 0.25, 4000));
    ASSERT_TRUE(answer.happened);
    EXPECT_EQ(proofOfDip(answer, "left"), Proof::confirmed);
    EXPECT_EQ(proofOfDip(answer, "right"), Proof::confirmed);
}

} // namespace
} // namespace dips_tests
} // namespace trembler::insight
