// Sentences about goals in German, with the program's own texts and names.
#include "puzzle/goals/words/goal_text.hpp"
#include "puzzle/language/catalogue.hpp"
#include "puzzle/language/speech.hpp"
#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace trembler {
namespace {

std::string german(std::string const& goals) {
    Catalogue const texts(std::filesystem::path(TREMBLER_SOURCE_DIR) / "assets/text", "de");
    GermanSpeech const speech(texts);
    GoalStage stage(goals);
    auto const sentences = goalSentences(stage.level(), stage.world(), speech);
    return sentences.size() == 1 ? sentences.front() : std::to_string(sentences.size()) + " sentences";
}

TEST(GermanSpeech, SaysWhatEachKindOfGoalAsksFor) {
    EXPECT_EQ(german(R"({"on": "lamp"})"), "Lass die Lampe leuchten");
    EXPECT_EQ(german(R"({"off": "electromagnet"})"), "Schalte den Elektromagneten aus");
    EXPECT_EQ(german(R"({"touching": ["metal object", "electromagnet"]})"),
              "Heb den Metallgegenstand bis zum Elektromagneten");
    EXPECT_EQ(german(R"({"inside": {"object": "crate", "area": [0, 0, 1, 1], "called": "the basket"}})"),
              "Bring die Kiste in den Korb");
    EXPECT_EQ(german(R"({"inside": {"object": "crate", "area": [0, 0, 1, 1]}})"),
              "Bring die Kiste in die markierte Fläche");
    EXPECT_EQ(german(R"({"moved": {"object": "crate", "by": 0.5, "towards": "up"}})"),
              "Heb die Kiste um mindestens 0,5 m");
}

TEST(GermanSpeech, SaysForHowLongAndWhatNot) {
    EXPECT_EQ(german(R"({"on": "lamp", "for": 1})"), "Lass die Lampe leuchten, 1 Sekunde lang");
    EXPECT_EQ(german(R"({"on": "lamp 2", "for": 0.25})"), "Halte Lampe 2 eingeschaltet, 0,25 Sekunden lang");
    EXPECT_EQ(
        german(R"({"inside": {"object": "crate", "area": [0, 0, 1, 1], "called": "the basket"}, "for": 2})"),
        "Halte die Kiste im Korb, 2 Sekunden lang");
    EXPECT_EQ(german(R"({"not": {"touching": ["crate", "floor"]}})"), "Halte die Kiste fern vom Boden");
}

TEST(GermanSpeech, CountsAndLists) {
    EXPECT_EQ(german(R"({"count": {"of": {"part": "iron ball"}, "at_least": 2,
                         "that": {"inside": {"object": "it", "area": [0, 0, 1, 1], "called": "the basket"}}}})"),
              "Bring mindestens zwei Eisenkugeln in den Korb");
    EXPECT_EQ(german(R"({"count": {"of": ["lamp", "electromagnet"], "exactly": 2, "that": {"on": "it"}}})"),
              "Schalte die Lampe und den Elektromagneten ein");
    EXPECT_EQ(german(R"({"any": [{"on": "lamp"}, {"touching": ["crate", {"part": "iron ball"}]}]})"),
              "Entweder lass die Lampe leuchten oder bring die Kiste zu einer Eisenkugel");
    EXPECT_EQ(german(R"({"sequence": [{"on": "lamp"}, {"off": "lamp"}], "for": 2})"),
              "Zuerst: lass die Lampe leuchten, dann: lösche die Lampe, dann warte, 2 Sekunden lang");
}

TEST(EnglishSpeech, IsThatOfTheProgram) {
    Speech const& english = englishSpeech();
    EXPECT_EQ(english.phrase("keep {} away from {}", {english.the("lamp"), english.a("iron ball")}),
              "keep the lamp away from an iron ball");
    EXPECT_EQ(english.everyOne({{"a"}, {"b"}}).words, "both a and b");
    EXPECT_EQ(english.someOf("at least ", 2, {{"a"}, {"b"}, {"c"}}).words, "at least two of a, b and c");
    EXPECT_EQ(english.number(0.5), "0.5");
}

} // namespace
} // namespace trembler
