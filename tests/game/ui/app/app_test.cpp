// Title screen, levels, menu, profile; and the program without a display.
#include "game/ui/app/play.hpp"
#include "game/ui/headless/screenshot.hpp"
#include "game/ui/shared/words.hpp"
#include "puzzle/checks/checked_level.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"
#include "tests/support/read_png.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <sstream>

namespace trembler::ui::test {
namespace app_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";

std::filesystem::path freshFolder(char const* name) {
    auto folder = testFolder() / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

/// How many different colours there are; a blank sheet has few.
std::size_t colours(render::Image const& image) {
    std::set<render::Pixel> seen;
    for (int y = 0; y < image.size().height; y += 3) {
        for (int x = 0; x < image.size().width; x += 3) {
            seen.insert(image.at(x, y));
        }
    }
    return seen.size();
}

// Stars that are gone at the next start must not come as a surprise.
TEST(Program, SaysThatNothingIsKeptWithoutAHome) {
    for (bool const nowhere : {false, true}) {
        GameOptions options;
        options.levels = levelsFolder();
        options.nowhere = nowhere;
        options.catalog = &gameLevels();
        GameApp app(window(), gameData().registry, gameData().parts, options);
        EXPECT_EQ(app.context().toasts.troubles(), nowhere ? 1U : 0U);
    }
}

TEST(Program, ALevelIsChosenOnTheTitleScreen) {
    Player player;
    player.drawEveryPicture(); // title, level and menus one after the other, as on a player's screen
    EXPECT_EQ(player.findPlay(), nullptr);
    player.clickItem("play"); // the puzzle to begin with
    ASSERT_NE(player.findPlay(), nullptr);
    EXPECT_EQ(player.session().level().title, loadLevel(gameData().registry, firstContact).title);
    player.key(SDLK_l);
    player.frames(2);
    for (int chapter = 1; !player.shows("level 3-magnets/1-through-the-glass.json"); ++chapter) {
        player.clickItem("chapter " + std::to_string(chapter));
        player.frames(2);
        EXPECT_FALSE(player.shows("level experiments/1-switched-electromagnet.json"))
            << "demonstrations have a page of their own";
    }
    player.clickItem("level 3-magnets/1-through-the-glass.json");
    EXPECT_EQ(player.play().file().filename(), "1-through-the-glass.json");
    EXPECT_FALSE(player.app().menu().isOpen());
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.clickItem("menu.title");
    EXPECT_EQ(player.findPlay(), nullptr);
    player.frames(2);
    EXPECT_TRUE(player.going());
    player.moveTo(player.item("quit"));
    player.press();
    render::pushMouseButton(window(), MouseButton::Left, false, player.item("quit"));
    EXPECT_FALSE(player.frame());
}

TEST(Program, TheWindowsCloseButtonEndsIt) {
    Player player;
    render::pushQuit();
    EXPECT_FALSE(player.frame());
}

TEST(Program, EveryLevelIsInTheCatalog) {
    LevelCatalog const catalog(gameData().registry, levelsFolder());
    EXPECT_EQ(catalog.size(), gameData().levels().size());
    ASSERT_FALSE(catalog.groups().empty());
    EXPECT_EQ(catalog.groups().front().title, "First steps");
    EXPECT_TRUE(catalog.groups().back().gallery) << "demonstrations come after all puzzles";
    ASSERT_NE(catalog.after(firstContact), nullptr);
    for (CatalogGroup const& group : catalog.groups()) {
        for (CatalogEntry const& entry : group.levels) {
            EXPECT_TRUE(entry.trouble.empty()) << entry.trouble;
        }
    }
}

TEST(Program, ABrokenLevelIsShownAndNothingIsLost) {
    auto const folder = freshFolder("levels");
    std::ofstream(folder / "1-broken.json") << "{\"version\": 1, \"title\": ";
    std::ofstream(folder / "10-nonsense.json") << "[]";
    std::filesystem::copy(firstContact, folder / "2-good.json");
    LevelCatalog const catalog(gameData().registry, folder);
    ASSERT_EQ(catalog.groups().size(), 1U);
    auto const& levels = catalog.groups()[0].levels;
    ASSERT_EQ(levels.size(), 3U);
    EXPECT_EQ(levels[0].id, "1-broken.json");
    EXPECT_EQ(levels[1].id, "2-good.json") << "numbers order as numbers";
    EXPECT_FALSE(levels[0].trouble.empty());
    EXPECT_TRUE(levels[1].trouble.empty());
    EXPECT_EQ(catalog.after(levels[0].file), &levels[1]);
    EXPECT_EQ(catalog.after(levels[1].file), nullptr) << "a level that cannot be played is skipped";
    Player player({1280, 720}, {}, folder);
    player.clickItem("levels");
    player.frames(2);
    player.clickItem("level 1-broken.json");
    EXPECT_EQ(player.findPlay(), nullptr);
    EXPECT_THROW(player.app().open(folder / "10-nonsense.json"), InputError);
    EXPECT_TRUE(player.frame());
}

TEST(Program, SettingsAndProgressAreKept) {
    auto const file = freshFolder("profile") / "deep" / "profile.json";
    {
        Player player({1280, 720}, file);
        player.open(firstContact);
        player.key(SDLK_ESCAPE);
        player.frames(2);
        player.clickItem("menu.settings");
        player.frames(4);
        float const before = window().uiScale();
        player.clickItem("115%");
        EXPECT_NEAR(window().uiScale() / before, 1.15F, 0.001F);
        player.app().context().profile.markSolved("first/1-first-contact.json");
    }
    Profile const kept(file);
    EXPECT_NEAR(kept.settings().uiScale, 1.15F, 0.001F);
    EXPECT_TRUE(kept.solved("first/1-first-contact.json"));
    EXPECT_FALSE(kept.solved("another"));
    // Damaged entries of a file are ignored, the others are kept.
    std::ofstream(file) << "{\"ui_scale\": \"large\", \"solved\": [1, \"kept\"], \"shadows\": false}";
    Profile const damaged(file);
    EXPECT_EQ(damaged.settings().uiScale, 1.F);
    EXPECT_FALSE(damaged.settings().shadows);
    EXPECT_TRUE(damaged.solved("kept"));
    window().setUiScaleRequest(1.F);
}

TEST(Program, RestartPutsAllPartsBack) {
    Player player;
    player.open(firstContact);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.5}));
    player.key(SDLK_SPACE);
    player.simulate(30);
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.clickItem("menu.restart");
    EXPECT_EQ(player.session().mode(), SessionMode::building);
    EXPECT_TRUE(player.session().placed().empty());
}

