// A random session of a player at a level, and what may move the picture of the scene in it.
#pragma once

#include "tests/game/ui/player.hpp"

#include <cstdint>
#include <random>
#include <string>

namespace trembler::ui::test {

/// The window's size changes, as the desktop does it; the event reports it.
void resizeWindow(Player& player, render::Size size);

/// The widest free rectangle between the cards that always stand around a level, of those that are at least
/// `leastHeight` high, in pixels: found from the edges of the cards alone.
[[nodiscard]] Rect widestFree(Layout const& layout, render::Size window, double leastHeight);

/// Plays with pushed events only. Every act is one of a player's; the same seed, level and size give the same
/// acts.
class StageSession {
public:
    /// A level must be on the player's screen.
    StageSession(Player& player, std::uint64_t seed);

    /// One act. Fails the running test if the scene's place on the screen has changed although the player has
    /// neither moved the view nor the window's edge, or if none of the scene is left on the stage.
    void act();
    /// Whether the level is still on the screen.
    [[nodiscard]] bool goesOn();
    /// The acts so far, for the message of a failure.
    [[nodiscard]] std::string const& story() const { return story_; }

private:
    [[nodiscard]] std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
    [[nodiscard]] Point anywhere();
    [[nodiscard]] Vec2 somewhere();

    // Acts that may not move the scene.
    std::string place();
    std::string movePlaced();
    std::string grab();
    std::string click();
    std::string press();
    std::string command();
    std::string wait();
    // Acts that move it.
    std::string moveView();
    std::string resize();

    void closeMenus();
    void expectOnStage();

    Player& player_;
    std::mt19937_64 random_;
    render::Extent scene_; ///< at the start, with the areas of goals and for placing
    std::string story_;
};

} // namespace trembler::ui::test
