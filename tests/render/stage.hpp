// Shared by the drawing tests: one offscreen window for the whole program, and folders for the pictures.
#pragma once

#include "render/draw/canvas.hpp"
#include "render/window/window.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>

namespace trembler::render::test {

/// Opened on first use and kept: a context costs a tenth of a second and SDL works best with one window at a
/// time.
inline Window& window() {
    static Window theWindow({.size = {640, 480}, .mode = WindowMode::Offscreen});
    return theWindow;
}

inline Canvas& canvas() {
    static Canvas theCanvas = [] {
        window();
        return Canvas();
    }();
    return theCanvas;
}

/// A picture of the shapes that `draw` draws on the background `back`, at 100 pixels per metre with the
/// origin in the middle unless a camera is given.
inline Image picture(Size size, Colour back, std::function<void(Canvas&)> const& draw,
                     CanvasOptions const& options = {}, Camera camera = {}) {
    window().resize(size);
    camera.viewport = size;
    auto& sheet = canvas();
    window().beginFrame(back);
    sheet.begin(camera, options);
    draw(sheet);
    sheet.end();
    return window().readPixels();
}

/// A folder of this program's own, created if needed.
inline std::filesystem::path pictureFolder() {
    auto folder = std::filesystem::path(TREMBLER_BINARY_DIR) / "render-pictures";
    std::filesystem::create_directories(folder);
    return folder;
}

/// Writes a picture for people below pictureFolder(), if TREMBLER_PICTURES is in the environment: packing a
/// picture takes longer than drawing it.
inline void keepForPeople(Image const& image, std::string const& name) {
    if (std::getenv("TREMBLER_PICTURES") != nullptr) {
        writePng(image, pictureFolder() / (name + ".png"));
    }
}

} // namespace trembler::render::test