TEST(Program, TheClockComputesSixtyFramesASecondAndDoesNotCatchUp) {
    FrameClock clock;
    int frames = 0;
    for (int i = 0; i < 6000; ++i) {
        frames += clock.due(1.0 / 60);
    }
    EXPECT_EQ(frames, 6000);
    frames = 0;
    clock.reset();
    for (int i = 0; i < 1440; ++i) { // 10 s at 144 Hz
        frames += clock.due(1.0 / 144);
        EXPECT_GE(clock.alpha(), 0);
        EXPECT_LE(clock.alpha(), 1);
    }
    EXPECT_NEAR(frames, 600, 1);
    EXPECT_EQ(clock.due(10), FrameClock::mostFrames) << "after a long pause it does not catch up";
    EXPECT_LE(clock.due(0), 1);
    EXPECT_EQ(clock.due(-5), 0);
    EXPECT_EQ(clock.due(std::nan("")), 0);
    EXPECT_NEAR(clock.due(1.0 / 60, 4), 4, 1);
}

// The following tests open windows of their own.
TEST(Program, AScreenshotIsWrittenAndNotBlank) {
    closeWindow();
    auto const folder = freshFolder("screenshots");
    ScreenshotOptions options;
    auto const drawnAt = [&](std::uint64_t frame) {
        options.frame = frame;
        Session session(gameData().registry, gameData().parts,
                        loadPlayable(gameData().registry, gameData().parts,
                                     levelsFolder() / "experiments/1-switched-electromagnet.json"));
        return screenshot(session, options);
    };
    options.size = {960, 540};
    options.picture.overlays.electricity = true;
    std::uint64_t reported = 0;
    options.progress = [&](std::uint64_t frame) { reported = frame; };
    auto const drawn = drawnAt(90);
    EXPECT_EQ(reported, 90U);
    render::writePng(drawn, folder / "experiment.png");
    auto const image = render::readPng(folder / "experiment.png");
    EXPECT_EQ(image, drawn);
    EXPECT_EQ(image.size(), (render::Size{960, 540}));
    EXPECT_GT(colours(image), 500U);
    EXPECT_NE(drawnAt(0), image);
}

