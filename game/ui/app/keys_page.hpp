// The page of the settings on which keys are given to commands.
#pragma once

#include "game/ui/shared/ui_context.hpp"

#include <string>

namespace trembler::ui {

/// Every change goes into the profile at once. Window thread only.
class KeysPage {
public:
    /// Between Gui::beginFrame and endFrame. True if the player wants to go back.
    bool draw(UiContext& context);
    /// It waits for a key. False if it did not: then there is nothing to be left.
    bool cancel();
    [[nodiscard]] bool waiting() const { return waiting_ != nullptr; }
    /// What it last said of a key that could not be had; "" if nothing.
    [[nodiscard]] std::string const& complaint() const { return complaint_; }

private:
    void takeKey(UiContext& context);
    void drawRows(UiContext& context);
    void drawRow(UiContext& context, CommandInfo const& command);

    CommandInfo const* waiting_ = nullptr; // for its key
    bool taking_ = false;                  // the keys of this picture are for it
    std::string complaint_;
};

} // namespace trembler::ui
