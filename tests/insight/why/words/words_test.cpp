// The words about a miss, which say nothing false about a condition that had held.
#include "insight/why/words/words.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/explained_miss.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace trembler::insight {
namespace words_tests {
namespace {

using Sentences = std::vector<std::string>;

Catalogue const& german() {
    static Catalogue const catalogue(std::filesystem::path(TREMBLER_SOURCE_DIR) / "assets/text", "de");
    return catalogue;
}

Miss lacking(Lack lack, double by, std::uint64_t frame, std::vector<std::string> names) {
    Miss miss;
    miss.lack = lack;
    miss.by = by;
    miss.frame = frame;
    miss.names = std::move(names);
    return miss;
}

/// A goal that held until frame 60, and the cause of its end.
Miss ended(Miss const& by) {
    Miss miss = lacking(Lack::time, 2, 60, {});
    miss.besides = {by};
    return miss;
}

/// The words about that cause, besides the missing time.
Sentences endOf(Miss const& by, AnswerLanguage const& language = AnswerLanguage()) {
    Sentences all = sentencesOf(ended(by), language);
    all.erase(all.begin());
    return all;
}

TEST(Words, TheNumberOfRunsIsToldInTheLanguageOfTheAnswer) {
    Answer answer;
    answer.runs = 1;
    EXPECT_EQ(sourceOf(answer, AnswerLanguage()), "measured in 1 run");
    EXPECT_EQ(sourceOf(answer, AnswerLanguage(german())), "gemessen in 1 Lauf");
    answer.happened = true;
    answer.runs = 7;
    EXPECT_EQ(sourceOf(answer, AnswerLanguage(german())),
              "verfolgt in 7 Läufen, nicht in allen Schritten bestätigt");
    answer.confirmed = true;
    EXPECT_EQ(sourceOf(answer, AnswerLanguage()), "confirmed in 7 runs");
    EXPECT_EQ(sourceOf(answer, AnswerLanguage(german())), "bestätigt in 7 Läufen");
}

// The ball of this level falls into an area that it should stay out of, after a third of a second.
TEST(Words, WhatHeldForAWhileNeverIsSaidNotToHave) {
    LevelFile const level = readLevel(gameData().registry, JsonDocument::parse(R"({
  "version": 2, "title": "Fall",
  "world": {"gravity": [0, -9.81], "bounds": [-10, -50, 20, 60]},
  "objects": [{"name": "ball", "at": [0, 1],
               "properties": {"shape": [{"form": "circle", "radius": 0.1}], "density": 1000}}],
  "goals": {"not": {"inside": {"object": "ball", "area": [-5, -40, 10, 40.5]}}, "for": 1}})",
                                                                               "fall.json"));
    Miss const miss = explainedMiss(level, 120);
    ASSERT_EQ(miss.lack, Lack::time);
    Sentences const english = sentencesOf(miss, AnswerLanguage());
    ASSERT_EQ(english.size(), 2U);
    EXPECT_EQ(english.back(), "The ball was 4.43 m away from where it should be, at 1.0 s.");
    EXPECT_EQ(sentencesOf(miss, AnswerLanguage(german())).back(),
              "Die Kugel war 4,43 m vom Ziel entfernt, nach 1,0 s.");
}

TEST(Words, WhatNeverHeldIsSaidNotToHave) {
    EXPECT_EQ(sentencesOf(lacking(Lack::change, 1, 60, {"ball"}), AnswerLanguage()),
              Sentences{"The ball never was as it should be."});
}

// One of several conditions that must hold at once may have held at another moment, and an obstacle may have
// been absent then.
TEST(Words, WhatDidNotHoldAtOneMomentIsNotSaidNeverToHave) {
    Miss part = lacking(Lack::change, 1, 60, {"ball"});
    part.child = 1;
    EXPECT_EQ(sentencesOf(part, AnswerLanguage()), Sentences{"The ball was not as it should be, at 1.0 s."});
    Miss near = lacking(Lack::distance, 0.5, 60, {"ball", "floor"});
    near.besides = {lacking(Lack::change, 1, 0, {"magnet"})};
    EXPECT_EQ(sentencesOf(near, AnswerLanguage()),
              (Sentences{"The ball came within 50 cm of the floor, at 1.0 s.",
                         "The magnet was not as it should be."}));
}

TEST(Words, OfWhatHeldTellHowFarItWentAndWhen) {
    EXPECT_EQ(endOf(lacking(Lack::change, 1, 90, {"ball"})),
              Sentences{"The ball ceased to be as it should be, at 1.5 s."});
    EXPECT_EQ(endOf(lacking(Lack::distance, 2, 90, {"ball"})),
              Sentences{"The ball was 2.00 m away from where it should be, at 1.5 s."});
    EXPECT_EQ(endOf(lacking(Lack::distance, 2, 90, {"ball", "floor"})),
              Sentences{"The ball was 2.00 m away from the floor, at 1.5 s."});
    Miss gap = lacking(Lack::gap, 0.04, 90, {"lamp"});
    gap.gaps.emplace_back();
    gap.gaps.back().width = 0.04;
    gap.gaps.back().nameA = "left contact";
    gap.gaps.back().nameB = "right contact";
    EXPECT_EQ(endOf(gap),
              Sentences{"No current flowed through the lamp: the circuit has a gap of 4 cm between "
                        "the left contact and the right contact, at 1.5 s."});
}

