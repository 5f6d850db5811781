// A simulated player: moves the mouse, presses keys, reads the screen.
#pragma once

#include "game/ui/app/app.hpp"
#include "game/ui/play/play_screen.hpp"
#include "tests/support/game_data.hpp"
#include "tests/support/synthetic_input.hpp"

#include <SDL.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace trembler::ui::test {

using render::MouseButton;
using render::Point;

inline std::unique_ptr<render::Window>& windowSlot() {
    static std::unique_ptr<render::Window> slot;
    return slot;
}
/// Opened on first use and kept: SDL works best with one window at a time. With TREMBLER_TEST_WINDOW in the
/// environment the window is on the screen, as for players: see scripts/checks.d/xvfb.sh.
inline render::Window& window() {
    auto& slot = windowSlot();
    if (!slot) {
        bool const seen = std::getenv("TREMBLER_TEST_WINDOW") != nullptr;
        slot = std::make_unique<render::Window>(
            render::WindowOptions{.size = {1280, 720},
                                  .mode = seen ? render::WindowMode::Visible : render::WindowMode::Offscreen,
                                  .waitForScreen = false});
    }
    return *slot;
}
/// For tests of code that opens its own window.
inline void closeWindow() {
    windowSlot().reset();
}

/// With the mods that a level names: mods beside it, or mods that come with the program.
inline std::shared_ptr<GameData const> dataWithMods(std::filesystem::path const& level) {
    std::vector<std::string> const names = lua::modsNamedBy(level);
    if (names.empty()) {
        return nullptr;
    }
    Problems problems;
    std::vector<std::filesystem::path> const folders{level.parent_path() / "mods",
                                                     std::filesystem::path(TREMBLER_SOURCE_DIR) / "mods"};
    auto mods = lua::findMods(names, folders, level.string(), problems);
    problems.throwIfAny();
    return std::make_shared<GameData const>(std::move(mods));
}

/// With mods from the folders in which these stand.
inline std::shared_ptr<GameData const> dataWith(std::vector<std::string> const& names,
                                                std::vector<std::filesystem::path> const& installed) {
    std::vector<std::filesystem::path> folders;
    for (std::filesystem::path const& mod : installed) {
        folders.push_back(mod.parent_path());
    }
    Problems problems;
    auto mods = lua::findMods(names, folders, "", problems);
    problems.throwIfAny();
    return std::make_shared<GameData const>(std::move(mods));
}

inline std::filesystem::path levelsFolder() {
    return std::filesystem::path(TREMBLER_SOURCE_DIR) / "levels";
}
inline std::filesystem::path dataFolder() {
    return std::filesystem::path(TREMBLER_SOURCE_DIR) / "tests/game/ui/data";
}
/// The game's own levels, which every player has: they are read once.
inline LevelCatalog const& gameLevels() {
    static LevelCatalog const theLevels(gameData().registry, levelsFolder(), {.data = dataWithMods});
    return theLevels;
}
/// A folder of this program's own; pictures in it are for people to look at.
inline std::filesystem::path pictureFolder() {
    auto folder = std::filesystem::path(TREMBLER_BINARY_DIR) / "ui-pictures";
    std::filesystem::create_directories(folder);
    return folder;
}

/// A folder of the running test's own: tests run in parallel, each in a process, and some remove the folder's
/// files.
inline std::filesystem::path testFolder() {
    testing::TestInfo const& test = *testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test.test_suite_name()) + "." + test.name();
    std::replace(name.begin(), name.end(), '/', '-'); // of a suite with parameters
    auto folder = pictureFolder() / name;
    std::filesystem::create_directories(folder);
    return folder;
}

/// Plays the game with pushed events only, a sixtieth of a second per picture. Drawing takes a hundred times
/// as long as everything else in a picture, so a picture is drawn only if look() or the game itself uses it.
class Player {
public:
    explicit Player(render::Size size = {1280, 720}, std::filesystem::path profile = {},
                    std::filesystem::path levels = levelsFolder(), Loudspeaker* loudspeaker = nullptr,
                    budget::BudgetMode::Stopwatch stopwatch = {},
                    std::vector<std::filesystem::path> const& mods = {}) {
        SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
        window().resize(size);
        films_ = testFolder() / "films";
        LevelCatalog const* const catalog = levels == levelsFolder() ? &gameLevels() : nullptr;
        app_ = std::make_unique<GameApp>(
            window(), gameData().registry, gameData().parts,
            GameOptions{
                .levels = std::move(levels),
                .pictures = films_,
                .profile = std::move(profile),
                .world = {},
                .loudspeaker = loudspeaker,
                .steady = true,
                .levelData = dataWithMods,
                .mods = mods,
                .modData = [mods](std::vector<std::string> const& names) { return dataWith(names, mods); },
                .catalog = catalog,
                .stopwatch = std::move(stopwatch)});
        app_->context().shadows = false; // half the time of a picture, on a computer without a graphics card
        frames(3);
    }

