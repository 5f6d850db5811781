// The menu that Esc opens: resume, restart, levels, settings, keys, quit.
#pragma once

#include "game/ui/app/menu/chapters_page.hpp"
#include "game/ui/app/menu/keys_page.hpp"
#include "game/ui/app/menu/settings_page.hpp"
#include "game/ui/app/menu/solutions_page.hpp"
#include "game/ui/shared/commands/commands_page.hpp"
#include "game/ui/shared/screen.hpp"
#include "game/ui/shared/ui_context.hpp"

#include <optional>
#include <vector>

namespace trembler::ui {

/// Covers the screen; while it is open no other card is drawn and the world stands still. Can be used with
/// the mouse alone and with the keyboard alone.
class Menu {
public:
    void open(MenuPage page) {
        pages_ = {page};
        drawn_ = MenuPage::closed;
    }
    void close() {
        pages_.clear();
        drawn_ = MenuPage::closed;
    }
    [[nodiscard]] bool isOpen() const { return !pages_.empty(); }
    [[nodiscard]] MenuPage page() const { return pages_.empty() ? MenuPage::closed : pages_.back(); }
    [[nodiscard]] KeysPage const& keysPage() const { return keys_; }
    [[nodiscard]] SolutionsPage const& solutionsPage() const { return solutions_; }
    /// Goes one page back: from the settings to the menu, from the menu to the game.
    void back();

    /// Call between Gui::beginFrame and endFrame. `behind` is the covered screen. Returns the player's
    /// request, if any, and closes the menu, except for a request to open a level, which may fail.
    std::optional<ScreenRequest> draw(UiContext& context, Screen& behind);

private:
    std::optional<ScreenRequest> drawPage(UiContext& context, Screen& behind);
    std::optional<ScreenRequest> drawMain(UiContext& context, Screen& behind);
    std::optional<ScreenRequest> drawLevels(UiContext& context, Screen& behind);
    std::optional<ScreenRequest> drawEnding(UiContext& context);
    void drawSolutions(UiContext& context, Screen& behind);
    void drawCommands(UiContext& context, Screen& behind);

    std::vector<MenuPage> pages_;       // the opened pages, the current one last; empty: closed
    MenuPage drawn_ = MenuPage::closed; // in the last picture
    KeysPage keys_;
    SettingsPage settings_;
    ChaptersPage chapters_;
    SolutionsPage solutions_;
    CommandsPage commands_;
};

} // namespace trembler::ui
