// The sections of the editor's command table, each the contents of a menu.
#pragma once

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/shared/commands/command.hpp"

#include <array>
#include <span>

namespace trembler::ui {

struct EditParts;

[[nodiscard]] std::span<Command<EditParts> const> editFileCommands();
[[nodiscard]] std::span<Command<EditParts> const> editChangeCommands();
[[nodiscard]] std::span<Command<EditParts> const> editArrangeCommands();
[[nodiscard]] std::span<Command<EditParts> const> editToolCommands();
[[nodiscard]] std::span<Command<EditParts> const> editViewCommands();

/// A menu of the editor's bar.
struct EditMenu {
    char const* const& title; // in the language in use
    std::span<Command<EditParts> const> (*commands)();
};
inline std::array<EditMenu, 5> const editMenus{{{words::menuFile, editFileCommands},
                                                {words::menuEdit, editChangeCommands},
                                                {words::menuArrange, editArrangeCommands},
                                                {words::menuTools, editToolCommands},
                                                {words::menuView, editViewCommands}}};

} // namespace trembler::ui
