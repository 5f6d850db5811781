// Texts name the keys that are bound now, and no text names one that the player may have changed.
#include "game/ui/app/command_lists.hpp"
#include "game/ui/shared/commands/named_keys.hpp"
#include "render/window/pad_keys.hpp"
#include "tests/game/ui/shared/source_texts.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

namespace trembler::ui {
namespace named_keys_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json read(fs::path const& file) {
    std::ifstream in(file);
    return Json::parse(in);
}

CommandInfo const& infoOf(KeyBindings const& bindings, std::string_view id) {
    for (CommandInfo const* command : bindings.commands()) {
        if (command->id == id) {
            return *command;
        }
    }
    throw std::invalid_argument(std::string(id));
}

/// The keys that a text names literally. The modifiers Shift, Ctrl and Alt of mouse actions and of finer
/// steps cannot be changed, so texts may name them.
std::vector<std::string> literalKeysIn(std::string const& text) {
    // Words that name a key, and those that only do so amid a sentence: "or Delete", "press U", "und B".
    static std::regex const words(
        R"(\b(?:Esc|Escape|Enter|Return|Tab|Backspace|Page ?Up|Page ?Down|F[1-9][0-9]?|[LR][12]|RS (?:Up|Down|Left|Right))"
        R"(|[Aa]rrow keys?|[Dd]irectional pad|(?:[Ll]eft|[Rr]ight) stick|Keypad [0-9A-Z+-]|Pad [A-Z])"
        R"(|Tabulator|Eingabetaste|Leertaste|R\xC3\xBC\x63ktaste|Entf|Einfg|Pos1|Num [0-9A-Z])"
        R"(|[Pp]feiltasten?|[Ss]teuerkreuz|(?:linke[rn]?|rechte[rn]?) Stick)\b|Bild(?:\xE2\x86\x91|\xE2\x86\x93))"
        R"(|(?:^|[^\w])(?:\xE2\x86\x90|\xE2\x86\x92|\xE2\x86\x91|\xE2\x86\x93)(?:[^\w]|$))"
        R"(|[a-z,;] (?:Delete|Home|End|Insert|Space)\b)"
        R"(|\b(?:or|press|presses|hold|holds|key|button|oder|dr\xC3\xBC\x63kt?|halten|Taste|Knopf) [A-Z]\b(?!['-]))");
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), words), end; at != end; ++at) {
        found.push_back(at->str());
    }
    return found;
}

void expectNoKeyIn(std::string const& text, std::string const& where) {
    for (std::string const& key : literalKeysIn(text)) {
        ADD_FAILURE() << where << " names the key \"" << key
                      << "\", which may be another one: fill a gap as named_keys.hpp does\n"
                      << text;
    }
}

/// Of the strings at certain keys of a level file.
void expectNoKeyInLevel(Json const& value, std::string const& where, bool shown) {
    static std::set<std::string> const shownMembers{"title", "text", "texts", "hints", "called"};
    if (value.is_string()) {
        if (shown) {
            expectNoKeyIn(value.get<std::string>(), where);
        }
    } else if (value.is_object()) {
        for (auto const& [key, member] : value.items()) {
            expectNoKeyInLevel(member, where, shown || shownMembers.contains(key));
        }
    } else if (value.is_array()) {
        for (Json const& member : value) {
            expectNoKeyInLevel(member, where, shown);
        }
    }
}

TEST(NamedKeys, TheTestFindsLiteralOnes) {
    for (char const* const text :
         {"Play the level; Esc leads back", "Let the arrow keys move it", "L2 and R2 zoom",
          "Esc or B ends it", "The cross, or Delete, takes it", "press U to go on", "then Enter",
          "Das Kreuz oder Entf nimmt sie", "Die Pfeiltasten bewegen es", "mit der Rücktaste", "Bild↑",
          "mit F4", "hold Tab"}) {
        EXPECT_FALSE(literalKeysIn(text).empty()) << text;
    }
    for (char const* const text :
         {"Delete what is selected", "Turn it, with Shift by 1°", "Ctrl, Alt", "A goal or a hint", "Delete?",
          "End the recording", "Show everything", "Run plays it", "Press {}", "two of A and B"}) {
        EXPECT_TRUE(literalKeysIn(text).empty()) << text;
    }
}

