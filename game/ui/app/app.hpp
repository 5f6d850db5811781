// The game in its window: shows one screen at a time, and the menu over it.
#pragma once

#include "game/ui/app/click_sounds.hpp"
#include "game/ui/app/menu/menu.hpp"
#include "game/ui/shared/screen.hpp"
#include "game/ui/shared/ui_context.hpp"
#include "puzzle/data/offered_mods.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace trembler::ui {

/// The data for playing a level: with the mods that it names, nullptr if it names none. Throws InputError if
/// one is missing or wrong.
using LevelData = std::function<std::shared_ptr<GameData const>(std::filesystem::path const&)>;

struct GameOptions {
    std::filesystem::path levels;         ///< folder of the levels to choose from
    std::filesystem::path pictures = "."; ///< folder for clips and pictures
    std::filesystem::path profile;        ///< file of settings and progress; empty: nothing is kept
    bool nowhere = false;                 ///< the player has no folder to keep it in, which is said
    WorldOptions world;
    Loudspeaker* loudspeaker = nullptr;        ///< must outlive the game; nullptr: it is silent
    bool steady = false;                       ///< disables blinking, for tests
    LevelData levelData{};                     ///< empty: levels that name mods cannot be played
    std::vector<std::filesystem::path> mods{}; ///< folders of mods whose levels and parts are offered
    ModData modData{};                         ///< empty: free play has no parts of mods
    std::vector<Diagnostic> faults{};          ///< of the player's own parts, which are reported
    std::vector<DamagedFile> damagedParts{};   ///< of the player's own, which are moved aside and reported
    /// The levels as a game with the same levels, data and mods has read them; copied. nullptr: all levels
    /// are read now.
    LevelCatalog const* catalog = nullptr;
    budget::BudgetMode::Stopwatch stopwatch{}; ///< of the time budget; empty: the computer's clock
};

/// Advances one picture per call, so that tests can drive it with pushed SDL events. Only on the window's
/// thread; the window, the registry and the parts must outlive it.
class GameApp {
public:
    /// Throws render::RenderError if the graphics driver cannot draw the game.
    GameApp(render::Window& window, Registry const& registry, PartLibrary const& parts,
            GameOptions const& options);
    ~GameApp();
    GameApp(GameApp const&) = delete;
    GameApp& operator=(GameApp const&) = delete;

    /// Opens a level. Throws InputError if it cannot be read or built; the current screen then stays.
    void open(std::filesystem::path const& level);
    /// Opens the editor with a level file; an empty path: with a new level. A file that cannot be edited is
    /// shown read-only, with the list of its errors.
    void edit(std::filesystem::path const& level);
    void showTitle();
    void openMenu(MenuPage page) { menu_.open(page); }
    /// Replaces the current screen after calling its leave(). Not nullptr.
    void show(std::unique_ptr<Screen> screen);

    /// One picture: handles SDL's events, advances time by `seconds`, draws and presents. Returns false once
    /// the player wants to quit. If `seen` is false, as for a minimised window, the picture is drawn and
    /// presented only if the screen keeps it; everything else happens as usual.
    bool frame(double seconds, bool seen = true);
    /// Whether the next picture would be the same as long as the player does nothing, so that frame() need
    /// not be called before the next event of SDL's, or only with `seen` false.
    [[nodiscard]] bool resting() const { return sinceNews_ > settling; }
    /// How long after the last event pictures may still change, s: tips appear, lists scroll to their place.
    static constexpr double settling = 0.75;

    [[nodiscard]] Screen& screen() { return *screen_; }
    [[nodiscard]] UiContext& context() { return context_; }
    [[nodiscard]] Menu const& menu() const { return menu_; }

    /// Tries once more to write what the disk has not taken so far, before the program ends.
    void keepAtOnce();

private:
    /// Levels get the data with the parts made in the editor, unless they need others.
    [[nodiscard]] GameOptions withNewParts(GameOptions options) const;
    void update(double seconds);
    void follow(ScreenRequest const& request);
    void tryOpen(std::filesystem::path const& level);
    /// With data that have the level's mods, nullptr if it names none; says why if that fails.
    void tryOpen(std::filesystem::path const& level, std::shared_ptr<GameData const> data);
    void openFreePlay();
    /// Names mods whose parts are not offered, with the reasons.
    void tellOfLeftOut(std::vector<LeftOutMod> const& mods);
    /// Opens a level that was dropped onto the window, or a solution of the present one; else says why not.
    void takeDropped(std::filesystem::path const& file);
    /// Whether the present picture shows something that moves or is new.
    [[nodiscard]] bool lively() const;
    void takeKinds();
    void keepOwned(double seconds);
    /// At the first time only a warning, if something would be lost.
    void quit();
    void toggleFullscreen();

    std::shared_ptr<GameData const> newest_; // with the parts made in the editor; nullptr: none was made
    GameOptions options_;
    UiContext context_;
    Menu menu_;
    std::shared_ptr<GameData const> plain_; // for the editor; nullptr until it is opened
    std::unique_ptr<Screen> screen_;        // never nullptr
    ClickSounds clicks_;
    bool going_ = true;
    bool warned_ = false;  // that something would be lost
    double sinceNews_ = 0; // s
};

} // namespace trembler::ui
