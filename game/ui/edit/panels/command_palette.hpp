// Finds any command by typing a part of its name.
#pragma once

#include "game/ui/shared/commands/command.hpp"
#include "game/ui/shared/ui_context.hpp"

#include <optional>
#include <string>

namespace trembler::ui {

/// Window thread only.
class CommandPalette {
public:
    void begin();
    void close() { open_ = false; }
    [[nodiscard]] bool isOpen() const { return open_; }
    /// Draws the card and handles its keys: arrows choose, Enter runs, Esc closes. Returns the chosen command
    /// and is closed then. Between Gui::beginFrame and endFrame.
    [[nodiscard]] std::optional<std::size_t> draw(UiContext& context, CommandSet const& commands);

private:
    bool open_ = false;
    bool fresh_ = false;
    std::string typed_;
    std::size_t chosen_ = 0;
};

/// Whether every word of `typed` occurs in the text, in upper or lower case.
[[nodiscard]] bool fitsSearch(std::string const& text, std::string const& typed);

} // namespace trembler::ui
