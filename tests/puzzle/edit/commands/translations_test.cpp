#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/translations.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::edit {
namespace translations_test {
namespace {

using Of = TranslatedText::Of;

Json after(Json tree, Command const& command) {
    command.change(tree);
    return tree;
}

/// A level with a title, a text, two hints, and goals of which one has an id and a text.
Json spoken() {
    Json level = Json::parse(smallLevel());
    level["title"] = "A table";
    level["text"] = "Look.";
    level["hints"] = {"One.", "Two."};
    level["goals"] = Json::parse(
        R"({"all": [{"touching": ["ball", "table"], "id": "rest", "text": "Let it rest"}, {"moved": {"object": "ball", "by": 1}, "id": "go"}]})");
    return after(level, addLanguage(level, "de"));
}

TranslatedText find(Json const& level, Of of, std::size_t index = 0, std::string const& id = {}) {
    for (TranslatedText const& text : translatedTexts(level, "de")) {
        if (text.of == of && text.index == index && text.id == id) {
            return text;
        }
    }
    ADD_FAILURE() << "no such text";
    return {};
}

std::size_t missing(Json const& level) {
    auto const texts = translatedTexts(level, "de");
    return static_cast<std::size_t>(
        std::count_if(texts.begin(), texts.end(), [](TranslatedText const& text) { return text.missing; }));
}

TEST(Translations, AreMissingUntilTheyAreMade) {
    Json level = spoken();
    EXPECT_EQ(missing(level), 5U) << "title, text, two hints, a goal; the game itself says the other goal";
    level = after(level, translateTitle(level, "de", "Ein Tisch"));
    level = after(level, translateText(level, "de", "Schau."));
    level = after(level, translateHint(level, "de", 1, "Zwei."));
    level = after(level, translateGoal(level, "de", "rest", "Lass sie ruhen"));
    EXPECT_EQ(missing(level), 1U);
    EXPECT_TRUE(find(level, Of::hint, 0).missing) << "it only keeps the place";
    EXPECT_EQ(find(level, Of::hint, 1).translation, "Zwei.");
    EXPECT_EQ(
        level["texts"]["de"].dump(),
        R"({"title":"Ein Tisch","text":"Schau.","hints":["One.","Zwei."],"goals":{"rest":"Lass sie ruhen"}})");
    LevelFile const read = LevelDocument::fromText(editData(), level.dump(), {}, {}).level();
    EXPECT_EQ(read.texts.at("de").hints.size(), 2U);
    level = after(level, translateHint(level, "de", 1, ""));
    level = after(level, translateGoal(level, "de", "rest", ""));
    level = after(level, translateText(level, "de", ""));
    EXPECT_EQ(level["texts"]["de"].dump(), R"({"title":"Ein Tisch"})") << "nothing empty is left";
    level = after(level, removeLanguage(level, "de"));
    EXPECT_FALSE(level.contains("texts"));
}

TEST(Translations, FollowTheHintsOfTheLevel) {
    Json level = spoken();
    level = after(level, translateHint(level, "de", 0, "Eins."));
    level = after(level, addHint(level, "Three."));
    level = after(level, moveHint(level, 0, 2));
    EXPECT_EQ(level["texts"]["de"]["hints"], Json::array({"Two.", "Three.", "Eins."}));
    level = after(level, setHint(level, 0, "Two!"));
    EXPECT_EQ(level["texts"]["de"]["hints"][0], "Two!") << "still not translated";
    EXPECT_TRUE(find(level, Of::hint, 0).missing);
    level = after(level, removeHint(level, 1));
    EXPECT_EQ(level["texts"]["de"]["hints"], Json::array({"Two!", "Eins."}));
}

TEST(Translations, FollowTheIdsOfGoals) {
    Json level = spoken();
    level = after(level, translateGoal(level, "de", "rest", "Lass sie ruhen"));
    level = after(level, setGoalOption(level, "/all/0", "id", "still"));
    EXPECT_EQ(level["texts"]["de"]["goals"]["still"], "Lass sie ruhen");
    level = after(level, removeGoal(level, "/all/0"));
    EXPECT_TRUE(find(level, Of::goal, 0, "still").lost);
    level = after(level, addGoal(level, "", Json{{"on", "lamp"}, {"text", "Light"}}));
    EXPECT_TRUE(find(level, Of::goal, 0, "").missing) << "without an id it cannot be translated";
}

TEST(Translations, StayWithOtherGoalsOfTheSameId) {
    Json level = spoken();
    level = after(level, setDemonstration(level, true));
    level = after(level, addGoal(level, "", newCondition("moved", {"ball"}), GoalTree::task));
    level = after(level, setGoalOption(level, "", "id", "rest", GoalTree::task));
    level = after(level, setGoalOption(level, "/all/0", "id", "rest"));
    level = after(level, translateGoal(level, "de", "rest", "Lass sie ruhen"));
    level = after(level, setGoalOption(level, "", "id", "throw", GoalTree::task));
    EXPECT_EQ(level["texts"]["de"]["goals"]["rest"], "Lass sie ruhen") << "the other goal still has that id";
    EXPECT_EQ(level["texts"]["de"]["goals"]["throw"], "Lass sie ruhen");
    level = after(level, setGoalOption(level, "/all/0", "id", "still"));
    EXPECT_FALSE(level["texts"]["de"]["goals"].contains("rest"));
}

TEST(Translations, StayWhenAGoalLosesItsId) {
    for (Json const& none : {Json(), Json("")}) {
        Json level = spoken();
        level = after(level, setGoalOption(level, "/all/0", "id", "rest"));
        level = after(level, translateGoal(level, "de", "rest", "Lass sie ruhen"));
        level = after(level, setGoalOption(level, "/all/0", "id", none));
        EXPECT_EQ(level["texts"]["de"]["goals"], (Json{{"rest", "Lass sie ruhen"}})) << none;
        EXPECT_TRUE(find(level, Of::goal, 0, "rest").lost);
    }
}

TEST(Translations, OfTheTaskBelongToIt) {
    Json level = spoken();
    EXPECT_NE(refusalOf([&] { return addGoal(level, "", newCondition("moved", {"ball"}), GoalTree::task); }),
              "")
        << "only a demonstration has a task";
    level = after(level, setDemonstration(level, true));
    level = after(level, addGoal(level, "", newCondition("moved", {"ball"}), GoalTree::task));
    level = after(level, setGoalOption(level, "", "id", "throw", GoalTree::task));
    level = after(level, setGoalOption(level, "", "text", "Throw it", GoalTree::task));
    EXPECT_EQ(goalLines(level, GoalTree::task).size(), 1U);
    EXPECT_EQ(goalLines(level).size(), 3U) << "the goals are as they were";
    EXPECT_TRUE(find(level, Of::goal, 0, "throw").missing);
    level = after(level, addGoal(level, "", newCondition("touching", {"ball", "table"}), GoalTree::task));
    level = after(level, wrapGoal(level, "/all/1", "not", GoalTree::task));
    EXPECT_EQ(level["task"]["all"][1].begin().key(), "not");
    level = after(level, removeGoal(level, "", GoalTree::task));
    EXPECT_FALSE(level.contains("task"));
}

TEST(Translations, RefuseWhatFilesDoNotAllow) {
    Json const level = spoken();
    EXPECT_NE(refusalOf([&] { return addLanguage(level, "de"); }), "");
    for (char const* const wrong : {"", "D", "DE", "deu", "d1"}) {
        EXPECT_NE(refusalOf([&] { return addLanguage(level, wrong); }), "") << wrong;
    }
    EXPECT_NE(refusalOf([&] { return translateTitle(level, "fr", "x"); }), "");
    EXPECT_NE(refusalOf([&] { return translateTitle(level, "de", " x"); }), "");
    EXPECT_NE(refusalOf([&] { return translateHint(level, "de", 7, "x"); }), "");
    EXPECT_NE(refusalOf([&] { return translateGoal(level, "de", "", "x"); }), "");
    EXPECT_NE(refusalOf([&] { return removeLanguage(level, "fr"); }), "");
}

} // namespace
} // namespace translations_test
} // namespace trembler::edit
