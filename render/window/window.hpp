// The program's one window, or a picture in memory that takes its place: SDL2 with OpenGL 3.3 core.
#pragma once

#include "render/draw/colour.hpp"
#include "render/gl/framebuffer.hpp"
#include "render/gl/image.hpp"
#include "render/window/maximising.hpp"

#include <memory>
#include <optional>
#include <string>

struct SDL_Window;

namespace trembler::render {

enum class WindowMode {
    Visible,   ///< on the player's screen
    Offscreen, ///< no display needed: tests, screenshots, the program without a desktop
};

struct WindowOptions {
    std::string title = "Trembler";
    Size size{1280, 720}; ///< points when visible, pixels offscreen
    WindowMode mode = WindowMode::Visible;
    bool waitForScreen = true;  ///< present() waits for the screen's next refresh; ignored offscreen
    float uiScaleRequest = 1.F; ///< the player's own factor, see uiScaleFor
};

/// The reason why there is no window. what() is meant for the player.
class WindowError : public RenderError {
public:
    enum class Kind {
        NoDisplay, ///< SDL found no screen; without this check the pictures would never be seen
        NoOpenGl,  ///< no driver, or one that cannot do OpenGL 3.3
        Other,
    };
    WindowError(Kind kind, std::string const& message) : RenderError(message), kind_(kind) {}
    [[nodiscard]] Kind kind() const { return kind_; }

private:
    Kind kind_;
};

/// Owns SDL's video part, the window and the OpenGL context. Make one at a time, use it on the thread that
/// made it (the main thread, for SDL's sake), and let it outlive everything else in render/.
///
/// Offscreen, everything is drawn into a Framebuffer, so that pictures are the same with and without a
/// display and any size works.
class Window {
public:
    /// Throws WindowError; nothing of SDL is left behind then.
    explicit Window(WindowOptions const& options);
    ~Window();
    Window(Window const&) = delete;
    Window& operator=(Window const&) = delete;
    Window(Window&&) = delete;
    Window& operator=(Window&&) = delete;

    /// The size of the drawing area, in pixels.
    [[nodiscard]] Size size() const;
    /// Pixels per window point: SDL's mouse positions times this are pixels. More than 1 on some HiDPI
    /// desktops.
    [[nodiscard]] float pixelsPerPoint() const;
    /// The factor on every length of the interface, see uiScaleFor. Follows the window's size.
    [[nodiscard]] float uiScale() const;
    /// The player's own factor on uiScale (0.5 to 3).
    void setUiScaleRequest(float request) { uiScaleRequest_ = request; }

    /// Changes the size (points when visible, pixels offscreen). Throws RenderError if offscreen cannot be
    /// that large.
    void resize(Size size);
    /// Whole screen at the desktop's own resolution, or back, maximised if it was. Nothing happens offscreen.
    void setFullscreen(bool on);

    /// Directs drawing into this window and clears it. Call it first in every frame, and again after drawing
    /// into a Framebuffer that was bound with `bind` alone.
    void beginFrame(Colour clear);
    void bind();
    /// Shows the drawing. Offscreen it only finishes it.
    void present();
    /// The drawing since beginFrame. Call it before present.
    [[nodiscard]] Image readPixels();

    [[nodiscard]] WindowMode mode() const { return mode_; }
    /// OpenGL runs on the processor: leave soft shadows out by default (they double the cost of a frame).
    [[nodiscard]] bool software() const { return software_; }

    /// For the ImGui backend and for synthetic events.
    [[nodiscard]] SDL_Window* handle() const { return window_.get(); }
    [[nodiscard]] void* context() const { return context_.get(); }

private:
    /// SDL's video part, counted by SDL itself.
    struct Video {
        Video() = default;
        Video(Video const&) = delete;
        Video& operator=(Video const&) = delete;
        ~Video();
        bool started = false;
    };

    void startVideo(WindowMode mode);
    void openWindow(WindowOptions const& options);
    void openContext();
    void makeCurrent();
    [[nodiscard]] WindowState state() const;
    void followMaximising();

    WindowMode mode_;
    float uiScaleRequest_;
    bool software_ = false;
    Maximising maximising_;
    Video video_;
    std::unique_ptr<SDL_Window, void (*)(SDL_Window*)> window_;
    std::unique_ptr<void, void (*)(void*)> context_;
    std::optional<Framebuffer> offscreen_;
};

} // namespace trembler::render