TEST(Program, WithoutADisplayTheRecordedSolutionIsPlayed) {
    closeWindow();
    auto const folder = freshFolder("no-display");
    PlayOptions options;
    options.level = firstContact;
    options.picture = folder / "ended.png";
    std::ostringstream out;
    int const status = playWithoutDisplay(gameData(), options, out);
    LevelFile const level = loadLevel(gameData().registry, firstContact);
    EXPECT_NE(out.str().find(level.title), std::string::npos) << out.str();
    EXPECT_NE(out.str().find((folder / "ended.png").string()), std::string::npos) << out.str();
    EXPECT_GT(colours(render::readPng(options.picture)), 500U);
    if (level.solutions.empty()) {
        EXPECT_EQ(status, 1);
    } else {
        EXPECT_EQ(status, level.solutions.front().solves ? 0 : 1) << out.str();
    }
    // It is written to the folder that the player named.
    PlayOptions elsewhere;
    elsewhere.level = firstContact;
    elsewhere.pictures = folder / "new" / "pictures";
    std::ostringstream third;
    EXPECT_EQ(playWithoutDisplay(gameData(), elsewhere, third), status);
    EXPECT_GT(colours(render::readPng(elsewhere.pictures / "trembler-1-first-contact.png")), 500U);
    // If the picture cannot be written, this is reported and the solution is still played.
    options.picture = folder / "not" / "there.png";
    std::ostringstream second;
    EXPECT_EQ(playWithoutDisplay(gameData(), options, second), status);
    EXPECT_NE(second.str().find("No picture was made"), std::string::npos) << second.str();
}

/// A level that names the mod, in a folder of its own.
std::filesystem::path levelWithMod(std::filesystem::path const& folder, std::string const& name) {
    auto const file = folder / (name + ".json");
    std::ofstream(file) << R"({"version": 2, "title": "With a mod", "mods": [")" << name
                        << R"("], "objects": []})";
    return file;
}

// As other levels that cannot be played: from the command line, the catalog, a dropped file, the editor.
TEST(Program, ALevelWhoseModIsMissingOrBrokenOpensTheWindowWithTheReason) {
    auto const folder = freshFolder("mods");
    std::filesystem::create_directories(folder / "mods/broken/interactions");
    std::ofstream(folder / "mods/broken/mod.json")
        << R"({"name": "broken", "version": "1", "author": "a", "licence": "l"})";
    std::ofstream(folder / "mods/broken/interactions/a.lua") << "return interaction {";
    std::filesystem::create_directories(folder / "mods/torn");
    std::ofstream(folder / "mods/torn/mod.json") << R"({"name": "torn", )";
    auto const missing = levelWithMod(folder, "missing");
    auto const broken = levelWithMod(folder, "broken");
    auto const torn = levelWithMod(folder, "torn");
    Player player({1280, 720}, {}, folder);
    for (auto const& [level, reason] :
         {std::pair(missing, "'missing'"), std::pair(broken, "a.lua"), std::pair(torn, "mod.json")}) {
        player.app().showTitle();
        EXPECT_THROW(player.app().open(level), InputError);
        render::pushDrop(window(), level);
        player.frames(3);
        EXPECT_EQ(player.findPlay(), nullptr);
        EXPECT_NE(player.app().context().toasts.newest().find(reason), std::string::npos)
            << player.app().context().toasts.newest();
        player.app().edit(level);
        player.frames(3);
        EXPECT_TRUE(player.going());
    }
    player.app().showTitle();
    player.frames(2);
    player.clickItem("levels");
    player.frames(3);
    for (char const* const level : {"level missing.json", "level broken.json", "level torn.json"}) {
        EXPECT_TRUE(player.shows(level)) << level;
        player.clickItem(level);
        EXPECT_EQ(player.findPlay(), nullptr) << level;
    }
    for (CatalogEntry const& entry : player.app().context().levels.groups()[0].levels) {
        EXPECT_FALSE(entry.trouble.empty()) << entry.id;
    }
}

