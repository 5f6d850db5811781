// What Esc opens: resume, restart, levels, settings, keys, quit.
#pragma once

#include "game/ui/shared/desk.hpp"

#include <cstdint>
#include <optional>

namespace trembler::ui {

enum class MenuPage : std::uint8_t { closed, main, settings, levels, help };

enum class MenuChoice : std::uint8_t { resume, restart, toTitle, quit };

/// Lies over everything; while it is open nothing else is drawn or moves.
class Menu {
public:
    void open(MenuPage page) { page_ = first_ = page; }
    void close() { page_ = MenuPage::closed; }
    [[nodiscard]] bool isOpen() const { return page_ != MenuPage::closed; }
    [[nodiscard]] MenuPage page() const { return page_; }
    /// One page back: from the settings to the menu, from the menu to the game.
    void back();

    /// Between Gui::beginFrame and endFrame. `playing` is the level behind it, empty on the title screen. A
    /// chosen level is put into `level`.
    std::optional<MenuChoice> draw(Desk& desk, std::filesystem::path const& playing,
                                   ShelfEntry const*& level);

private:
    std::optional<MenuChoice> drawMain(Desk& desk);
    void drawSettings(Desk& desk);

    MenuPage page_ = MenuPage::closed;
    MenuPage first_ = MenuPage::closed;
};

/// Makes the window as the settings say.
void applySettings(Desk& desk);

} // namespace trembler::ui
