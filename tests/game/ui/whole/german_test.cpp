// The game in German: no text that it draws on any of its screens, by any of its functions, is English. The
// words of levels, parts and mods are exempt where their files have no German.
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/app/title/title_screen.hpp"
#include "game/ui/shared/texts.hpp"
#include "tests/game/ui/drawn_words.hpp"
#include "tests/game/ui/readable.hpp"
#include "tests/game/ui/tidy.hpp"

#include <nlohmann/json.hpp>

#include <cctype>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <string>

namespace trembler::ui::test {
namespace {

namespace fs = std::filesystem;

/// Adds the words of at least three letters, without capitals.
void addWords(std::string const& text, std::set<std::string>& words) {
    std::string word;
    for (char const c : text + " ") {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80U) {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            continue;
        }
        if (word.size() > 2) {
            words.insert(word);
        }
        word.clear();
    }
}

std::string contentOf(fs::path const& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The words that are English and not German, by the files of texts.
std::set<std::string> englishWords() {
    fs::path const folder = fs::path(TREMBLER_SOURCE_DIR) / "assets/text";
    std::set<std::string> english;
    std::set<std::string> german;
    auto const addAll = [](nlohmann::json const& texts, std::set<std::string>* keys,
                           std::set<std::string>* values) {
        for (auto const& [key, value] : texts.items()) {
            if (keys != nullptr) {
                addWords(key, *keys);
            }
            if (values != nullptr && value.is_string()) {
                addWords(value.get<std::string>(), *values);
            }
        }
    };
    addAll(nlohmann::json::parse(contentOf(folder / "en.json")), nullptr, &english);
    addAll(nlohmann::json::parse(contentOf(folder / "de.json")), nullptr, &german);
    for (auto const& entry : fs::directory_iterator(folder / "de")) {
        auto const texts = nlohmann::json::parse(contentOf(entry.path()));
        if (entry.path().filename() == "names.json") {
            for (char const* const section : {"nouns", "adjectives", "behind"}) {
                addAll(texts.at(section), &english, &german);
            }
        } else {
            addAll(texts, &english, &german);
        }
    }
    for (char const* const common :
         {"the", "and", "with", "for", "not", "this", "that", "from", "into", "are", "you"}) {
        english.insert(common);
    }
    for (std::string const& word : german) {
        english.erase(word);
    }
    return english;
}

/// The English words of levels, chapters, parts and mods.
std::set<std::string> wordsOfData() {
    std::set<std::string> words;
    for (char const* const folder : {"levels", "assets/parts", "mods"}) {
        for (auto const& entry : fs::recursive_directory_iterator(fs::path(TREMBLER_SOURCE_DIR) / folder)) {
            bool const script = entry.path().extension() == ".lua";
            if (script || entry.path().filename() == "mod.json") {
                addWords(contentOf(entry.path()), words);
            } else if (entry.path().extension() == ".json") {
                auto const file = nlohmann::json::parse(contentOf(entry.path()), nullptr, false);
                if (file.is_object() && !file.contains("texts")) {
                    for (char const* const said : {"title", "text", "hints", "goals", "name"}) {
                        addWords(file.contains(said) ? file[said].dump() : "", words);
                    }
                }
            }
        }
    }
    return words;
}

class German : public testing::TestWithParam<render::Size> {
protected:
    German() : player(GetParam()) {
        changeSettings(player.app().context(), {.language = "de"});
        player.frames(12);
    }
    ~German() override { useLanguage("en"); }

    /// `data`: the screen shows words of levels, parts or mods, too.
    void look(std::string const& screen, bool data = true) {
        static std::set<std::string> const english = englishWords();
        static std::set<std::string> const allowed = wordsOfData();
        player.frames(12);
        std::string const size = std::to_string(GetParam().height);
        expectTidy(player, screen + " " + size);
        expectReadable(screen + " " + size);
        expectWordsFit(player, screen + " " + size);
        player.look("german-" + screen + "-" + size);
        std::vector<std::string> const lines = DrawnWords().lines();
        EXPECT_GT(lines.size(), 2U) << "nothing was read from " << screen;
        for (std::string const& line : lines) {
            std::set<std::string> words;
            addWords(line, words);
            for (std::string const& word : words) {
                EXPECT_FALSE(english.contains(word) && !(data && allowed.contains(word)) &&
                             !own.contains(word))
                    << screen << ": \"" << word << "\" in \"" << line << "\"";
            }
        }
    }
    void lookAtMenu(std::string const& page, MenuPage which) {
        player.app().show(std::make_unique<TitleScreen>(player.app().context()));
        player.frames(2);
        player.app().openMenu(which);
        look(page, which == MenuPage::levels || which == MenuPage::gallery);
        player.key(SDLK_ESCAPE);
        player.frames(2);
    }

    Player player;
    std::set<std::string> own; // the words of the edited file
};

TEST_P(German, TitleAndMenus) {
    look("title");
    lookAtMenu("levels", MenuPage::levels);
    lookAtMenu("gallery", MenuPage::gallery);
    lookAtMenu("settings", MenuPage::settings);
    lookAtMenu("bindings", MenuPage::keys);
    lookAtMenu("help", MenuPage::help);
    lookAtMenu("ending", MenuPage::ending);
    lookAtMenu("menu", MenuPage::main);
    lookAtMenu("commands", MenuPage::commands);
}

TEST_P(German, EditorPages) {
    auto const copy = testFolder() / "level.json";
    fs::copy_file(levelsFolder() / "first/1-first-contact.json", copy, fs::copy_options::overwrite_existing);
    addWords(contentOf(copy), own);
    player.app().edit(copy);
    player.frames(4);
    for (auto const& [key, page] :
         {std::pair{SDLK_F2, "parts"}, std::pair{SDLK_F3, "outline"}, std::pair{SDLK_F5, "goals"},
          std::pair{SDLK_F6, "level"}, std::pair{SDLK_F7, "solutions"}}) {
        player.key(key);
        look(std::string("editor-") + page);
    }
    player.key(SDLK_F5);
    player.frames(3);
    player.clickItem("goal /all/1");
    look("editor-goal");
    player.key(SDLK_F3);
    player.frames(3);
    player.clickItem("object electromagnet");
    player.key(SDLK_F4);
    look("editor-properties");
    player.key(SDLK_DELETE);
    player.key(SDLK_F8);
    player.frames(40);
    look("editor-problems");
    player.key(SDLK_z, KMOD_LCTRL);
    look("editor-undone");
    player.key(SDLK_p, KMOD_LCTRL);
    look("editor-commands");
}

TEST_P(German, BuildingAndInspecting) {
    player.open(levelsFolder() / "first/1-first-contact.json");
    look("building");
    player.app().openMenu(MenuPage::help);
    look("help-of-a-level", false);
    player.key(SDLK_ESCAPE);
    player.frames(12);
    player.moveTo(player.item("part steel bar"));
    player.press();
    player.moveTo(player.at({1.7, 1.8}));
    look("refused");
    player.moveTo(player.at({-1.8, 1.5}));
    player.release();
    player.key(SDLK_h);
    player.key(SDLK_n);
    player.click(player.at({1.7, 1.7}));
    player.frames(4);
    look("inspecting");
    player.key(SDLK_BACKSPACE);
    look("putting-back");
}

TEST_P(German, RunningAndSuccess) {
    player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
    player.key(SDLK_SPACE);
    player.simulate(64);
    look("running");
    player.key(SDLK_p);
    look("paused");
    player.key(SDLK_p);
    player.key(SDLK_ESCAPE);
    look("menu-of-a-level");
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.2}));
    player.key(SDLK_SPACE);
    player.simulate(600);
    ASSERT_TRUE(player.showsCard("success"));
    look("success");
}

