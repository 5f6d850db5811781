// The texts of the screens: complete in every language, none unused.
#include "game/ui/app/title/title_screen.hpp"
#include "game/ui/play/commands/play_commands.hpp"
#include "game/ui/play/play_parts.hpp"
#include "game/ui/shared/commands/chord.hpp"
#include "game/ui/shared/commands/menu_keys.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/goals/reading/condition_outline.hpp"
#include "tests/game/ui/shared/source_texts.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;
using TextMap = std::map<std::string, std::string>;

fs::path textFolder() {
    return fs::path(TREMBLER_SOURCE_DIR) / "assets/text";
}

TextMap textsIn(fs::path const& file) {
    std::ifstream in(textFolder() / file);
    return nlohmann::json::parse(in).get<TextMap>();
}

/// The texts of a language that are looked up by their English text, without names of objects.
TextMap byEnglish(std::string_view language) {
    TextMap all;
    for (auto const& entry : fs::directory_iterator(textFolder() / language)) {
        if (entry.path().filename() != "names.json") {
            for (auto const& [english, value] : textsIn(entry.path())) {
                auto const [known, isNew] = all.emplace(english, value);
                EXPECT_TRUE(isNew || known->second == value)
                    << entry.path() << " states \"" << english << "\" again";
            }
        }
    }
    return all;
}

/// The gaps of a text, in order; a number may be written with the language's decimal point ("L").
std::vector<std::string> gapsOf(std::string const& text) {
    std::vector<std::string> gaps = Catalogue::piecesOf(text).gaps;
    for (std::string& gap : gaps) {
        gap = gap == "akk" || gap == "dat" || gap == "name" || gap == "own" ? std::string() : gap;
        gap.erase(std::remove(gap.begin(), gap.end(), 'L'), gap.end());
    }
    return gaps;
}

/// Everything that a player may read in English: texts of commands, of the window, of properties and
/// components. The editor has its own.
std::set<std::string> spokenToPlayers() {
    std::set<std::string> all;
    auto const addPhrase = [&](Phrase const& phrase) {
        if (phrase.english() != nullptr && *phrase.english() != '\0') {
            all.insert(phrase.english());
        }
    };
    auto const addCommand = [&](CommandInfo const& info) {
        for (Phrase const& phrase : {info.name, info.tip, info.help, info.whenOn.name, info.whenOn.tip}) {
            addPhrase(phrase);
        }
    };
    for (auto const& command : playCommands()) {
        addCommand(command.info);
    }
    for (auto const& command : titleCommands()) {
        addCommand(command.info);
    }
    for (CommandList const& list : {menuCommands(), letterCommands()}) {
        for (CommandInfo const* const command : list.commands) {
            addCommand(*command);
        }
    }
    for (Gesture const& gesture : playGestures()) {
        addPhrase(gesture.with);
        addPhrase(gesture.does);
    }
    for (char const* const said : allSaid()) {
        all.insert(said);
    }
    GameData const data;
    for (PropertyInfo const* const info : data.registry.objectProperties()) {
        all.insert(std::string(info->text.name));
        all.insert(std::string(info->text.meaning));
        if (info->fields == nullptr) {
            continue;
        }
        for (FieldPlace const& field : info->fields()) {
            all.insert(spokenKey(std::string(field.info.key)));
            all.insert(std::string(field.info.meaning));
            all.insert(field.choices.begin(), field.choices.end());
        }
    }
    for (Registration const& one : data.registry.components()) {
        all.insert(std::string(one.info->text.effect));
        all.insert(std::string(one.info->text.level));
        all.insert(std::string(one.info->text.work));
        if (one.info->kind != ComponentKind::interaction) {
            all.insert(std::string(one.info->text.name));
        }
    }
    for (char const* const none : {"", "value"}) {
        all.erase(none);
    }
    return all;
}

