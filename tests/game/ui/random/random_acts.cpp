// The actions of a random player: one function for each kind of event.
#include "tests/game/ui/random/random_player.hpp"
#include "tests/support/synthetic_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace trembler::ui::test {
namespace {

using render::MouseButton;
using render::Point;

constexpr std::array<SDL_Keycode, 22> commonKeys{
    SDLK_RETURN, SDLK_ESCAPE, SDLK_TAB,    SDLK_SPACE, SDLK_BACKSPACE, SDLK_DELETE,   SDLK_LEFT, SDLK_RIGHT,
    SDLK_UP,     SDLK_DOWN,   SDLK_HOME,   SDLK_END,   SDLK_PAGEUP,    SDLK_PAGEDOWN, SDLK_F1,   SDLK_F11,
    SDLK_PLUS,   SDLK_MINUS,  SDLK_PERIOD, SDLK_COMMA, SDLK_INSERT,    SDLK_KP_ENTER};
constexpr std::array<unsigned, 8> modifierSets{KMOD_NONE,  KMOD_NONE,   KMOD_NONE, KMOD_NONE,
                                               KMOD_LCTRL, KMOD_LSHIFT, KMOD_LALT, KMOD_LCTRL | KMOD_LSHIFT};
// Without a slash, which would lead out of the player's folder.
constexpr std::array<std::string_view, 16> texts{
    "1",       "0",     "-2.5",  "1e9",
    "-",       "0.001", "ball",  "nan",
    "Ünïcøde", "日本",  "\"{}",  "lamp 2",
    " ",       "..",    "1e400", "a very long text that does not fit into any field at all, and more"};

} // namespace

std::string RandomPlayer::clickItem() {
    auto const& items = app_->context().layout.items();
    if (items.empty()) {
        return clickAnywhere();
    }
    Placed const item = items[below(items.size())];
    mouse_ = item.rect.middle();
    auto const button = oneIn(10) ? MouseButton::Right : MouseButton::Left;
    render::pushMouseMove(window_, mouse_);
    frame();
    for (int clicks = oneIn(8) ? 2 : 1; clicks > 0; --clicks) {
        render::pushMouseButton(window_, button, true, mouse_);
        frame();
        render::pushMouseButton(window_, button, false, mouse_);
        frame();
    }
    held_ = false;
    return "click " + item.name;
}

std::string RandomPlayer::clickAnywhere() {
    mouse_ = anyPoint();
    auto const button = static_cast<MouseButton>(below(3));
    int const clicks = oneIn(4) ? 2 : 1;
    render::pushMouseMove(window_, mouse_);
    frame();
    render::pushMouseButton(window_, button, true, mouse_, clicks);
    if (oneIn(2)) {
        frame();
    }
    render::pushMouseButton(window_, button, false, mouse_, clicks);
    frame();
    return fmt::format("click {:.0f} {:.0f}", mouse_.x, mouse_.y);
}

std::string RandomPlayer::moveAnywhere() {
    mouse_ = anyPoint();
    render::pushMouseMove(window_, mouse_);
    frame();
    return fmt::format("move to {:.0f} {:.0f}", mouse_.x, mouse_.y);
}

std::string RandomPlayer::pressOrRelease() {
    held_ = !held_;
    render::pushMouseButton(window_, MouseButton::Left, held_, mouse_);
    frame();
    return held_ ? "press" : "release";
}

std::string RandomPlayer::drag() {
    Point const from = anyPoint();
    Point const to = anyPoint();
    auto const button = oneIn(5) ? MouseButton::Middle : MouseButton::Left;
    render::pushMouseMove(window_, from);
    frame();
    render::pushMouseButton(window_, button, true, from);
    frame();
    for (int i = 1; i <= 3; ++i) {
        mouse_ = from + (i / 3.0) * (to - from);
        render::pushMouseMove(window_, mouse_);
        frame();
    }
    if (oneIn(6)) {
        pressKey(SDLK_ESCAPE, KMOD_NONE);
    }
    render::pushMouseButton(window_, button, false, mouse_);
    frame();
    held_ = false;
    return fmt::format("drag {:.0f} {:.0f} to {:.0f} {:.0f}", from.x, from.y, to.x, to.y);
}

std::string RandomPlayer::wheel() {
    auto const notches = static_cast<int>(below(9)) - 4;
    render::pushWheel(window_, notches);
    frame();
    return fmt::format("wheel {}", notches);
}

void RandomPlayer::pressKey(SDL_Keycode key, unsigned modifiers) {
    if (render::isPadKey(key)) {
        for (bool const down : {true, false}) {
            SDL_Event event{};
            event.type = down ? SDL_CONTROLLERBUTTONDOWN : SDL_CONTROLLERBUTTONUP;
            event.cbutton.button = static_cast<std::uint8_t>(key - render::firstPadKey);
            event.cbutton.state = down ? SDL_PRESSED : SDL_RELEASED;
            SDL_PushEvent(&event);
            frame();
        }
        return;
    }
    render::pushKey(window_, key, true, modifiers);
    frame();
    render::pushKey(window_, key, false, KMOD_NONE);
    frame();
}

