// Pictures of levels without a player: `trembler screenshot`, and the program without a display.
#pragma once

#include "puzzle/session/session.hpp"
#include "render/scene/scene_view.hpp"
#include "render/window/window.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace trembler::ui {

/// The content of a picture of a session.
struct PictureOptions {
    render::Overlays overlays{};
    std::vector<render::Ripple> ripples{}; ///< around sounding objects
    bool names = false;
    bool card = true; ///< shows the title and the goals
    bool shadows = true;
    /// Progress callback, called before each step that may take long with a description of it; may be empty.
    std::function<void(std::string const&)> step{};
};

/// Draws the session's world in its current state, showing all of it, into the window and reads the image
/// back. Throws render::RenderError.
[[nodiscard]] render::Image pictureOf(render::Window& window, Session const& session,
                                      PictureOptions const& options = {});

struct ScreenshotOptions {
    std::uint64_t frame = 0;      ///< frames to simulate; 0: the initial state
    render::Size size{1280, 720}; ///< pixels
    PictureOptions picture{};     ///< its ripples are replaced by those of the run
    /// Progress callback, called after each frame with the number of frames done; may be empty.
    std::function<void(std::uint64_t)> progress;
};

/// Runs the session for the frames, and draws it. Throws render::RenderError (including WindowError) if the
/// picture cannot be drawn.
[[nodiscard]] render::Image screenshot(Session& session, ScreenshotOptions const& options);

} // namespace trembler::ui
