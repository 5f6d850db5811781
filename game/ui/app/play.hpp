// `trembler play`: the game in a window, or what can be done without one.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "runtime/world/world.hpp"

#include <filesystem>
#include <iosfwd>

namespace trembler::ui {

struct PlayOptions {
    std::filesystem::path level;          ///< empty: the title screen
    std::filesystem::path pictures = "."; ///< folder for films and pictures that the player takes
    std::filesystem::path picture; ///< what playWithoutDisplay writes; empty: trembler-NAME.png in `pictures`
    WorldOptions world{};
    bool fullscreen = false;
};

/// Opens the window and plays until the player leaves; returns 0. Throws render::WindowError if there is no
/// window to be had, of kind NoDisplay or NoOpenGl, and InputError if the level cannot be played.
int playInWindow(GameData const& gameData, PlayOptions const& options);

/// Plays the level's first recorded solution (of no level: of the first level that has one), says in plain
/// words what came of it, writes a picture of it and says where. Where nothing can be drawn at all it says so
/// and still plays. Returns 0 if the level was solved, 1 if it was not. Throws InputError if the level cannot
/// be played.
int playWithoutDisplay(GameData const& gameData, PlayOptions const& options, std::ostream& out);

/// playInWindow, or playWithoutDisplay on standard output where there is no display or no OpenGL, saying why.
int play(GameData const& gameData, PlayOptions const& options);

} // namespace trembler::ui