/// The ids of the words of goals: of the kinds of conditions, and of their members by their schemas.
std::set<std::string> idsOfGoalWords() {
    std::set<std::string> words{"part"}; // of a selector
    for (ConditionOutline const& outline : conditionOutlines()) {
        words.insert(outline.key);
        if (!outline.schema.contains("properties")) {
            continue;
        }
        for (auto const& member : outline.schema["properties"].items()) {
            if (!isCondition(member.value())) {
                words.insert(member.key());
            }
            for (auto const& choice : member.value().value("enum", nlohmann::ordered_json::array())) {
                words.insert(choice.get<std::string>());
            }
        }
    }
    std::set<std::string> ids;
    for (std::string const& word : words) {
        ids.insert("condition." + word);
    }
    return ids;
}

TEST(Texts, EveryTextIsThereAndUsed) {
    auto const english = textsIn("en.json");
    std::set<std::string> known;
    for (auto const& [id, value] : english) {
        known.insert(id);
        EXPECT_FALSE(value.empty()) << id;
    }
    std::set<std::string> mentioned = idsMentioned(known);
    mentioned.merge(idsOfGoalWords());
    EXPECT_EQ(mentioned, known) << "a text is missing in assets/text/en.json, or not used any more";
}

TEST(Texts, EveryLanguageHasAllOfThem) {
    auto const english = textsIn("en.json");
    for (Language const& language : languages()) {
        auto const texts = textsIn(std::string(language.id) + ".json");
        for (auto const& [id, value] : english) {
            auto const found = texts.find(id);
            ASSERT_NE(found, texts.end()) << language.id << " lacks " << id;
            EXPECT_EQ(gapsOf(found->second), gapsOf(value)) << language.id << ": " << id;
        }
        EXPECT_EQ(texts.size(), english.size()) << language.id << " has texts that English lacks";
    }
}

TEST(Texts, WhatIsSaidInEnglishIsSaidInEveryLanguage) {
    auto said = spokenToPlayers();
    auto const ids = textsIn("en.json");
    for (std::string const& text : textsAskedFor()) {
        if (!ids.contains(text)) {
            said.insert(text);
        }
    }
    for (Language const& language : languages()) {
        if (language.id == "en") {
            continue;
        }
        auto const texts = byEnglish(language.id);
        for (std::string const& english : said) {
            EXPECT_TRUE(texts.contains(english))
                << "no file of assets/text/" << language.id << " has \"" << english << "\"";
        }
    }
}

// Refusals and faults of levels, parts and scripts reach the window as the English texts of classes without
// one.
TEST(Texts, WhateverIsRefusedIsSaidInEveryLanguage) {
    // Lines of Lua and of JSON, as they are to be written.
    std::set<std::string> const code{
        "{} = {{ \"Position\", \"Velocity\" }}",
        "return interaction { name = ..., apply = function ... }",
        "apply = function(object, params, out) ... end",
        "params = { speed = { default = 8, min = 0, max = 60, unit = \"m/s\", text = \"...\" } }",
        "store = { object = { count = 0 }, script = { total = 0 } }",
        "store = { script = ... }",
        "limits = { instructions = 60000 }",
        "\"version\": {}"};
    auto const messages = messagesOfTheProgram();
    EXPECT_GT(messages.size(), 500U);
    for (Language const& language : languages()) {
        if (language.id == "en") {
            continue;
        }
        std::set<std::string> known;
        for (auto const& [english, value] : byEnglish(language.id)) {
            known.insert(withBareGaps(english));
        }
        for (std::string const& message : messages) {
            EXPECT_TRUE(known.contains(withBareGaps(message)) || code.contains(message))
                << "no file of assets/text/" << language.id << " has \"" << message << "\"";
        }
    }
}

/// The sources of what scripts are given, whose errors are put together in Lua: with neighbouring literals
/// joined.
std::string textOfTheLuaSources() {
    std::string all;
    for (auto const& entry :
         fs::recursive_directory_iterator(fs::path(TREMBLER_SOURCE_DIR) / "lua/sandbox")) {
        if (entry.path().extension() == ".cpp") {
            std::ifstream in(entry.path());
            all.append(std::istreambuf_iterator<char>(in), {});
        }
    }
    static std::regex const between(R"X(["']\s*\.\.\s*["']|"\s*\n\s*")X");
    return std::regex_replace(all, between, "");
}

