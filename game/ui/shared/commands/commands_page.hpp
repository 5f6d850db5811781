// The page of all commands of the covered screen: a player with a gamepad, which has few buttons,
// reaches every one of them here.
#pragma once

#include "game/ui/shared/commands/command.hpp"
#include "game/ui/shared/ui_context.hpp"

#include <cstddef>
#include <optional>

namespace trembler::ui {

/// Window thread only.
class CommandsPage {
public:
    struct Choice {
        std::optional<std::size_t> command{}; ///< to be run, an index of the set
        bool changeKeys = false;
        bool back = false;
    };
    /// Between Gui::beginFrame and endFrame, inside a page of the menu.
    [[nodiscard]] Choice draw(UiContext& context, CommandSet const& commands);
};

} // namespace trembler::ui
