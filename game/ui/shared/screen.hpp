// A screen of the program, whichever: the title, a level. The program holds one and knows none by its type.
#pragma once

#include "game/ui/commands/key_help.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <variant>

namespace trembler::ui {

/// Pages of what Esc opens.
enum class MenuPage : std::uint8_t { closed, main, settings, keys, levels, help };

/// What a screen, or the menu over it, cannot do by itself.
namespace request {

struct OpenMenu {
    MenuPage page = MenuPage::main;
};
/// If it cannot be read or built the player is told, and the screen stays.
struct OpenLevel {
    std::filesystem::path level;
};
struct ShowTitle {};
struct SwitchFullscreen {};
struct Quit {};

} // namespace request

using ScreenRequest = std::variant<request::OpenMenu, request::OpenLevel, request::ShowTitle,
                                   request::SwitchFullscreen, request::Quit>;

/// Window thread only. In each picture: update or updateBehindMenu; then, unless nobody sees it, draw and
/// pictureComplete. So draw() changes nothing that anything but drawing reads.
class Screen {
public:
    Screen() = default;
    virtual ~Screen() = default;
    Screen(Screen const&) = delete;
    Screen& operator=(Screen const&) = delete;

    /// One picture's worth of the player's doing, and `seconds` of time: between Gui::beginFrame and draw().
    virtual std::optional<ScreenRequest> update(double seconds) = 0;
    /// Instead of update(), as long as a menu lies over it.
    virtual void updateBehindMenu(double seconds) = 0;
    /// Whether it keeps the picture that was just updated, for a film or a file: then it is drawn even if
    /// nobody sees the window.
    [[nodiscard]] virtual bool keepsPicture() const { return false; }
    /// Into the window: after Window::beginFrame, before Gui::endFrame.
    virtual void draw() = 0;
    /// All is drawn: between Gui::endFrame and Window::present.
    virtual void pictureComplete() {}
    /// Another screen takes its place, or the program ends; nothing else is called after it.
    virtual void leave() {}

    /// What it can be asked for.
    [[nodiscard]] virtual CommandSet& commands() = 0;
    /// What hands can do besides, for the page of keys.
    [[nodiscard]] virtual std::span<Gesture const> gestures() const { return {}; }
    /// The level that it shows; empty if it shows none.
    [[nodiscard]] virtual std::filesystem::path const& level() const = 0;
};

} // namespace trembler::ui
