#include "render/window/window.hpp"

#include "render/window/ui_scale.hpp"

#include <SDL.h>
#include <epoxy/gl.h>

#include <array>
#include <string_view>
#include <utility>

namespace trembler::render {

namespace {

/// The size of the SDL window behind an offscreen picture; it is never shown.
constexpr int hiddenWindowSize = 64;

double secondsNow() {
    return 0.001 * static_cast<double>(SDL_GetTicks64());
}

/// epoxy aborts the program when it finds no OpenGL library, so we check for one before.
bool openGlLibraryIsThere() {
    for (auto const* name : std::array{"libGL.so.1", "libOpenGL.so.0"}) {
        if (void* library = SDL_LoadObject(name)) {
            SDL_UnloadObject(library);
            return true;
        }
    }
    return false;
}

bool showsNothing(std::string_view driver) {
    return driver == "offscreen" || driver == "dummy" || driver == "evdev";
}

std::string glString(GLenum name) {
    auto const* text = reinterpret_cast<char const*>(glGetString(name));
    return text != nullptr ? text : "unknown";
}

} // namespace

Window::Video::~Video() {
    if (started) {
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }
}

Window::Window(WindowOptions const& options)
    : mode_(options.mode), uiScaleRequest_(options.uiScaleRequest), window_(nullptr, SDL_DestroyWindow),
      context_(nullptr, SDL_GL_DeleteContext) {
    startVideo(options.mode);
    openWindow(options);
    openContext();
    if (mode_ == WindowMode::Offscreen) {
        offscreen_.emplace(options.size);
    } else {
        // Adaptive first: a late frame is then shown at once instead of a whole refresh later.
        if (!options.waitForScreen || SDL_GL_SetSwapInterval(-1) != 0) {
            SDL_GL_SetSwapInterval(options.waitForScreen ? 1 : 0);
        }
    }
}

Window::~Window() {
    makeCurrent(); // its framebuffer belongs to its own context
}

void Window::makeCurrent() {
    if (SDL_GL_GetCurrentContext() != context_.get()) {
        SDL_GL_MakeCurrent(window_.get(), context_.get());
    }
}

void Window::startVideo(WindowMode mode) {
    // The program handles signals itself; SDL must not turn Ctrl-C into an event that is never read.
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (mode == WindowMode::Offscreen) {
        SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, "offscreen", SDL_HINT_OVERRIDE);
    }
    video_.started = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
    if (mode == WindowMode::Offscreen) {
        SDL_ResetHint(SDL_HINT_VIDEODRIVER);
        if (!video_.started) {
            // An SDL without that driver: a hidden window on the desktop does as well, as we draw into a
            // picture.
            video_.started = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
        }
    }
    if (!video_.started) {
        throw WindowError(mode == WindowMode::Visible ? WindowError::Kind::NoDisplay
                                                      : WindowError::Kind::NoOpenGl,
                          std::string("The window could not be opened: SDL found no video driver (") +
                              SDL_GetError() + ").");
    }
    char const* const current = SDL_GetCurrentVideoDriver();
    std::string const driver = current != nullptr ? current : "";
    if (mode == WindowMode::Visible && showsNothing(driver)) {
        throw WindowError(WindowError::Kind::NoDisplay,
                          "There is no display to open a window on (SDL could only offer its driver '" +
                              driver +
                              "', which shows nothing). Start the game from a desktop, or set DISPLAY or "
                              "WAYLAND_DISPLAY.");
    }
}

void Window::openWindow(WindowOptions const& options) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
    bool const visible = mode_ == WindowMode::Visible;
    Uint32 const flags = SDL_WINDOW_OPENGL | (visible ? SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI
                                                      : static_cast<Uint32>(SDL_WINDOW_HIDDEN));
    window_.reset(SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                   visible ? options.size.width : hiddenWindowSize,
                                   visible ? options.size.height : hiddenWindowSize, flags));
    if (!window_) {
        throw WindowError(
            WindowError::Kind::NoOpenGl,
            std::string("A window with OpenGL could not be opened (") + SDL_GetError() +
                "). Trembler needs OpenGL 3.3: are the packages libgl1, libegl1 and libgl1-mesa-dri "
                "installed?");
    }
    if (visible) {
        SDL_SetWindowMinimumSize(window_.get(), 800, 450);
    }
}

void Window::openContext() {
    context_.reset(SDL_GL_CreateContext(window_.get()));
    if (!context_) {
        throw WindowError(
            WindowError::Kind::NoOpenGl,
            std::string("The graphics driver does not offer OpenGL 3.3 (") + SDL_GetError() +
                "). Trembler runs on any driver that does, Mesa's software one included: package "
                "libgl1-mesa-dri.");
    }
    if (!openGlLibraryIsThere()) {
        throw WindowError(WindowError::Kind::NoOpenGl,
                          "The OpenGL library (libGL.so.1) is missing: install the package libgl1.");
    }
    if (epoxy_gl_version() < 33) {
        throw WindowError(WindowError::Kind::NoOpenGl, "The graphics driver offers OpenGL " +
                                                           glString(GL_VERSION) +
                                                           ", but Trembler needs 3.3 or newer.");
    }
    std::string const renderer = glString(GL_RENDERER);
    for (auto const* name : std::array{"llvmpipe", "softpipe", "swrast", "Software"}) {
        software_ = software_ || renderer.find(name) != std::string::npos;
    }
}

Size Window::size() const {
    if (offscreen_) {
        return offscreen_->size();
    }
    Size size;
    SDL_GL_GetDrawableSize(window_.get(), &size.width, &size.height);
    return size;
}

float Window::pixelsPerPoint() const {
    if (offscreen_) {
        return 1.F;
    }
    Size points;
    SDL_GetWindowSize(window_.get(), &points.width, &points.height);
    return points.width > 0 ? static_cast<float>(size().width) / static_cast<float>(points.width) : 1.F;
}

float Window::uiScale() const {
    return uiScaleFor(size(), uiScaleRequest_);
}

void Window::resize(Size size) {
    makeCurrent();
    if (offscreen_) {
        Framebuffer larger(size); // may throw, and then the old one stays
        offscreen_ = std::move(larger);
    } else {
        SDL_SetWindowSize(window_.get(), size.width, size.height);
    }
}

void Window::setFullscreen(bool on) {
    if (offscreen_) {
        return;
    }
    maximising_.switches(on, state(), secondsNow());
    SDL_SetWindowFullscreen(window_.get(), on ? Uint32{SDL_WINDOW_FULLSCREEN_DESKTOP} : Uint32{0});
    followMaximising();
}

WindowState Window::state() const {
    Uint32 const flags = SDL_GetWindowFlags(window_.get());
    return {(flags & SDL_WINDOW_FULLSCREEN_DESKTOP) == SDL_WINDOW_FULLSCREEN_DESKTOP,
            (flags & SDL_WINDOW_MAXIMIZED) != 0};
}

void Window::followMaximising() {
    if (maximising_.due(state(), secondsNow())) {
        SDL_MaximizeWindow(window_.get());
    }
}

void Window::bind() {
    makeCurrent();
    if (offscreen_) {
        offscreen_->bind();
        return;
    }
    auto const [width, height] = size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
}

void Window::beginFrame(Colour clear) {
    bind();
    clearBound(clear);
}

void Window::present() {
    if (offscreen_) {
        glFinish();
    } else {
        SDL_GL_SwapWindow(window_.get());
        followMaximising();
    }
}

Image Window::readPixels() {
    bind();
    return readBoundPixels(size());
}

} // namespace trembler::render
