// The window with random files of each kind of which it shows something: it opens, says what is wrong, and
// goes on. TREMBLER_FUZZ=170 makes a thousand of each kind.
#include "game/ui/edit/edit_screen.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/game/ui/random/any_text.hpp"
#include "tests/support/attempts.hpp"

#include <imgui.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace trembler::ui::test {
namespace any_file_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr unsigned usualFiles = 6; ///< of each kind

std::string inFile(Json const& content) {
    return content.dump(1, ' ', false, Json::error_handler_t::replace);
}

void write(fs::path const& file, std::string const& content) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
}

/// Some bytes are others, are missing or come twice.
std::string damaged(AnyText& any, std::string content) {
    for (std::size_t i = any.below(4); i > 0 && !content.empty(); --i) {
        std::size_t const at = any.below(content.size());
        switch (any.below(4)) {
        case 0:
            content.resize(at);
            break;
        case 1:
            content[at] = static_cast<char>(any.below(256));
            break;
        case 2:
            content.erase(at, any.below(20));
            break;
        default:
            content.insert(at, content.substr(at, any.below(40)));
        }
    }
    return content;
}

std::string maybeDamaged(AnyText& any, Json const& content) {
    return any.oneIn(6) ? damaged(any, inFile(content)) : inFile(content);
}

Json levelOf(AnyText& any) {
    std::string const ball = any.name();
    std::string const floor = any.name();
    std::string const lamp = any.name();
    std::string const area = any.name();
    Json texts;
    for (int i = static_cast<int>(any.below(6)); i >= 0; --i) {
        texts.push_back(any.text());
    }
    Json level{
        {"version", 2},
        {"title", any.name()},
        {"text", any.text()},
        {"hints", texts},
        {"world", {{"gravity", {0, -9.81}}, {"bounds", {-4, -0.5, 8, 4}}}},
        {"objects",
         {{{"name", floor},
           {"at", {0, -0.15}},
           {"properties",
            {{"material", "stone"},
             {"fixed", true},
             {"shape", {{{"form", "box"}, {"width", 7.6}, {"height", 0.3}}}}}}},
          {{"name", ball}, {"part", "rubber ball"}, {"at", {0, 0.4}}},
          {{"name", lamp}, {"part", "lamp"}, {"at", {2, 0.6}}}}},
        {"placing", {{-3, 0, 6, 3}}},
        {"toolbox", {{{"part", "steel bar"}, {"count", 2}}, {{"wire", 2}}}},
        {"goals",
         {{"all",
           {{{"inside", {{"object", ball}, {"area", {-1, 0, 2, 1}}, {"called", area}}}, {"text", any.text()}},
            {{"on", lamp}, {"for", 1}},
            {{"moved", {{"object", ball}, {"by", 0.5}}}}}}}},
        {"texts",
         {{"de", {{"title", any.name()}, {"text", any.text()}, {"hints", {any.text(), any.text()}}}}}}};
    return level;
}

class AnyFile : public testing::Test {
protected:
    void SetUp() override {
        folder = testFolder() / "files";
        fs::remove_all(folder);
        fs::create_directories(folder);
        for (auto const& [name, value] :
             {std::pair("XDG_DATA_HOME", "data"), std::pair("XDG_STATE_HOME", "state"),
              std::pair("XDG_CONFIG_HOME", "config")}) {
            before.emplace_back(name, std::getenv(name) == nullptr ? "" : std::getenv(name));
            ::setenv(name, (folder / value).c_str(), 1);
        }
    }
    void TearDown() override {
        for (auto const& [name, value] : before) {
            value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
        }
        fs::remove_all(folder);
        useLanguage("en");
        window().setUiScaleRequest(1.F);
    }
    /// Frames with everything that ImGui checks when a picture is complete.
    static void look(Player& player, int frames = 3) {
        player.frames(frames - 1);
        player.frame();
        ImGui::Render();
        ASSERT_TRUE(player.going());
    }
    static void press(Player& player, std::initializer_list<SDL_Keycode> keys) {
        for (SDL_Keycode const key : keys) {
            player.key(key);
            ImGui::Render();
        }
        look(player);
    }
    /// Opens a level as players do who drop a file on the window.
    static void drop(Player& player, fs::path const& file) {
        render::pushDrop(window(), file);
        look(player);
    }
    /// Everything that play shows of a level.
    static void lookAtLevel(Player& player) {
        if (player.findPlay() == nullptr) {
            return; // refused, with a message
        }
        press(player, {SDLK_h, SDLK_h, SDLK_h, SDLK_h, SDLK_n, SDLK_1, SDLK_2});
        player.click(player.at({0, 0.4}));
        look(player);
        press(player, {SDLK_SPACE, SDLK_m, SDLK_c, SDLK_p, SDLK_k, SDLK_ESCAPE, SDLK_ESCAPE});
    }
    /// Everything that the editor shows of it.
    static void lookAtEditor(Player& player) {
        press(player, {SDLK_F2, SDLK_F3, SDLK_F4, SDLK_F5, SDLK_F6, SDLK_F7, SDLK_F8});
    }
    template <class Try>
    void each(Try const& attempt, unsigned usual = usualFiles) {
        for (unsigned seed = 0; seed < trembler::test::attempts(usual); ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            AnyText any(seed);
            fs::path const own = folder / std::to_string(seed);
            attempt(any, own);
            fs::remove_all(own);
            if (HasFatalFailure()) {
                return;
            }
        }
    }

