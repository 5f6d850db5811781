// The sections of the editor's command table, each the contents of a menu.
#pragma once

#include "game/ui/commands/command.hpp"

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
    char const* title;
    std::span<Command<EditParts> const> (*commands)();
};
inline constexpr std::array<EditMenu, 5> editMenus{{{"File", editFileCommands},
                                                    {"Edit", editChangeCommands},
                                                    {"Arrange", editArrangeCommands},
                                                    {"Tools", editToolCommands},
                                                    {"View", editViewCommands}}};

} // namespace trembler::ui