// A file in the right form whose goals or task cannot be: found when the card's picture is drawn, by the
// check that opens the level, too.
TEST(Program, ACardSaysWhyItsLevelCannotBePlayed) {
    auto const folder = freshFolder("unplayable");
    std::string const ball = R"("objects": [{"name": "ball", "part": "rubber ball", "at": [0, 1]}],)";
    std::string const head = R"({"version": 2, "title": "T", "world": {"gravity": [0, -9.81]},)";
    std::ofstream(folder / "1-goal.json")
        << head << ball << R"("goals": {"moved": {"object": "bull", "by": 1}}})";
    std::ofstream(folder / "2-task.json")
        << head << ball << R"("demonstration": true, "goals": {"moved": {"object": "ball", "by": 1}},
                              "task": {"moved": {"object": "bull", "by": 1}}})";
    std::ofstream(folder / "3-world.json")
        << head << R"("objects": [{"name": "ball", "part": "no such part", "at": [0, 1]}]})";
    std::filesystem::copy(firstContact, folder / "4-good.json");
    Player player({1280, 720}, {}, folder);
    player.clickItem("levels");
    player.frames(10);
    player.look("levels-unplayable");
    for (char const* const level : {"1-goal.json", "2-task.json", "3-world.json"}) {
        CatalogEntry const* const entry = player.app().context().levels.find(folder / level);
        ASSERT_NE(entry, nullptr) << level;
        std::string why;
        try {
            static_cast<void>(loadPlayable(gameData().registry, gameData().parts, folder / level));
        } catch (InputError const& error) {
            why = error.diagnostics().front().print();
        }
        ASSERT_FALSE(why.empty()) << level;
        EXPECT_EQ(entry->trouble, why);
        player.clickItem(std::string("level ") + level);
        EXPECT_EQ(player.findPlay(), nullptr) << level;
    }
    EXPECT_EQ(player.app().context().levels.find(folder / "4-good.json")->trouble, "");
    player.clickItem("level 4-good.json");
    EXPECT_NE(player.findPlay(), nullptr);
}

TEST(Program, OfTooManyLevelsTheFirstAreListed) {
    auto const folder = freshFolder("many");
    for (int i = 0; i < 10'020; ++i) {
        std::ofstream(folder / fmt::format("{:05}.json", i)) << "{";
    }
    LevelCatalog const catalog(gameData().registry, folder);
    EXPECT_EQ(catalog.size(), 10'000U);
    ASSERT_EQ(catalog.groups().size(), 1U);
    EXPECT_EQ(catalog.groups()[0].levels.back().id, "09999.json");
    EXPECT_NE(catalog.groups()[0].text.find("20 are not listed"), std::string::npos);
    std::filesystem::remove_all(folder);
}

TEST(Program, SmallPicturesOfLevelsAreLimited) {
    render::Canvas canvas;
    LevelPictures pictures(gameData().registry, gameData().parts, canvas, {}, 3);
    std::vector<CatalogEntry> levels;
    for (int i = 0; i < 5; ++i) {
        levels.push_back({firstContact, std::to_string(i), "", ""});
    }
    for (CatalogEntry const& level : levels) {
        pictures.beginFrame();
        EXPECT_NE(pictures.texture(level, {40, 30}), 0U);
        EXPECT_LE(pictures.kept(), 3U);
    }
    pictures.beginFrame();
    EXPECT_NE(pictures.texture(levels[4], {40, 30}), 0U);
    pictures.beginFrame();
    EXPECT_NE(pictures.texture(levels[0], {40, 30}), 0U) << "it is drawn again";
    EXPECT_EQ(pictures.kept(), 3U);
}

} // namespace
} // namespace app_test
} // namespace trembler::ui::test