TEST(NamedKeys, NoTextOfTheWindowNamesAKeyThatMayBeAnotherOne) {
    // These two are shown only if those are the keys, see namedDirections().
    std::set<std::string> const ofThoseKeys{"lesson.arrows", "lesson.pad_arrows"};
    fs::path const folder = fs::path(TREMBLER_SOURCE_DIR) / "assets/text";
    std::size_t texts = 0;
    for (auto const& entry : fs::recursive_directory_iterator(folder)) {
        // That file is the names of keys themselves.
        if (entry.path().extension() != ".json" || entry.path().filename() == "keys.json") {
            continue;
        }
        Json const all = read(entry.path());
        for (auto const& [id, text] : all.items()) {
            ++texts;
            if (!ofThoseKeys.contains(id) && text.is_string()) {
                std::string const where = entry.path().filename().string();
                expectNoKeyIn(text.get<std::string>(), where);
                expectNoKeyIn(id, where); // the English text, or a name of one
            }
        }
    }
    EXPECT_GT(texts, 1000U);
}

TEST(NamedKeys, NoStringOfTheSourcesNamesAKeyThatMayBeAnotherOne) {
    fs::path const table = fs::path(TREMBLER_SOURCE_DIR) / "assets/text/de/keys.json";
    std::map<std::string, std::string> const names = read(table);
    std::set<std::string> const arrows{"←", "→", "↑", "↓"};
    std::size_t literals = 0;
    forEachSource({"game/ui"}, [&](std::string const& source) {
        std::regex const line(R"(//[^\n]*|#include[^\n]*)");
        std::string const code = std::regex_replace(source, line, "");
        for (std::size_t at = 0; (at = code.find('"', at)) != std::string::npos;) {
            if (at > 0 && code[at - 1] == '\'') { // a character
                ++at;
                continue;
            }
            std::string const text = literalAt(code, at);
            ++literals;
            // By themselves they are in the table of the names of keys, or a drawn arrow.
            if (!names.contains(text) && !arrows.contains(text)) {
                expectNoKeyIn(text, "a source of game/ui");
            }
        }
    });
    EXPECT_GT(literals, 2000U);
}

TEST(NamedKeys, NoTextOfALevelNamesAKey) {
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(TREMBLER_SOURCE_DIR) / "levels")) {
        if (entry.path().extension() == ".json" &&
            entry.path().string().find("schema") == std::string::npos) {
            expectNoKeyInLevel(read(entry.path()), entry.path().filename().string(), false);
        }
    }
}

TEST(NamedKeys, TipsNameTheKeysThatAreBound) {
    KeyBindings bindings(commandLists());
    CommandInfo const& test = infoOf(bindings, "edit-test");
    EXPECT_EQ(shownTip(test, false, bindings), "Play the level; Esc or Pad B leads back");
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "back"), {SDLK_BACKSLASH}));
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "back"), {render::padKey(SDL_CONTROLLER_BUTTON_GUIDE)}));
    EXPECT_EQ(shownTip(test, false, bindings), "Play the level; \\ or Pad Guide leads back");
    EXPECT_EQ(tipOf(test, false, bindings), "Play the level; \\ or Pad Guide leads back (Space)");
    useLanguage("de");
    EXPECT_EQ(shownTip(test, false, bindings), "Das Level spielen; \\ oder Pad Mitte führt zurück");
    useLanguage("en");
}

TEST(NamedKeys, EveryGapOfATipHasItsCommand) {
    KeyBindings const bindings(commandLists());
    for (CommandInfo const* command : bindings.commands()) {
        bool const gap = std::string_view(command->tip.english()).find("{}") != std::string_view::npos;
        EXPECT_EQ(gap, !command->tipKey.empty()) << command->id;
        EXPECT_TRUE(command->tipKey.empty() || !bindings.keysOf(command->tipKey).empty()) << command->id;
    }
}

TEST(NamedKeys, ArrowsAreNamedInWordsOnlyIfTheyAreTheKeys) {
    KeyBindings bindings(commandLists());
    EXPECT_EQ(namedDirections(KeyDevice::keyboard, bindings), "The arrow keys");
    EXPECT_EQ(namedDirections(KeyDevice::pad, bindings), "The pad or the left stick");
    EXPECT_FALSE(bindings.bind(infoOf(bindings, "move-up"), {SDLK_KP_8}));
    EXPECT_EQ(namedDirections(KeyDevice::keyboard, bindings), "←, →, Keypad 8, ↓");
    EXPECT_EQ(namedDirections(KeyDevice::pad, bindings), "The pad or the left stick");
    EXPECT_FALSE(bindings.unbind(infoOf(bindings, "zoom-in")));
    EXPECT_EQ(keyOrNone("zoom-in", KeyDevice::pad, bindings), "–");
    EXPECT_EQ(namedKeys({"zoom-in"}, bindings), "–");
    EXPECT_EQ(namedKeys({"menu-erase", "menu-type"}, bindings), "Delete or Pad X");
}

} // namespace
} // namespace named_keys_test
} // namespace trembler::ui
