// Each text of the editor has a translation in every language of the program.
#include "game/ui/edit/commands/edit_commands.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <nlohmann/json.hpp>

namespace trembler::ui::test {
namespace edit_words_test {
namespace {

/// All texts of a language that are looked up by their English text.
std::map<std::string, std::string> translations(std::string_view language) {
    std::map<std::string, std::string> all;
    auto const folder = homeFolder() / "assets" / "text" / std::string(language);
    for (auto const& file : std::filesystem::directory_iterator(folder)) {
        auto const texts = nlohmann::json::parse(textOfFile(file.path()), nullptr, false);
        EXPECT_TRUE(texts.is_object()) << file.path();
        for (auto const& [english, text] : texts.items()) {
            if (text.is_string()) {
                all[english] = text.get<std::string>();
            }
        }
    }
    return all;
}

std::vector<std::string> allTexts() {
    std::vector<std::string> all;
    for (char const* const word : words::allEditWords()) {
        all.emplace_back(word);
    }
    for (auto const& table : {editCommands(), testCommands()}) {
        for (Command<EditParts> const& command : table) {
            if (command.info.id.starts_with("edit-") || command.info.leads) {
                for (char const* const text : {command.info.name, command.info.tip, command.info.help}) {
                    all.emplace_back(text);
                }
            }
        }
    }
    for (Gesture const& gesture : editGestures()) {
        all.emplace_back(gesture.with);
        all.emplace_back(gesture.does);
    }
    return all;
}

std::size_t gapsIn(std::string const& text) {
    std::size_t gaps = 0;
    for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}", at + 2)) {
        ++gaps;
    }
    return gaps;
}

TEST(EditWords, HaveATranslationIntoEveryLanguage) {
    std::vector<std::string> const all = allTexts();
    EXPECT_GT(all.size(), 300U);
    for (Language const& language : languages()) {
        if (language.id == "en") {
            continue; // the texts are written in this language
        }
        auto const known = translations(language.id);
        for (std::string const& english : all) {
            auto const found = known.find(english);
            ASSERT_NE(found, known.end()) << language.id << ": " << english;
            EXPECT_FALSE(found->second.empty()) << english;
            EXPECT_EQ(gapsIn(found->second), gapsIn(english)) << english;
        }
    }
}

TEST(EditWords, FollowTheLanguage) {
    Designer designer({800, 600}); // where long words have the least room
    designer.editCopyOf(levelsFolder() / "first/1-first-contact.json");
    EXPECT_STREQ(words::tabProblems, "Problems");
    useLanguage("de");
    designer.frames(2);
    EXPECT_STREQ(words::tabProblems, "Probleme");
    EXPECT_EQ(words::severalObjects(3), "3 Gegenstände");
    for (SDL_Keycode const page : {SDLK_F2, SDLK_F3, SDLK_F4, SDLK_F5, SDLK_F6, SDLK_F7, SDLK_F8}) {
        designer.key(page);
        designer.frames(2);
        designer.look("edit-german-" + std::to_string(page - SDLK_F2 + 2));
    }
    useLanguage("en");
    designer.frames(2);
    EXPECT_STREQ(words::tabProblems, "Problems");
}

} // namespace
} // namespace edit_words_test
} // namespace trembler::ui::test