TEST_P(German, Components) {
    player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
    player.key(SDLK_SPACE);
    player.simulate(64);
    player.key(SDLK_c);
    player.frames(4);
    look("components");
    player.clickItem("budget");
    player.scrollTo("components", "show absent components");
    player.clickItem("show absent components");
    player.frames(90);
    look("all-components");
}

TEST_P(German, Mods) {
    player.open(fs::path(TREMBLER_SOURCE_DIR) / "mods/wind/levels/1-a-fair-wind.json");
    player.key(SDLK_SPACE);
    player.simulate(64);
    player.key(SDLK_m);
    player.frames(4);
    look("mods");
}

TEST_P(German, FreePlay) {
    player.clickItem("free play");
    player.frames(6);
    ASSERT_NE(player.findPlay(), nullptr);
    look("free-play");
}

// The texts of a level and of its goals change at once, in the middle of a run, and back.
TEST_P(German, IsChosenWhileALevelRuns) {
    changeSettings(player.app().context(), {.language = "en"});
    player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
    player.key(SDLK_SPACE);
    player.simulate(32);
    auto const frame = player.session().world().frame();
    player.look("switched-english");
    auto const shows = [](std::string const& wanted) {
        std::string all;
        for (std::string const& line : DrawnWords().lines()) {
            all += line + " ";
        }
        return all.find(wanted) != std::string::npos;
    };
    EXPECT_TRUE(shows("Experiment I: a switched"));
    EXPECT_TRUE(shows("Let the electromagnet lift the ball"));
    changeSettings(player.app().context(), {.language = "de"});
    player.look("switched-german");
    EXPECT_TRUE(shows("Experiment I: ein"));
    EXPECT_TRUE(shows("Lass den Elektromagneten die Kugel"));
    EXPECT_FALSE(shows("Let the electromagnet lift the ball"));
    EXPECT_GE(player.session().world().frame(), frame) << "the run goes on";
    changeSettings(player.app().context(), {.language = "en"});
    player.look("switched-back");
    EXPECT_TRUE(shows("Let the electromagnet lift the ball"));
}

INSTANTIATE_TEST_SUITE_P(Sizes, German, testing::Values(render::Size{800, 600}, render::Size{1280, 720}),
                         [](auto const& info) { return std::to_string(info.param.height); });

} // namespace
} // namespace trembler::ui::test
