// `trembler play`: the game in a window, or a run with a picture where there is no window.
#pragma once

#include "game/ui/app/app.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/world/world.hpp"

#include <filesystem>
#include <iosfwd>

namespace trembler::ui {

struct PlayOptions {
    std::filesystem::path level; ///< empty: the title screen
    std::filesystem::path
        pictures; ///< folder for clips and pictures; empty: see usualPicturesFolder(), without a display "."
    std::filesystem::path
        picture; ///< file that playWithoutDisplay writes; empty: trembler-NAME.png in `pictures`
    WorldOptions world{};
    bool fullscreen = false;
    bool edits = false;                        ///< `level` is opened in the editor; empty: a new one
    LevelData levelData{};                     ///< see GameOptions
    std::vector<std::filesystem::path> mods{}; ///< see GameOptions
    ModData modData{};                         ///< see GameOptions
};

/// Opens the window and plays until the player leaves; returns 0. Throws render::WindowError of kind
/// NoDisplay or NoOpenGl if no window can be opened. If the level cannot be played the title screen says why.
int playInWindow(GameData const& gameData, PlayOptions const& options);

/// Runs the level's first recorded solution (without a level: of the first level that has one), prints the
/// result, writes a picture of it and prints its path. Where no picture can be drawn it says so and still
/// runs the level. Returns 0 if the level was solved, 1 if it was not. Throws InputError if the level cannot
/// be played.
int playWithoutDisplay(GameData const& gameData, PlayOptions const& options, std::ostream& out);

/// playInWindow, or, where there is no display or no OpenGL, playWithoutDisplay on standard output with the
/// reason.
int play(GameData const& gameData, PlayOptions const& options);

} // namespace trembler::ui