    fs::path folder;
    std::vector<std::pair<std::string, std::string>> before;
};

TEST_F(AnyFile, OfALevelIsPlayed) {
    Player player;
    int opened = 0;
    each([&](AnyText& any, fs::path const& own) {
        fs::path const file = own / (any.fileName() + ".json");
        write(file, maybeDamaged(any, levelOf(any)));
        player.app().showTitle();
        useLanguage(any.oneIn(2) ? "de" : "en");
        drop(player, file);
        opened += player.findPlay() == nullptr ? 0 : 1;
        lookAtLevel(player);
    });
    EXPECT_GT(opened, 0);
}

TEST_F(AnyFile, OfALevelIsEdited) {
    Player player;
    each([&](AnyText& any, fs::path const& own) {
        fs::path const file = own / (any.fileName() + ".json");
        write(file, maybeDamaged(any, levelOf(any)));
        player.app().edit(file);
        look(player);
        lookAtEditor(player);
    });
    player.app().showTitle();
}

TEST_F(AnyFile, OfAModIsShown) {
    Player player;
    each([&](AnyText& any, fs::path const& own) {
        Json mod{{"name", "odd"},
                 {"version", any.text(500)},
                 {"author", any.text()},
                 {"licence", any.text(2000)},
                 {"text", any.text()}};
        if (!any.oneIn(6)) { // else it is missing
            write(own / "mods/odd/mod.json", maybeDamaged(any, mod));
        }
        std::string const quoted = inFile(any.text(900)); // JSON's strings are nearly those of Lua
        std::string script = "return interaction {\n  name = \"Dynamics <- Odd\",\n  text = " + quoted +
                             ",\n  calls = \"Dynamics\",\n  reads = { \"Velocity\" },\n  attached = true,\n"
                             "  each = { \"Velocity\" },\n  params = { speed = { default = 8, min = 0, max = "
                             "60, unit = \"m/s\", text = " +
                             inFile(any.text(300)) +
                             " } },\n  apply = function(object, params, out)\n    log(" +
                             inFile(any.text(300)) + ")\n    " + (any.oneIn(2) ? "error(" : "log(") +
                             inFile(any.text(900)) + ")\n  end,\n}\n";
        write(own / "mods/odd/interactions/odd.lua", any.oneIn(6) ? damaged(any, script) : script);
        Json level = levelOf(any);
        level["mods"] = {"odd"};
        level["objects"][1]["properties"]["scripts"] = {{{"script", "Dynamics <- Odd"}}};
        fs::path const file = own / "level.json";
        write(file, inFile(level));
        player.app().showTitle();
        drop(player, file);
        lookAtLevel(player);
        player.app().edit(file);
        look(player);
        lookAtEditor(player);
        player.app().showTitle();
    });
}

TEST_F(AnyFile, OfAPartIsShown) {
    each(
        [&](AnyText& any, fs::path const& own) {
            ::setenv("XDG_DATA_HOME", own.c_str(), 1);
            std::string const name = any.name();
            Json part{
                {"name", name},
                {"title", any.name()},
                {"text", any.text()},
                {"texts", {{"de", {{"title", any.name()}, {"text", any.text()}}}}},
                {"look", {{"colour", "#b5372f"}, {"label", any.text(40)}}},
                {"properties",
                 {{"material", "wood"}, {"shape", {{{"form", "box"}, {"width", 0.7}, {"height", 0.2}}}}}}};
            write(own / "trembler/parts" / (any.fileName() + ".json"), maybeDamaged(any, part));
            write(own / "trembler/parts" / (any.fileName() + ".json"),
                  maybeDamaged(any, part)); // the same name
            Json level = levelOf(any);
            level["toolbox"].push_back({{"part", name}, {"count", 3}});
            fs::path const file = own / "level.json";
            write(file, inFile(level));
            Player player;
            player.app().edit(file); // reads the player's own parts
            look(player);
            lookAtEditor(player);
            player.app().showTitle();
            drop(player, file);
            lookAtLevel(player);
            player.app().showTitle();
        },
        3);
}

