// The game in its window: title screen, levels, menu.
#pragma once

#include "game/ui/app/menu.hpp"
#include "game/ui/play/play_screen.hpp"
#include "game/ui/shared/screen.hpp"
#include "game/ui/shared/ui_context.hpp"

#include <filesystem>
#include <memory>

namespace trembler::ui {

struct GameOptions {
    std::filesystem::path levels;         ///< folder of the levels to choose from
    std::filesystem::path pictures = "."; ///< films and pictures go below
    std::filesystem::path profile;        ///< settings and progress; empty: nothing is kept
    WorldOptions world;
    Loudspeaker* loudspeaker = nullptr; ///< must outlive the game; nullptr: it is silent
    bool steady = false;                ///< nothing blinks: for tests
};

/// Driven picture by picture, so that tests can play it with pushed events. Thread of the window only; the
/// window, the registry and the parts must outlive it.
class GameApp {
public:
    /// Throws render::RenderError if the graphics card cannot draw the game.
    GameApp(render::Window& window, Registry const& registry, PartLibrary const& parts,
            GameOptions const& options);
    ~GameApp();
    GameApp(GameApp const&) = delete;
    GameApp& operator=(GameApp const&) = delete;

    /// Opens a level. Throws InputError if it cannot be read or built; what was on the screen then stays.
    void open(std::filesystem::path const& level);
    void showTitle();
    /// Puts a screen in the place of the one before, which is left. Not nullptr.
    void show(std::unique_ptr<Screen> screen);

    /// One picture: takes SDL's events, lets `seconds` pass, draws and presents. False once the player wants
    /// to go. With `seen` false nobody looks, as at a minimised window: the picture is drawn and presented
    /// only if the screen keeps it, and everything else happens as usual.
    bool frame(double seconds, bool seen = true);

    [[nodiscard]] Screen& screen() { return *screen_; }
    /// The screen if it is that of a level, else nullptr: for tests, the program itself does not ask.
    [[nodiscard]] PlayScreen* play() { return dynamic_cast<PlayScreen*>(screen_.get()); }
    [[nodiscard]] UiContext& context() { return context_; }
    [[nodiscard]] Menu const& menu() const { return menu_; }

private:
    void update(double seconds);
    void follow(ScreenRequest const& request);
    void tryOpen(std::filesystem::path const& level);
    void toggleFullscreen();

    GameOptions options_;
    UiContext context_;
    Menu menu_;
    std::unique_ptr<Screen> screen_; // never nullptr
    bool going_ = true;
};

} // namespace trembler::ui
