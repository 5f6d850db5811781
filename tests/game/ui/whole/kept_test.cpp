// What cannot be written, and what was damaged, is said in the window, on the real screens.
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/recovery/autosave.hpp"
#include "tests/game/ui/drawn_text.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <cstdlib>
#include <fstream>
#include <optional>

namespace trembler::ui::test {
namespace kept_test {
namespace {

namespace fs = std::filesystem;

constexpr render::Size sizes[] = {{1280, 720}, {800, 600}};

/// A file where a folder should be: nobody can write below it, not even the administrator.
class Blocked : public testing::Test {
protected:
    Blocked() {
        fs::remove_all(folder);
        fs::create_directories(folder);
        block();
    }
    ~Blocked() override {
        if (before) {
            ::setenv("XDG_DATA_HOME", before->c_str(), 1);
        } else {
            ::unsetenv("XDG_DATA_HOME");
        }
        fs::remove_all(folder);
    }
    void block() const {
        fs::remove_all(place);
        std::ofstream(place) << "not a folder";
    }
    void free() const { fs::remove_all(place); }
    /// The editor's recovery files, which are kept by the environment.
    void dataIn(fs::path const& where) {
        char const* const stated = std::getenv("XDG_DATA_HOME");
        before = stated == nullptr ? std::nullopt : std::optional<std::string>(stated);
        ::setenv("XDG_DATA_HOME", where.c_str(), 1);
    }
    /// Whether the picture has these words, once messages have faded in.
    static bool says(Player& player, std::string const& words) {
        player.frames(20);
        // The lines of a message follow one another. Gaps are left out: where letters are small, one between
        // two of them may look like one between words.
        auto const withoutGaps = [](std::string text) {
            std::erase(text, ' ');
            return text;
        };
        std::string all;
        for (DrawnText const& text : drawnTexts()) {
            all += withoutGaps(text.text);
        }
        return all.find(withoutGaps(words)) != std::string::npos;
    }
    static void wait(Player& player, double seconds) {
        for (double passed = 0; passed < seconds; passed += 0.1) {
            player.app().frame(0.1, false);
        }
        player.frame();
    }