    GameApp& app() { return *app_; }
    /// The current screen if it shows a level, else nullptr.
    PlayScreen* findPlay() { return dynamic_cast<PlayScreen*>(&app_->screen()); }
    /// Only while a level is on the screen.
    PlayScreen& play() { return *findPlay(); }
    Session& session() { return play().session(); }
    Layout const& layout() { return app_->context().layout; }
    std::filesystem::path const& films() const { return films_; }

    /// From now on draws every picture, as the window does: for tests of drawing itself, or of when it is
    /// done.
    void drawEveryPicture() { drawsAll_ = true; }

    void open(std::filesystem::path const& level) {
        app_->open(level);
        frames(4);
    }
    bool frame() { return going_ = app_->frame(1.0 / 60, drawsAll_); }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            frame();
        }
    }
    /// Computes this number of frames of the running world in few pictures.
    void simulate(int count) {
        for (; count > 0; count -= 8) {
            going_ = app_->frame(std::min(count, 8) / 60.0, drawsAll_);
        }
    }
    [[nodiscard]] bool going() const { return going_; }

    // Positions on the screen.
    Point at(Vec2 world) { return play().camera().toScreen({world.x, world.y}); }
    Point item(std::string const& name) {
        auto const rect = layout().item(name);
        EXPECT_TRUE(rect) << "nothing called \"" << name << "\" is on the screen";
        return rect ? rect->middle() : Point{};
    }
    bool shows(std::string const& name) { return layout().item(name).has_value(); }
    bool showsCard(std::string const& name) { return layout().card(name).has_value(); }

    // Input with the mouse and the keyboard.
    void moveTo(Point to) {
        render::pushMouseMove(window(), to);
        mouse_ = to;
        frame();
    }
    void press(MouseButton button = MouseButton::Left) {
        render::pushMouseButton(window(), button, true, mouse_);
        frame();
    }
    void release(MouseButton button = MouseButton::Left) {
        render::pushMouseButton(window(), button, false, mouse_);
        frame();
    }
    void click(Point where, MouseButton button = MouseButton::Left) {
        moveTo(where);
        press(button);
        release(button);
        frame();
    }
    void clickItem(std::string const& name) { click(item(name)); }
    /// The page of keys in the menu, by mouse.
    void openKeysPage() {
        for (char const* const entry : {"menu", "menu.settings", "Change the keys"}) {
            clickItem(entry);
            frames(3);
        }
    }
    void drag(Point from, Point to, MouseButton button = MouseButton::Left, int steps = 4) {
        moveTo(from);
        press(button);
        for (int i = 1; i <= steps; ++i) {
            moveTo(from + (1.0 * i / steps) * (to - from));
        }
        release(button);
        frame();
    }
    void wheel(int notches) {
        render::pushWheel(window(), notches);
        frame();
    }
    /// Scrolls a card down by the wheel until an item of it is in sight.
    void scrollTo(std::string const& card, std::string const& item) {
        auto const shown = layout().card(card);
        ASSERT_TRUE(shown) << "there is no card \"" << card << "\"";
        moveTo(shown->middle());
        for (int notches = 0; notches < 60 && !shows(item); ++notches) {
            wheel(-1);
        }
        frames(2);
    }
    void key(SDL_Keycode key, unsigned modifiers = KMOD_NONE) {
        render::pushKey(window(), key, true, modifiers);
        frame();
        render::pushKey(window(), key, false, KMOD_NONE);
        frame();
    }
    void hold(SDL_Keycode key) {
        render::pushKey(window(), key, true);
        frame();
    }
    void letGo(SDL_Keycode key) {
        render::pushKey(window(), key, false);
        frame();
    }

    /// The pixels of the screen; with TREMBLER_PICTURES in the environment they are also written to a file.
    render::Image look(std::string const& name) {
        going_ = app_->frame(1.0 / 60, true);
        render::Image image = window().readPixels();
        // Packing takes longer than drawing, and up to seconds: only with TREMBLER_PICTURES.
        if (std::getenv("TREMBLER_PICTURES") != nullptr) {
            writePng(image, pictureFolder() / (name + ".png"));
        }
        return image;
    }

private:
    std::filesystem::path films_;
    std::unique_ptr<GameApp> app_;
    Point mouse_;
    bool going_ = true;
    bool drawsAll_ = false;
};

} // namespace trembler::ui::test
