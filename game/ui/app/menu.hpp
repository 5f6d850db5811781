// What Esc opens: resume, restart, levels, settings, keys, quit.
#pragma once

#include "game/ui/app/keys_page.hpp"
#include "game/ui/shared/screen.hpp"
#include "game/ui/shared/ui_context.hpp"

#include <optional>
#include <vector>

namespace trembler::ui {

/// Lies over everything; while it is open nothing else is drawn or moves. Works with the mouse alone, and
/// with the keyboard alone.
class Menu {
public:
    void open(MenuPage page) { pages_ = {page}; }
    void close() { pages_.clear(); }
    [[nodiscard]] bool isOpen() const { return !pages_.empty(); }
    [[nodiscard]] MenuPage page() const { return pages_.empty() ? MenuPage::closed : pages_.back(); }
    [[nodiscard]] KeysPage const& keysPage() const { return keys_; }
    /// One page back: from the settings to the menu, from the menu to the game.
    void back();

    /// Between Gui::beginFrame and endFrame. `behind` is the screen that it lies over. Whatever it asks for,
    /// it is closed, but for a level: that may turn out not to be playable.
    std::optional<ScreenRequest> draw(UiContext& context, Screen& behind);

private:
    std::optional<ScreenRequest> drawMain(UiContext& context, Screen& behind);
    void drawSettings(UiContext& context);
    std::optional<ScreenRequest> drawLevels(UiContext& context, Screen& behind);

    std::vector<MenuPage> pages_; // the way here; empty: closed
    KeysPage keys_;
};

/// Makes the window as the settings say.
void applySettings(UiContext& context);

} // namespace trembler::ui