TEST_F(AnyFile, OfTheProfileIsRead) {
    each(
        [&](AnyText& any, fs::path const& own) {
            Json profile{{"ui_scale", any.oneIn(2) ? Json(any.text(50)) : Json(1e30)},
                         {"language", any.oneIn(2) ? "de" : any.text()},
                         {"volume", -1e300},
                         {"solved", {any.text(), 3, any.text()}}};
            for (char const* const command : {"run", "hint", "redo", "menu", "move-left", "fast"}) {
                Json names = Json::array();
                for (std::size_t i = any.below(4); i > 0; --i) {
                    names.push_back(any.oneIn(3) ? "Ctrl+Y" : any.text(120'000));
                }
                profile["keys"][command] = std::move(names);
            }
            profile["keys"][any.text()] = {any.text(120'000)};
            for (std::size_t i = any.below(5); i > 0; --i) {
                profile["progress"][any.text()] = {
                    {"kinds",
                     {{{"parts", {any.text()}}, {"actions", {any.text()}}, {"causes", {any.text()}}}}}};
            }
            write(own / "profile.json", maybeDamaged(any, profile));
            Player player({1280, 720}, own / "profile.json");
            look(player);
            player.app().openMenu(MenuPage::keys);
            look(player);
            player.app().openMenu(MenuPage::settings);
            look(player);
            player.app().openMenu(MenuPage::levels);
            look(player);
        },
        3);
}

TEST_F(AnyFile, OfAPackIsListed) {
    each(
        [&](AnyText& any, fs::path const& own) {
            fs::path const levels = own / "levels";
            for (std::size_t chapters = 1 + any.below(3); chapters > 0; --chapters) {
                fs::path const chapter = levels / any.fileName();
                Json about{{"title", any.name()},
                           {"text", any.text()},
                           {"order", 1},
                           {"texts", {{"de", {{"title", any.name()}, {"text", any.text()}}}}}};
                write(chapter / "chapter.json", maybeDamaged(any, about));
                for (std::size_t count = 1 + any.below(3); count > 0; --count) {
                    write(chapter / (any.fileName() + ".json"), maybeDamaged(any, levelOf(any)));
                }
                std::string odd = any.fileName();
                odd[0] = '\xff'; // no UTF-8
                write(chapter / (odd + ".json"), maybeDamaged(any, levelOf(any)));
            }
            Player player({1280, 720}, {}, levels);
            look(player);
            player.app().openMenu(MenuPage::levels);
            look(player);
            for (int chapter = 1; player.shows("chapter " + std::to_string(chapter)); ++chapter) {
                player.clickItem("chapter " + std::to_string(chapter));
                look(player);
            }
            press(player, {SDLK_ESCAPE, SDLK_RETURN});
        },
        3);
}

TEST_F(AnyFile, OfASolutionIsListedAndLoaded) {
    Player player({1280, 720}, folder / "profile.json");
    fs::path const level = levelsFolder() / "first/1-first-contact.json";
    each([&](AnyText& any, fs::path const& own) {
        Json solution{
            {"name", any.text(any.oneIn(2) ? 90 : 60'000)},
            {"placements", {{{"part", any.oneIn(2) ? "steel bar" : any.text()}, {"at", {-1.8, 1.3}}}}}};
        fs::path const file = own / (any.fileName() + ".json");
        write(file, maybeDamaged(any, solution));
        fs::path const all = folder / "solutions";
        fs::path const kept = all / KeptBuilds(all).fileOf("first/1-first-contact.json").stem();
        write(kept / (any.fileName() + ".json"), maybeDamaged(any, solution));
        player.open(level);
        drop(player, file);
        player.app().openMenu(MenuPage::solutions);
        look(player);
        press(player, {SDLK_ESCAPE});
    });
    player.app().showTitle();
}

TEST_F(AnyFile, ManyLongHintsOfALevelAreShownAtOnce) {
    AnyText any(1);
    Json level = levelOf(any);
    level["hints"] = Json::array();
    std::size_t bytes = 0;
    for (int i = 0; i < 30; ++i) {
        level["hints"].push_back(any.text(i % 2 == 0 ? 60'000 : 300));
        bytes += level["hints"].back().get_ref<std::string const&>().size();
    }
    ASSERT_GT(bytes, 100'000U);
    fs::path const file = folder / "hints.json";
    write(file, inFile(level));
    Player player;
    player.open(file);
    for (int i = 0; i < 30; ++i) {
        player.key(SDLK_h);
    }
    look(player, 8);
    player.look("any-file-hints");
}

} // namespace
} // namespace any_file_test
} // namespace trembler::ui::test
