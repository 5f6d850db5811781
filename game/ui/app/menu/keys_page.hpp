// The settings page on which the player assigns keys to commands.
#pragma once

#include "game/ui/shared/ui_context.hpp"

#include <string>

namespace trembler::ui {

/// Every change is saved in the profile at once. Window thread only.
class KeysPage {
public:
    /// Call between Gui::beginFrame and endFrame. Returns true if the player wants to go back.
    bool draw(UiContext& context);
    /// Stops waiting for a key. Returns false if it was not waiting.
    bool cancel();
    /// Does so if Esc was pressed, whatever it is bound to; a command that has Esc by default may get it
    /// back.
    void cancelByEscape(UiContext const& context);
    [[nodiscard]] bool waiting() const { return waiting_ != nullptr; }
    /// The message why a key could not be assigned last; "" if it could.
    [[nodiscard]] std::string const& complaint() const { return complaint_; }

private:
    void takeKey(UiContext& context);
    [[nodiscard]] std::string captionNow(UiContext const& context) const;
    void drawRows(UiContext& context);
    void drawRow(UiContext& context, CommandInfo const& command);

    CommandInfo const* waiting_ = nullptr; // the command that waits for a key; nullptr: none
    bool taking_ = false;                  // the key events of this picture belong to waiting_
    std::string complaint_;
};

} // namespace trembler::ui
