// Dear ImGui on our window: its context, its frame, and the player's input from SDL's events.
#pragma once

#include "render/panels/theme.hpp"
#include "render/window/input_events.hpp"
#include "render/window/window.hpp"

#include <functional>
#include <memory>

namespace trembler::render {

struct GuiOptions {
    bool steady = false; ///< nothing blinks: for pictures that are compared
};

/// One at a time, on the window's thread, destroyed before the window. ImGui's coordinates are the window's
/// pixels. Nothing is written to disk (no ini file).
class Gui {
public:
    /// Throws RenderError if the backends cannot start on this window.
    explicit Gui(Window& window, GuiOptions const& options = {});
    ~Gui();
    Gui(Gui const&) = delete;
    Gui& operator=(Gui const&) = delete;
    Gui(Gui&&) = delete;
    Gui& operator=(Gui&&) = delete;

    /// Starts a frame with the events that `input` took last; ImGui's functions can be called from here to
    /// endFrame. `seconds` since the last frame: clamped to at least a millisecond and at most a second.
    /// `asWidgets` makes the keys of ImGui's widgets of the player's; without it these are the usual ones.
    void beginFrame(InputEvents const& input, double seconds,
                    std::function<SDL_Event(SDL_Event const&)> const& asWidgets = {});
    /// Draws the panels over the window's contents. `beneath` is called after the drawing beneath all panels,
    /// such as words in the world, and before the panels; it may be empty.
    void endFrame(std::function<void()> const& beneath = {});
    /// Instead of endFrame, if the window is not visible: draws nothing. The panels have still handled the
    /// player's input and are laid out.
    void dropFrame();

    /// The mouse is over a panel, or a text field has the keyboard: the world must not react.
    [[nodiscard]] bool wantsMouse() const;
    [[nodiscard]] bool wantsKeyboard() const;

    [[nodiscard]] Fonts const& fonts() const { return theme_.fonts; }

private:
    void feedMouse(InputEvents const& input);
    void followScale();

    /// Each destructor undoes its constructor, in reverse order, also when a later step throws.
    struct Context {
        Context();
        ~Context();
        Context(Context const&) = delete;
        Context& operator=(Context const&) = delete;
    };
    struct Backends {
        explicit Backends(Window& window);
        ~Backends();
        Backends(Backends const&) = delete;
        Backends& operator=(Backends const&) = delete;
    };

    Window& window_;
    Theme theme_;
    bool lettersLoaded_ = false; // into the graphics card, by the backend's first frame
    Context context_;
    std::unique_ptr<Backends> backends_;
};

} // namespace trembler::render
