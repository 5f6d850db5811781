// Interface of a screen of the program, such as the title or a level. The program holds one and does not
// depend on its type.
#pragma once

#include "game/ui/shared/commands/key_help.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <variant>

namespace trembler::ui {

class LoadableSolutions;

/// Pages of the menu that Esc opens.
enum class MenuPage : std::uint8_t {
    closed,
    main,
    settings,
    keys,
    levels,
    gallery,
    help,
    ending,
    solutions,
    commands
};

/// Requests of a screen, or of the menu over it, to the program.
namespace request {

struct OpenMenu {
    MenuPage page = MenuPage::main;
};
/// If it cannot be read or built, the player gets a message and the screen stays.
struct OpenLevel {
    std::filesystem::path level;
};
/// Opens the editor; an empty path: with a new level.
struct OpenEditor {
    std::filesystem::path level;
};
struct ShowTitle {};
/// Opens the level with every part.
struct OpenFreePlay {};
struct SwitchFullscreen {};
struct Quit {};

} // namespace request

using ScreenRequest =
    std::variant<request::OpenMenu, request::OpenLevel, request::OpenFreePlay, request::OpenEditor,
                 request::ShowTitle, request::SwitchFullscreen, request::Quit>;

/// Window thread only. In each picture: update or updateBehindMenu; then, if the picture is shown, draw and
/// pictureComplete. draw() may change only state that drawing alone uses.
class Screen {
public:
    Screen() = default;
    virtual ~Screen() = default;
    Screen(Screen const&) = delete;
    Screen& operator=(Screen const&) = delete;

    /// Handles one picture's input and advances by `seconds`: between Gui::beginFrame and draw().
    virtual std::optional<ScreenRequest> update(double seconds) = 0;
    /// Called instead of update() while the menu is open.
    virtual void updateBehindMenu(double seconds) = 0;
    /// Whether the screen keeps the picture that was just updated, for a film or a file: then it is drawn
    /// even if the window is not visible.
    [[nodiscard]] virtual bool keepsPicture() const { return false; }
    /// Whether the next picture would be the same as long as the player does nothing: then it need not be
    /// drawn.
    [[nodiscard]] virtual bool still() const { return false; }
    /// Hands on everything that the player has made since it last did.
    virtual void keep() {}
    /// The solutions of its level; nullptr if it shows none.
    [[nodiscard]] virtual LoadableSolutions* loadableSolutions() { return nullptr; }
    /// Whether a second player can do something here, with a gamepad of their own.
    [[nodiscard]] virtual bool hasSecondHand() const { return false; }
    /// Draws into the window: after Window::beginFrame, before Gui::endFrame.
    virtual void draw() = 0;
    /// Called when the picture is complete, before Window::present. If the screen keeps the picture, no card
    /// has been drawn over the world yet.
    virtual void pictureComplete() {}
    /// Asked before a request is followed that would end this screen, by whomever it was made. False: the
    /// screen asks the player first, and later makes the request itself.
    [[nodiscard]] virtual bool mayLeaveFor(ScreenRequest const&) { return true; }
    /// Called once when another screen replaces it or the program ends; no other call follows.
    virtual void leave() {}

    /// The screen's commands.
    [[nodiscard]] virtual CommandSet& commands() = 0;
    /// Mouse actions and modifiers besides the commands, for the page of keys.
    [[nodiscard]] virtual std::span<Gesture const> gestures() const { return {}; }
    /// The level that it shows; empty if it shows none.
    [[nodiscard]] virtual std::filesystem::path const& level() const = 0;

    /// Lets the next update() run one of commands(), which was chosen while the menu covered the screen.
    void runNext(std::size_t command) { next_ = command; }

protected:
    /// For update().
    [[nodiscard]] std::optional<std::size_t> takeNext() { return std::exchange(next_, std::nullopt); }

private:
    std::optional<std::size_t> next_;
};

} // namespace trembler::ui