    fs::path const folder = testFolder() / "kept";
    fs::path const place = folder / "place";
    std::optional<std::string> before;
};

TEST_F(Blocked, StarsAndSettingsAreReportedOnceAndWrittenLater) {
    struct InLanguage {
        char const* id;
        char const* not_written;
        char const* advice;
        char const* written;
    };
    for (InLanguage const& language :
         {InLanguage{"en", "Your stars and settings", "move away", "What could not be saved is saved now."},
          InLanguage{"de", "Deine Sterne und Einstellungen", "räume weg",
                     "Was sich nicht speichern ließ, ist jetzt gespeichert."}}) {
        for (render::Size const size : sizes) {
            block();
            Player player(size, place / "profile.json");
            UiContext& context = player.app().context();
            changeSettings(context, {.reducedMotion = true, .language = language.id});
            player.open(levelsFolder() / "first/1-first-contact.json");
            EXPECT_EQ(context.toasts.count(), 1U);
            EXPECT_TRUE(says(player, language.not_written)) << context.toasts.newest();
            EXPECT_NE(context.toasts.newest().find(language.advice), std::string::npos)
                << context.toasts.newest();
            player.look(std::string("kept-profile-") + language.id + "-" + std::to_string(size.width));
            for (DrawnText const& text : drawnTexts()) {
                EXPECT_LE(text.rect.high.x, size.width);
                EXPECT_LE(text.rect.high.y, size.height);
            }
            context.profile.markSolved("x");
            wait(player, Profile::patience + 1);
            EXPECT_EQ(context.toasts.count(), 1U) << "it is said once";
            free();
            wait(player, Profile::patience + 1);
            EXPECT_EQ(context.toasts.newest(), language.written);
            Profile const kept(place / "profile.json");
            EXPECT_TRUE(kept.solved("x"));
            EXPECT_EQ(kept.settings().language, language.id);
        }
    }
}

TEST_F(Blocked, ADamagedProfileIsReportedAndTheLastGoodOneTaken) {
    free();
    fs::path const file = place / "profile.json";
    for (render::Size const size : sizes) {
        fs::remove_all(place);
        bool const german = size.width == 800;
        {
            Profile profile(file);
            Settings settings;
            settings.language = german ? "de" : "en";
            profile.setSettings(settings);
            profile.markSolved("first/1-first-contact.json");
            profile.markSolved("x");
        }
        fs::resize_file(file, fs::file_size(file) - 10);
        std::string const damaged = textOfFile(file);
        Player player(size, file);
        EXPECT_TRUE(says(player, german ? "war beschädigt" : "was damaged"))
            << player.app().context().toasts.newest();
        EXPECT_TRUE(player.app().context().profile.solved("first/1-first-contact.json"));
        player.look("kept-damaged-" + std::to_string(size.width));
        Settings settings = player.app().context().profile.settings();
        settings.volume = 5;
        changeSettings(player.app().context(), settings);
        EXPECT_EQ(textOfFile(file.string() + ".damaged-1"), damaged)
            << "a changed setting overwrites nothing";
        EXPECT_TRUE(Profile(file).solved("first/1-first-contact.json"));
    }
}

TEST_F(Blocked, PicturesSolutionsAndBuildsAreReportedAndWrittenLater) {
    Player player({800, 600}, place / "profile.json");
    UiContext& context = player.app().context();
    fs::remove_all(player.films());
    std::ofstream(player.films()) << "not a folder";
    player.open(levelsFolder() / "first/1-first-contact.json");
    player.key(SDLK_F12);
    player.look("kept-picture-800");
    EXPECT_TRUE(says(player, "The picture cannot be saved")) << context.toasts.newest();
    ASSERT_TRUE(player.session().place({"steel bar", {-1.8, 1.3}, 0, ""}));
    wait(player, 2);
    EXPECT_TRUE(says(player, "What you built cannot be saved")) << context.toasts.newest();
    player.key(SDLK_SPACE);
    player.frames(10);
    player.key(SDLK_s, KMOD_LCTRL);
    EXPECT_TRUE(says(player, "The solution cannot be saved")) << context.toasts.newest();
    EXPECT_EQ(context.pending.waiting(), 2U);
    player.look("kept-solution-800");
    free();
    fs::remove(player.films());
    wait(player, PendingWrites::patience + 1);
    EXPECT_EQ(context.pending.waiting(), 0U);
    EXPECT_TRUE(fs::exists(player.films() / "picture-1.png"));
    EXPECT_EQ(context.solutions.of("first/1-first-contact.json").size(), 1U);
    EXPECT_TRUE(fs::exists(context.builds.fileOf("first/1-first-contact.json")));
    EXPECT_FALSE(context.builds.unwritten());
    fs::remove_all(player.films());
}

TEST_F(Blocked, QuittingAsksOnceWhileSomethingIsNotSaved) {
    auto const quit = [](Player& player) {
        SDL_Event event{};
        event.type = SDL_QUIT;
        SDL_PushEvent(&event);
        player.frames(2);
    };
    {
        Player player({800, 600}, place / "profile.json");
        player.app().context().profile.markSolved("x");
        quit(player);
        EXPECT_TRUE(player.going());
        EXPECT_TRUE(says(player, "Not everything is saved")) << player.app().context().toasts.newest();
        player.look("kept-quit-800");
        quit(player);
        EXPECT_FALSE(player.going()) << "the player has agreed";
    }
    Player player({800, 600}, place / "profile.json");
    player.app().context().profile.markSolved("x");
    free();
    quit(player);
    EXPECT_FALSE(player.going()) << "it could be written at the last moment";
    EXPECT_TRUE(Profile(place / "profile.json").solved("x"));
}

TEST_F(Blocked, UnsavedWorkInTheEditorIsReported) {
    struct InLanguage {
        char const* id;
        char const* toast;
        char const* beside;
    };
    dataIn(place);
    for (InLanguage const& language :
         {InLanguage{"en", "Your changes to the level", "not safe from a crash"},
          InLanguage{"de", "Deine Änderungen am Level", "vor einem Absturz nicht sicher"}}) {
        for (render::Size const size : sizes) {
            block();
            Designer designer(size, folder / "profile.json");
            UiContext& context = designer.app().context();
            changeSettings(context, {.reducedMotion = true, .language = language.id});
            designer.editCopyOf(levelsFolder() / "first/1-first-contact.json");
            EXPECT_EQ(context.toasts.count(), 0U);
            EXPECT_TRUE(designer.parts().run(
                [](edit::Json const& level) { return edit::setTitle(level, "another"); }));
            wait(designer, 1.5);
            EXPECT_TRUE(says(designer, language.toast)) << context.toasts.newest();
            EXPECT_TRUE(designer.shows("not safe"));
            EXPECT_TRUE(says(designer, language.beside)) << language.id << " " << size.width;
            designer.look(std::string("kept-editor-") + language.id + "-" + std::to_string(size.width));
            std::size_t const said = context.toasts.count();
            wait(designer, 3);
            EXPECT_LE(context.toasts.count(), said) << "it is said once";
            free();
            wait(designer, 1.5);
            EXPECT_FALSE(designer.shows("not safe"));
            EXPECT_FALSE(edit::findRecoveries(place / "trembler" / "recovery").size() > 1);
            EXPECT_FALSE(designer.parts().autosave->error());
            EXPECT_TRUE(fs::exists(designer.parts().autosave->file()));
        }
    }
}

TEST_F(Blocked, ALevelThatCannotBeSavedIsReportedWithTheReason) {
    Designer designer({800, 600});
    free();
    fs::create_directories(place);
    fs::copy_file(levelsFolder() / "first/1-first-contact.json", place / "level.json");
    designer.app().edit(place / "level.json");
    designer.frames(4);
    EXPECT_TRUE(
        designer.parts().run([](edit::Json const& level) { return edit::setTitle(level, "another"); }));
    block();
    designer.ctrl(SDLK_s);
    designer.look("kept-level-800");
    EXPECT_TRUE(says(designer, "The level cannot be saved")) << designer.app().context().toasts.newest();
    EXPECT_TRUE(designer.parts().document.modified());
    free();
    fs::create_directories(place);
    designer.ctrl(SDLK_s);
    EXPECT_FALSE(designer.parts().document.modified());
    EXPECT_NE(textOfFile(place / "level.json").find("another"), std::string::npos);
}

TEST_F(Blocked, ADamagedLevelIsOfferedAsItsLastGoodVersion) {
    for (bool const german : {false, true}) {
        free();
        fs::create_directories(place);
        KeptFile const level(place / "level.json");
        std::string const good = textOfFile(levelsFolder() / "first/1-first-contact.json");
        level.write(good);
        level.write(good + "\n");
        fs::resize_file(level.path(), good.size() / 2);
        std::string const damaged = textOfFile(level.path());
        Designer designer(sizes[german ? 1 : 0], folder / "profile.json");
        changeSettings(designer.app().context(), {.reducedMotion = true, .language = german ? "de" : "en"});
        designer.app().edit(level.path());
        designer.frames(4);
        EXPECT_TRUE(designer.parts().document.readOnly());
        EXPECT_TRUE(says(designer, german ? "letzte gute Fassung" : "last good version"));
        EXPECT_TRUE(says(designer, "level.json~"));
        designer.look(std::string("kept-damaged-level-") + (german ? "de" : "en"));
        designer.clickItem("take last good");
        designer.frames(4);
        EXPECT_FALSE(designer.parts().document.readOnly());
        EXPECT_FALSE(designer.parts().document.modified());
        EXPECT_EQ(designer.parts().document.path(), level.path());
        EXPECT_EQ(textOfFile(level.path()), good);
        EXPECT_EQ(textOfFile(place / "level.json.damaged-1"), damaged);
        EXPECT_NE(designer.app().context().toasts.newest().find("level.json.damaged-1"), std::string::npos);
        EXPECT_TRUE(
            designer.parts().run([](edit::Json const& tree) { return edit::setTitle(tree, "another"); }));
        EXPECT_TRUE(designer.parts().document.save().ok());
    }
}

TEST_F(Blocked, ALevelWithOtherErrorsIsOfferedWithoutAnEarlierVersion) {
    free();
    fs::create_directories(place);
    KeptFile const level(place / "level.json");
    level.write(textOfFile(levelsFolder() / "first/1-first-contact.json"));
    level.write(R"({"version": 2, "title": 3})"); // whole, but no level
    Designer designer({800, 600});
    designer.app().edit(level.path());
    designer.frames(4);
    EXPECT_TRUE(designer.shows("understood"));
    EXPECT_FALSE(designer.shows("take last good"));
}

TEST_F(Blocked, UnsavedWorkBeyondTheBoundIsMentioned) {
    free();
    dataIn(place);
    fs::path const recovery = place / "trembler" / "recovery";
    fs::create_directories(recovery);
    for (int i = 0; i < 1002; ++i) {
        std::ofstream(recovery / (std::to_string(i) + ".json"))
            << R"({"recovery": 1, "level": "/another/level.json", "text": "{}"})";
    }
    Designer designer({800, 600}, folder / "profile.json");
    designer.editNew();
    EXPECT_TRUE(says(designer, "2 older files stay in")) << designer.app().context().toasts.newest();
    designer.look("kept-recoveries-800");
}

} // namespace
} // namespace kept_test
} // namespace trembler::ui::test
