#include "game/ui/edit/commands/command_menus.hpp"
#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_parts.hpp"
#include "render/window/gamepad.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

constexpr Command<EditParts> editFileMenu[] = {
    {.info = {.id = "edit-new",
              .keys = {{withCtrl(SDLK_n)}},
              .icon = Icon::Plus,
              .group = CommandGroup::editing,
              .name = "New level",
              .tip = "A new, empty level",
              .help = "new level"},
     .run = actions::newLevel},
    {.info = {.id = "edit-open",
              .keys = {{withCtrl(SDLK_o)}},
              .icon = Icon::List,
              .group = CommandGroup::editing,
              .name = "Open …",
              .tip = "Open a level file",
              .help = "open a level"},
     .run = actions::openLevel},
    {.info = {.id = "edit-save",
              .keys = {{withCtrl(SDLK_s)}},
              .icon = Icon::Save,
              .group = CommandGroup::editing,
              .name = "Save",
              .tip = "Save the level",
              .help = "save, save as"},
     .run = actions::save},
    {.info = {.id = "edit-save-as",
              .keys = {{withCtrlShift(SDLK_s)}},
              .icon = Icon::Save,
              .group = CommandGroup::editing,
              .name = "Save as …",
              .tip = "Save the level into another file",
              .help = "save, save as"},
     .run = actions::saveAs},
    {.info = {.id = "edit-test",
              .keys = {{{SDLK_SPACE}, {SDLK_RETURN}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_X)},
              .icon = Icon::Play,
              .group = CommandGroup::editing,
              .name = "Test",
              .tip = "Play the level; {} leads back",
              .tipKey = "back",
              .help = "test the level"},
     .run = actions::testPlay},
    {.info = {.id = "edit-commands",
              .keys = {{withCtrl(SDLK_p)}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_A)},
              .icon = Icon::Script,
              .group = CommandGroup::editing,
              .name = "All commands",
              .tip = "Find any command, part or kind of joint by its name",
              .help = "find any command"},
     .run = actions::showPalette},
    {.info = {.id = "edit-menu",
              .keys = {{{SDLK_F10}}},
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_START)},
              .icon = Icon::Menu,
              .group = CommandGroup::editing,
              .name = "Menu",
              .tip = "Settings, keys, title screen",
              .help = "menu"},
     .run = actions::openMenu},
};

} // namespace

std::span<Command<EditParts> const> editFileCommands() {
    return editFileMenu;
}

} // namespace trembler::ui