TEST(Words, RoundForcesAsPeopleWould) {
    for (auto const& [newtons, text] :
         {std::pair(2165.43, "2165 N"), {21.654, "21.7 N"}, {2.1654, "2.17 N"}}) {
        EXPECT_EQ(sentencesOf(lacking(Lack::force, newtons, 60, {"magnet", "ball"}), AnswerLanguage()),
                  Sentences{std::string("The magnet pulled the ball with ") + text +
                            " less than its weight, at 1.0 s."});
    }
}

// Whether a further obstacle was ever absent is not known.
TEST(Words, OfWhatStoodInTheWayBesidesSayOnlyHowItWas) {
    Miss away = lacking(Lack::distance, 2, 90, {"ball", "floor"});
    away.besides = {lacking(Lack::change, 1, 0, {"magnet"})};
    EXPECT_EQ(endOf(away).back(), "The magnet was not as it should be.");
}

TEST(Words, TheForcesAreThoseOfTheMomentAtWhichItCeasedToHold) {
    Miss sunk = lacking(Lack::distance, 2, 90, {"raft"});
    sunk.besides = {lacking(Lack::lift, 30, 72, {"water", "raft"}),
                    lacking(Lack::lift, 40, 72, {"water", "raft", "float"}),
                    lacking(Lack::torque, 7, 72, {"water", "raft", "box"})};
    EXPECT_EQ(
        endOf(sunk),
        (Sentences{"The raft was 2.00 m away from where it should be, at 1.5 s.",
                   "The water would have lifted the raft there with 30 N less than its weight, at 1.2 s.",
                   "The water would have lifted the raft there with 40 N less than the weight of it and "
                   "all that is tied to it or lies on it, at 1.2 s.",
                   "The load turned the raft with 7 N m more than the water righted it, at 1.2 s."}));
    Sentences const words = endOf(sunk, AnswerLanguage(german()));
    ASSERT_EQ(words.size(), 4U);
    EXPECT_NE(words[0].find(" war 2,00 m vom Ziel entfernt, nach 1,5 s."), std::string::npos) << words[0];
    EXPECT_NE(words[1].find(" dort mit 30 N zu wenig getragen, nach 1,2 s."), std::string::npos) << words[1];
    EXPECT_NE(words[2].find(" dort samt allem, was daran hängt und darauf liegt, mit 40 N zu wenig getragen"),
              std::string::npos)
        << words[2];
    auto const made = toJson(
        [&] {
            Answer answer;
            answer.nearest.emplace().nearest = ended(sunk);
            return answer;
        }(),
        "", "", AnswerLanguage());
    auto const& told = made.at("nearest_miss").at("besides").at(0);
    EXPECT_EQ(told.at("frame"), 90);
    EXPECT_EQ(told.at("besides").at(0).at("frame"), 72);
}

TEST(Words, EveryKindOfMissHasTheKeysOnWhichProgramsRely) {
    std::set<std::string> kinds;
    for (int i = 0; i <= static_cast<int>(Lack::change); ++i) {
        auto const lack = static_cast<Lack>(i);
        nlohmann::ordered_json const made = toJson(lacking(lack, 2, 60, {"ball", "bell"}));
        for (std::string const key : {"frame", "what", "by", "unit", "measure", "objects"}) {
            EXPECT_TRUE(made.contains(key)) << nameOf(lack) << ": " << key;
        }
        EXPECT_EQ(made["what"], nameOf(lack));
        EXPECT_EQ(made["unit"], unitOf(lack));
        EXPECT_EQ(made.contains("too_many"), lack == Lack::count);
        kinds.insert(made["what"].get<std::string>());
    }
    EXPECT_EQ(kinds.size(), static_cast<std::size_t>(Lack::change) + 1);
    Miss cut = lacking(Lack::gap, 0, 60, {"magnet"});
    cut.gaps.resize(1);
    cut.gaps.front().reason = GapReason::cut;
    cut.gaps.front().nameA = "battery";
    cut.gaps.front().nameB = "magnet";
    EXPECT_EQ(toJson(cut)["gaps"][0]["reason"], "cut");
    Miss blocked = lacking(Lack::blocked, 1, 60, {"wedge", "striker"});
    EXPECT_FALSE(toJson(blocked).contains("if_gone"));
    blocked.ifClosed = IfClosed::nearer;
    EXPECT_EQ(toJson(blocked)["if_gone"], "nearer");
    EXPECT_FALSE(toJson(blocked).contains("if_closed"));
}

} // namespace
} // namespace words_tests
} // namespace trembler::insight
