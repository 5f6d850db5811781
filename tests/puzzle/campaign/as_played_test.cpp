// Texts in other languages, and the tasks of demonstrations.
#include "puzzle/campaign/as_played.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/write/write_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

LevelFile levelFrom(std::string const& members) {
    return readLevel(
        gameData().registry,
        JsonDocument::parse(R"({"version": 2, "title": "A ball", "text": "It falls.", )" + members + "}",
                            "level.json"));
}

TEST(AsPlayed, TextsAreThoseOfTheLanguage) {
    LevelFile const level = levelFrom(R"("hints": ["Wait."], "texts": {"de": {"title": "Ein Ball",
        "goals": {"down": "Unten"}}}, "objects": [{"name": "ball", "part": "rubber ball", "at": [0, 3]}],
        "goals": {"moved": {"object": "ball", "by": 1, "towards": "down"}, "id": "down", "text": "Down"})");
    LevelFile const german = asPlayed(level, "de");
    EXPECT_EQ(german.title, "Ein Ball");
    EXPECT_EQ(german.text, "It falls.") << "what is not translated stays";
    EXPECT_EQ(german.hints, level.hints);
    EXPECT_EQ(german.goals["text"], "Unten");
    EXPECT_EQ(asPlayed(level, "en").title, "A ball");
    EXPECT_EQ(asPlayed(level, "fr").goals, level.goals);
    LevelFile const again =
        readLevel(gameData().registry, JsonDocument::parse(levelText(level), "again.json"));
    EXPECT_EQ(again.texts, level.texts);
}

TEST(AsPlayed, WrongTextsAreRefused) {
    for (char const* wrong :
         {R"("texts": 7)", R"("texts": {"german": {}})", R"("texts": {"de": {"titel": "x"}})",
          R"("texts": {"de": {"goals": {"a": 1}}})", R"("task": {"on": "a"})"}) {
        EXPECT_THROW((void)levelFrom(wrong), InputError) << wrong;
    }
}

TEST(AsPlayed, ATaskTakesThePlaceOfWhatTheDemonstrationDoes) {
    LevelFile level = loadLevel(gameData().registry, std::filesystem::path(TREMBLER_SOURCE_DIR) /
                                                         "levels/experiments/1-switched-electromagnet.json");
    level.task = nlohmann::json::parse(R"({"sequence": [
        {"touching": ["metal object", "electromagnet"], "id": "lifted"},
        {"not": {"touching": ["metal object", "electromagnet"]}, "for": 1, "id": "dropped"}]})");
    LevelFile const played = asPlayed(level, "en");
    EXPECT_FALSE(played.demonstration);
    auto const solves = [&](char const* solution) {
        Session session(gameData().registry, gameData().parts, played);
        session.load(*played.findSolution(solution));
        for (int frame = 0; frame < 420; ++frame) {
            session.step();
        }
        return session.solved();
    };
    EXPECT_FALSE(solves("hands off"));
    EXPECT_TRUE(solves("lift the switch"));
    EXPECT_TRUE(solves("cut the wire"));
}

} // namespace
} // namespace trembler