std::string RandomPlayer::command() {
    CommandSet& commands = app_->screen().commands();
    if (commands.size() == 0) {
        return key();
    }
    CommandInfo const& info = commands.info(below(commands.size()));
    auto const keys = app_->context().keys.keysOf(info.id);
    if (keys.empty()) {
        return key();
    }
    Chord const chord = keys[below(keys.size())];
    unsigned const modifiers = (chord.ctrl ? unsigned{KMOD_LCTRL} : 0U) |
                               (chord.shift ? unsigned{KMOD_LSHIFT} : 0U) |
                               (chord.alt ? unsigned{KMOD_LALT} : 0U);
    std::string what = "command " + std::string(info.id);
    pressKey(chord.key, modifiers);
    return what;
}

std::string RandomPlayer::key() {
    SDL_Keycode const key =
        oneIn(2) ? commonKeys[below(commonKeys.size())] : static_cast<SDL_Keycode>(' ' + below('z' - ' '));
    unsigned const modifiers = modifierSets[below(modifierSets.size())];
    if (oneIn(12)) { // held, or let go, for a while
        bool const down = oneIn(2);
        render::pushKey(window_, key, down, modifiers);
        frame();
        return fmt::format("key {} {}", SDL_GetKeyName(key), down ? "down" : "up");
    }
    pressKey(key, modifiers);
    return fmt::format("key {} with {:x}", SDL_GetKeyName(key), modifiers);
}

std::string RandomPlayer::type() {
    std::string_view const text = texts[below(texts.size())];
    render::pushText(window_, text);
    frame();
    if (oneIn(2)) {
        pressKey(oneIn(2) ? SDLK_RETURN : SDLK_TAB, KMOD_NONE);
    }
    return "type " + std::string(text);
}

std::string RandomPlayer::pad() {
    if (oneIn(3)) {
        SDL_Event event{};
        event.type = SDL_CONTROLLERAXISMOTION;
        event.caxis.axis = static_cast<std::uint8_t>(below(SDL_CONTROLLER_AXIS_MAX));
        event.caxis.value = static_cast<std::int16_t>(static_cast<int>(below(65536)) - 32768);
        SDL_PushEvent(&event);
        frame();
        return fmt::format("pad axis {} {}", event.caxis.axis, event.caxis.value);
    }
    auto const button = static_cast<SDL_GameControllerButton>(below(SDL_CONTROLLER_BUTTON_MAX));
    pressKey(render::padKey(button), KMOD_NONE);
    return fmt::format("pad button {}", static_cast<int>(button));
}

std::string RandomPlayer::wait() {
    constexpr std::array<double, 6> lengths{1.0 / 60, 1.0 / 60, 1.0 / 60, 0.1, 0, 3};
    double const length = lengths[below(lengths.size())];
    std::size_t const count = 1 + below(40);
    for (std::size_t i = 0; i < count; ++i) {
        frame(length);
    }
    return fmt::format("wait {} x {:.3f} s", count, length);
}

/// A level, or anything else that the program has written: a solution, a build, settings, a picture.
std::string RandomPlayer::dropFile() {
    std::vector<std::filesystem::path> files{anyLevel(), folder_ / "no such file.json"};
    std::error_code none; // nothing has been written yet
    std::filesystem::recursive_directory_iterator at(folder_ / "trembler", none);
    for (std::filesystem::recursive_directory_iterator const end; at != end; at.increment(none)) {
        if (at->is_regular_file(none)) {
            files.push_back(at->path());
        }
    }
    std::sort(files.begin(), files.end());
    std::filesystem::path const file = files[below(files.size())];
    render::pushDrop(window_, file);
    frame();
    return "drop " + file.filename().string();
}

std::string RandomPlayer::resize() {
    render::Size const size = anySize();
    window_.resize(size);
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.windowID = SDL_GetWindowID(window_.handle());
    event.window.event = SDL_WINDOWEVENT_SIZE_CHANGED;
    event.window.data1 = size.width;
    event.window.data2 = size.height;
    SDL_PushEvent(&event);
    frame();
    return fmt::format("size {}x{}", size.width, size.height);
}

std::string RandomPlayer::windowEvent() {
    constexpr std::array<SDL_WindowEventID, 6> kinds{SDL_WINDOWEVENT_FOCUS_LOST, SDL_WINDOWEVENT_FOCUS_GAINED,
                                                     SDL_WINDOWEVENT_LEAVE,      SDL_WINDOWEVENT_ENTER,
                                                     SDL_WINDOWEVENT_MINIMIZED,  SDL_WINDOWEVENT_RESTORED};
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.windowID = SDL_GetWindowID(window_.handle());
    event.window.event = static_cast<std::uint8_t>(kinds[below(kinds.size())]);
    SDL_PushEvent(&event);
    frame();
    return fmt::format("window event {}", event.window.event);
}

std::string RandomPlayer::close() {
    render::pushQuit();
    frame();
    return "close the window";
}

} // namespace trembler::ui::test