/// Whether every part of a text between its gaps is in the sources. What the name of a library follows is put
/// together of more parts there.
bool isSaidInLua(std::string const& sources, std::string const& english) {
    static std::regex const gap(R"(\{[^}]*\})");
    static std::regex const ofLibrary(
        "^(there is no )(coroutine|math|string|table)\\.|^(cannot )(add|subtract) ");
    std::string const plain = std::regex_replace(english, ofLibrary, "$1$3{}");
    std::sregex_token_iterator part(plain.begin(), plain.end(), gap, -1);
    return std::all_of(part, {},
                       [&](auto const& piece) { return sources.find(piece.str()) != std::string::npos; });
}

TEST(Texts, NoTranslationIsStale) {
    auto const literals = literalsOfTheProgram();
    std::string const lua = textOfTheLuaSources();
    auto const ofScripts = textsIn(fs::path("de") / "scripts.json");
    // These are put together of a name and a word; and keys have the names of SDL.
    std::set<std::string> const composed{"{} <- {}",
                                         "{} Resolver",
                                         "{} DPS",
                                         "({}) Interaction",
                                         "is {} (did you mean '{}'?)",
                                         "a number ({})",
                                         "a number above {}",
                                         "a number above {} and at most {}"};
    for (Language const& language : languages()) {
        if (language.id == "en") {
            continue;
        }
        for (auto const& [english, value] : byEnglish(language.id)) {
            bool const isKey = chordFrom(english).has_value() || english.ends_with('+');
            std::size_t const several = english.find("they were"); // "it was", of one
            std::string const ofOne = several == std::string::npos ? english
                                                                   : english.substr(0, several) + "it was" +
                                                                         english.substr(several + 9);
            EXPECT_TRUE(literals.contains(withBareGaps(ofOne)) || composed.contains(english) || isKey ||
                        (ofScripts.contains(english) && isSaidInLua(lua, english)))
                << "nothing says \"" << english << "\"";
            EXPECT_FALSE(value.empty()) << english;
            EXPECT_EQ(gapsOf(value), gapsOf(english)) << language.id << ": " << english;
        }
    }
}

TEST(Texts, FollowTheLanguage) {
    useLanguage("de");
    EXPECT_EQ(languageInUse(), "de");
    EXPECT_STREQ(text("menu.back"), "Zurück");
    EXPECT_EQ(textWith("kept.gone", "x"), "x fehlte, also wird die letzte gute Fassung benutzt.");
    EXPECT_STREQ(words::toolbox, "Kasten");
    EXPECT_STREQ(words::nextLevel, "Nächstes Level");
    EXPECT_EQ(words::solvedWith(3.25, 2), "Gelöst nach 3,2 s mit 2 Teilen");
    EXPECT_EQ(translated("it would overlap the left lamp"),
              "es würde sich mit der linken Lampe überschneiden");
    EXPECT_EQ(shownArea("the basket"), "Korb");
    EXPECT_EQ(labelOf({.key = SDLK_SPACE, .shift = true}), "Umschalt+Leertaste");
    useLanguage("en");
    EXPECT_STREQ(text("menu.back"), "Back");
    EXPECT_STREQ(words::toolbox, "Toolbox");
    EXPECT_STREQ(words::nextLevel, "Next level");
    EXPECT_EQ(words::solvedWith(3.25, 1), "Solved after 3.2 s with 1 part");
    EXPECT_EQ(translated("it would overlap the left lamp"), "it would overlap the left lamp");
    EXPECT_EQ(shownArea("the basket"), "the basket");
    EXPECT_STREQ(text("no.such.text"), "no.such.text");
}

} // namespace
} // namespace trembler::ui
