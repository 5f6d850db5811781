// The pace of the window's pictures: no more than the display shows, and none that equals the last one.
#pragma once

#include "game/ui/app/app.hpp"

#include <SDL.h>

#include <chrono>
#include <cstdint>
#include <thread>

namespace trembler::ui {

/// Reads the clock, and sleeps. Window thread only; the game and the window must outlive it.
class GameLoop {
public:
    GameLoop(GameApp& app, render::Window& window) : app_(app), window_(window) {}

    /// One picture, which is not drawn if it would equal the last one, or if the window is not visible; then
    /// waits until the next is due. Returns false once the player has left.
    bool turn() {
        drawn_ += seen_ ? 1U : 0U;
        if (!app_.frame(passed_, seen_)) {
            return false;
        }
        // An offscreen window is hidden, but its pictures are wanted.
        seen_ = window_.mode() == render::WindowMode::Offscreen ||
                (SDL_GetWindowFlags(window_.handle()) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) == 0;
        if (app_.resting()) {
            // Until something happens time passes in few, undrawn pictures.
            seen_ = SDL_WaitEventTimeout(nullptr, 250) != 0 && seen_;
        }
        // Vertical sync does not limit the frame rate of a hidden window.
        if (!seen_) {
            std::this_thread::sleep_for(std::chrono::milliseconds(15));
        }
        // Without a graphics card nothing else limits how many pictures are drawn.
        if (double const rest = shortestPicture - secondsSince(before_); seen_ && rest > 0) {
            std::this_thread::sleep_for(std::chrono::duration<double>(rest));
        }
        passed_ = secondsSince(before_);
        before_ = Clock::now();
        return true;
    }
    /// How many pictures have been drawn.
    [[nodiscard]] std::uint64_t drawn() const { return drawn_; }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr double shortestPicture = 1.0 / 250; // s

    static double secondsSince(Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

    GameApp& app_;
    render::Window& window_;
    Clock::time_point before_ = Clock::now();
    double passed_ = 1.0 / 60;
    bool seen_ = true;
    std::uint64_t drawn_ = 0;
};

} // namespace trembler::ui
