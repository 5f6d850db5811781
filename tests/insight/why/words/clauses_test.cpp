// The clauses of answers in German, with the names of all parts: article, gender and case.
#include "insight/why/words/clauses.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/insight/support/tested_level.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <string_view>

namespace trembler::insight {
namespace clauses_test {
namespace {

namespace fs = std::filesystem;

fs::path textFolder() {
    return fs::path(TREMBLER_SOURCE_DIR) / "assets/text";
}

Catalogue const& german() {
    static Catalogue const catalogue(textFolder(), "de");
    return catalogue;
}

Step step(StepKind kind, std::vector<std::string> objects, std::string const& what = "") {
    Step made;
    made.kind = kind;
    made.objects = std::move(objects);
    made.what = what;
    return made;
}

std::string said(Step const& step) {
    return clausesOf(step, {}, "", AnswerLanguage(german())).main;
}
std::string because(Step const& step) {
    return clausesOf(step, {}, "", AnswerLanguage(german())).because;
}

TEST(Clauses, InflectWhatTheyName) {
    EXPECT_EQ(said(step(StepKind::on, {"electromagnet"})), "durch den Elektromagneten fließt Strom");
    EXPECT_EQ(said(step(StepKind::off, {"upper electromagnet"})),
              "durch den oberen Elektromagneten fließt kein Strom mehr");
    EXPECT_EQ(said(step(StepKind::magnetOn, {"electromagnet"})), "der Elektromagnet wird magnetisch");
    EXPECT_EQ(said(step(StepKind::pull, {"iron ball", "electromagnet"})),
              "der Elektromagnet zieht die Eisenkugel an");
    EXPECT_EQ(because(step(StepKind::push, {"spoke 4", "base magnet"})),
              "weil der Grundmagnet Speiche 4 abstößt");
    EXPECT_EQ(because(step(StepKind::contact, {"iron ball", "electromagnet"})),
              "weil die Eisenkugel den Elektromagneten berührt");
    EXPECT_EQ(because(step(StepKind::liquid, {"float", "water body"})),
              "weil der Schwimmer in das Wasser eintaucht");
    EXPECT_EQ(said(step(StepKind::cut, {"battery plus", "left contact"})),
              "du hast die Leitung zwischen dem Pluspol und dem linken Kontakt durchgeschnitten");
    EXPECT_EQ(said(step(StepKind::placed, {"bar magnet 1"})),
              "du hast Stabmagnet 1 vor dem Start dorthin gelegt");
    EXPECT_EQ(said(step(StepKind::other, {"fuse"}, "blown")), "die Sicherung brennt durch");
    EXPECT_EQ(because(step(StepKind::other, {"cork", "water"}, "leaves the liquid")),
              "weil der Korken aus dem Wasser herauskommt");
}

// The player has placed the part, not the piece of it that touches something.
TEST(Clauses, NameThePartThatWasPlaced) {
    SceneFacts facts;
    facts.placementOf = {{"wire 1 left end", 0}, {"wire 1 link 1", 0},    {"wire 1 right end", 0},
                         {"wire 2 left end", 1}, {"wire 2 right end", 1}, {"spanner 1", 2}};
    auto const placed = [&](std::string const& object) {
        return clausesOf(step(StepKind::placed, {object}), facts, "", AnswerLanguage()).main;
    };
    EXPECT_EQ(placed("wire 1 right end"), "you laid wire 1 there before the start");
    EXPECT_EQ(placed("wire 2 left end"), "you laid wire 2 there before the start");
    EXPECT_EQ(placed("spanner 1"), "you laid spanner 1 there before the start");
}

/// Every part is named with an article that fits its gender and the case; the cases of a masculine noun
/// differ.
TEST(Clauses, KnowTheNamesOfAllParts) {
    for (std::string const& part : gameData().parts.names()) {
        ASSERT_TRUE(german().names().understands(part)) << part;
        std::string const nominative = german().names().definite(part, GermanCase::nominative);
        std::string const accusative = german().names().definite(part, GermanCase::accusative);
        std::string const dative = german().names().definite(part, GermanCase::dative);
        std::string const article = nominative.substr(0, 4);
        if (article == "der ") {
            EXPECT_TRUE(accusative.starts_with("den ")) << accusative;
            EXPECT_TRUE(dative.starts_with("dem ")) << dative;
            EXPECT_EQ(accusative.substr(4), dative.substr(4)) << "they have one form";
        } else {
            EXPECT_TRUE(article == "die " || article == "das ") << nominative;
            EXPECT_EQ(accusative, nominative);
            EXPECT_TRUE(dative.starts_with(article == "die " ? "der " : "dem ")) << dative;
        }
        std::string const sentence = said(step(StepKind::on, {part}));
        EXPECT_EQ(sentence, "durch " + accusative + " fließt Strom");
        EXPECT_EQ(said(step(StepKind::contact, {part, part})), nominative + " berührt " + accusative);
    }
}

// Any object of a level that touches something may occur in an answer, also as a piece.
TEST(Clauses, KnowTheNamesOfAllObjectsOfAllLevels) {
    std::set<std::string> names;
    for (std::filesystem::path const& file : gameData().levels()) {
        LevelFile const level = loadLevel(gameData().registry, file);
        for (auto const& [name, at] :
             factsOf(LevelRun(gameData().registry, gameData().parts, level, {}, {})).places) {
            names.insert(name);
        }
    }
    EXPECT_GT(names.size(), 500U);
    for (std::string const& name : names) {
        EXPECT_TRUE(german().names().understands(name)) << name;
    }
}

// Masculine nouns with these endings are weak ("der Magnet, den Magneten"): they need the other form.
TEST(Clauses, AllWeakNounsHaveTheirOtherForm) {
    std::ifstream in(textFolder() / "de/names.json");
    nlohmann::json const names = nlohmann::json::parse(in);
    std::size_t weak = 0;
    for (auto const& [english, value] : names.at("nouns").items()) {
        std::string const entry = value.get<std::string>();
        std::string const word = entry.substr(0, entry.find('|'));
        std::string const first = word.substr(0, word.find(' ', 4)); // "der Elektromagnet" of "... Nord"
        constexpr std::array<std::string_view, 7> endings{"agnet", "ent", "ist", "ant", "oge", "nom", "e"};
        bool const isWeak = word.starts_with("der ") &&
                            std::any_of(endings.begin(), endings.end(),
                                        [&](std::string_view ending) { return first.ends_with(ending); });
        if (!isWeak) {
            continue;
        }
        ++weak;
        EXPECT_NE(german().names().definite(english, GermanCase::accusative).substr(4), word.substr(4))
            << english;
    }
    EXPECT_GT(weak, 5U);
}

} // namespace
} // namespace clauses_test
} // namespace trembler::insight
