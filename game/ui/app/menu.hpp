// What Esc opens: resume, restart, levels, settings, keys, quit.
#pragma once

#include "game/ui/shared/ui_context.hpp"

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
    std::optional<MenuChoice> draw(UiContext& context, std::filesystem::path const& playing,
                                   CatalogEntry const*& level);

private:
    std::optional<MenuChoice> drawMain(UiContext& context);
    void drawSettings(UiContext& context);

    MenuPage page_ = MenuPage::closed;
    MenuPage first_ = MenuPage::closed;
};

/// Makes the window as the settings say.
void applySettings(UiContext& context);

} // namespace trembler::ui
