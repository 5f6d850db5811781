// A player without knowledge: random events of the mouse, the keyboard and a gamepad, the same for the same
// seed.
#pragma once

#include "game/ui/app/app.hpp"
#include "puzzle/data/game_data.hpp"

#include <SDL_events.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace trembler::ui::test {

/// Plays the whole program in a folder of its own, which is emptied first: it has copies of the levels and
/// the mods, and everything that the program writes goes there. Changes the environment, including
/// XDG_DATA_HOME, and the working folder. Most events hit an item on the screen. Exceptions of the program
/// are passed on. Window thread only.
class RandomPlayer {
public:
    RandomPlayer(render::Window& window, GameData const& data, std::filesystem::path folder,
                 std::uint64_t seed);
    ~RandomPlayer();
    RandomPlayer(RandomPlayer const&) = delete;
    RandomPlayer& operator=(RandomPlayer const&) = delete;

    /// Makes one event, or several that belong together, and one or more pictures. Returns a description for
    /// people.
    std::string act();
    /// Ends the program in order, as on the window's closing; act() must not be called again.
    void end();
    /// The errors in the files that the program has written, for people; empty if there are none. After
    /// end().
    [[nodiscard]] std::vector<std::string> faultsOfFiles() const;

    /// Names of all cards and buttons that have been on the screen.
    [[nodiscard]] std::set<std::string> const& seen() const { return seen_; }
    [[nodiscard]] std::uint64_t pictures() const { return pictures_; }

private:
    using Act = std::string (RandomPlayer::*)();

    void begin();
    std::string beginSomewhere();
    std::string clickItem();
    std::string clickAnywhere();
    std::string moveAnywhere();
    std::string pressOrRelease();
    std::string drag();
    std::string wheel();
    std::string command();
    std::string key();
    std::string type();
    std::string pad();
    std::string wait();
    std::string dropFile();
    std::string resize();
    std::string windowEvent();
    std::string close();

    [[nodiscard]] std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
    [[nodiscard]] bool oneIn(std::size_t count) { return below(count) == 0; }
    [[nodiscard]] render::Point anyPoint();
    [[nodiscard]] render::Size anySize();
    [[nodiscard]] std::filesystem::path anyLevel();
    void pressKey(SDL_Keycode key, unsigned modifiers);
    void frame(double seconds = 1.0 / 60);
    /// Nothing is opened or written outside the player's folder.
    void keepInside();
    void endFilm();

    render::Window& window_;
    GameData const& data_;
    std::filesystem::path folder_;
    std::mt19937_64 random_;
    std::unique_ptr<GameApp> app_;
    std::vector<std::filesystem::path> levels_;
    std::set<std::string> seen_;
    std::uint64_t pictures_ = 0;
    int filmed_ = 0; // pictures, one after another
    render::Point mouse_;
    bool held_ = false; // the left button
};

} // namespace trembler::ui::test
