// Pictures of levels without anybody playing: `trembler screenshot`, and the program without a display.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "render/scene/scene_view.hpp"
#include "render/window/window.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace trembler::ui {

/// How a picture of a session looks.
struct PictureOptions {
    render::Overlays overlays{};
    std::vector<render::Ripple> ripples{}; ///< of what sounds
    bool names = false;
    bool card = true; ///< title and goals
    bool shadows = true;
    /// Called before each step that may take long, with words for it; may be empty.
    std::function<void(std::string const&)> step{};
};

/// Draws the session's world as it is now, and everything of it, into the window and reads it back. Throws
/// render::RenderError.
[[nodiscard]] render::Image pictureOf(render::Window& window, GameData const& gameData,
                                      Session const& session, PictureOptions const& options = {});

struct ScreenshotOptions {
    std::filesystem::path level;
    std::uint64_t frame = 0;      ///< frames done; 0: as the level begins
    render::Size size{1280, 720}; ///< pixels
    std::string solution;         ///< by name or from a file; empty: none is placed
    bool firstSolution = false;   ///< the level's first recorded one, if it has any
    PictureOptions picture{};     ///< the ripples are those of the run
    WorldOptions world{};
    /// Called after each frame with the frames done, for a sign of progress; may be empty.
    std::function<void(std::uint64_t)> progress;
};

/// Throws InputError or std::invalid_argument for bad input, render::RenderError (WindowError among them) if
/// there is no picture.
[[nodiscard]] render::Image screenshot(GameData const& gameData, ScreenshotOptions const& options);

} // namespace trembler::ui
