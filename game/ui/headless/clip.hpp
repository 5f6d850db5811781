// Moving pictures of runs without a player: `trembler clip`.
#pragma once

#include "puzzle/session/session.hpp"
#include "render/scene/scene_view.hpp"
#include "render/window/window.hpp"
#include "runtime/file/output_file.hpp"

#include <cstdint>
#include <functional>

namespace trembler::ui {

struct ClipOptions {
    render::Size size{960, 540}; ///< pixels
    double from = 0;             ///< s of the world before the first picture
    double seconds = 8;          ///< s of the world that are shown, at its real speed
    int rate = 30;               ///< pictures per second, 1 to 60
    render::Overlays overlays{};
    /// Called after each frame of the world and each picture with the numbers of steps done and in all; may
    /// be empty.
    std::function<void(std::uint64_t, std::uint64_t)> progress;
};

/// Runs the session and writes an animated WebP without any interface; the whole scene is in view as it is at
/// `from`. The caller commits the file. Throws render::RenderError if it cannot be drawn or compressed,
/// OutputError as soon as writing fails.
void writeClip(Session& session, ClipOptions const& options, OutputFile& file);

} // namespace trembler::ui
