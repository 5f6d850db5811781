// What a window costs that is left alone.
#pragma once

#include "bench/window/clocks.hpp"
#include "game/ui/app/game_loop.hpp"
#include "game/ui/play/play_screen.hpp"
#include "puzzle/data/game_data.hpp"

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>

namespace bench {

struct RestCost {
    std::string where;
    double share = 0;        ///< of one processor
    std::uint64_t drawn = 0; ///< pictures
};

/// The action in a level before its window is left alone.
enum class Before : std::uint8_t { nothing, openMenu, setBudget };

/// Whether a window can be on a display. Without one, SDL wakes every millisecond to look for events.
inline bool hasDisplay() {
    return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
}

/// Leaves a window of the game alone for so many seconds: on a display if there is one. `level` may be empty:
/// the title.
inline RestCost measureRest(std::string where, trembler::GameData const& data,
                            trembler::ui::GameOptions const& options, double seconds,
                            std::filesystem::path const& level, Before before) {
    using namespace trembler;
    render::Window window(
        {.size = {1280, 720},
         .mode = hasDisplay() ? render::WindowMode::Visible : render::WindowMode::Offscreen});
    ui::GameApp app(window, data.registry, data.parts, options);
    if (!level.empty()) {
        app.open(level);
    }
    if (before == Before::openMenu) {
        app.openMenu(ui::MenuPage::main);
    } else if (before == Before::setBudget) {
        dynamic_cast<ui::PlayScreen&>(app.screen()).commands().run("budget");
    }
    ui::GameLoop loop(app, window);
    loop.turn();                                       // a new window's first events and picture
    for (int i = 0; i < 1000 && !app.resting(); ++i) { // until initial motions have ended
        app.frame(0.1, false);
    }
    for (double const begin = secondsOf(CLOCK_MONOTONIC); secondsOf(CLOCK_MONOTONIC) - begin < 1;) {
        loop.turn();
    }
    std::uint64_t const drawn = loop.drawn();
    double const begin = secondsOf(CLOCK_MONOTONIC);
    double const used = secondsOf(CLOCK_PROCESS_CPUTIME_ID);
    double passed = 0;
    while (passed < seconds) {
        loop.turn();
        passed = secondsOf(CLOCK_MONOTONIC) - begin;
    }
    return {std::move(where), (secondsOf(CLOCK_PROCESS_CPUTIME_ID) - used) / passed, loop.drawn() - drawn};
}

/// The share of a processor that a thread takes which only wakes every millisecond. SDL's driver without a
/// display does that while it waits for events, so this is the part of a window at rest that is the
/// machine's.
inline double shareOfWaking(double seconds) {
    double const begin = secondsOf(CLOCK_MONOTONIC);
    double const used = secondsOf(CLOCK_PROCESS_CPUTIME_ID);
    double passed = 0;
    while (passed < seconds) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        passed = secondsOf(CLOCK_MONOTONIC) - begin;
    }
    return (secondsOf(CLOCK_PROCESS_CPUTIME_ID) - used) / passed;
}

} // namespace bench
