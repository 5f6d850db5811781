#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/play/keeping/saving.hpp"
#include "game/ui/play/whatif/what_if_tool.hpp"
#include "game/ui/shared/commands/common_commands.hpp"
#include "game/ui/shared/words.hpp"
#include "render/window/gamepad.hpp"

#include <utility>

namespace trembler::ui {
namespace {

using render::Icon;

template <MenuPage page>
void openMenu(PlayParts& parts) {
    parts.request = request::OpenMenu{page};
}

/// Ends one thing: moving the view by keys, the use of the scissors, the carrying or choice of parts, the
/// inspector, the selection, the computing of a what-if, the what-if, a search in the
/// toolbox. If there is none of these, opens the
/// menu.
void back(PlayParts& parts) {
    if (std::exchange(parts.movesView, false)) {
        return;
    }
    if (parts.whatIfTool->cardHasKeys()) {
        parts.whatIfTool->giveCardKeys(false);
    } else if (parts.hand.cutting()) {
        parts.hand.setCutting(false);
    } else if (parts.wires.cancel() || parts.placing.cancel() || parts.group.cancel()) {
        return;
    } else if (parts.why.open()) {
        parts.why.stopOrClose();
    } else if (parts.inspector.open()) {
        parts.inspector.close();
    } else if (parts.run.building() && parts.placing.selected()) {
        parts.placing.select(std::nullopt);
    } else if (parts.whatIfTool->cutting()) {
        parts.whatIfTool->setCutting(false);
    } else if (parts.whatIf->working() && !parts.whatIf->stopped()) {
        parts.whatIf->stop();
    } else if (parts.whatIf->active()) {
        parts.whatIf->end();
    } else if (parts.run.building() && !parts.toolbox.sought().empty()) {
        parts.toolbox.seek({});
    } else {
        parts.request = request::OpenMenu{MenuPage::main};
    }
}

constexpr Command<PlayParts> programTable[] = {
    {.info = {.id = "record",
              .keys = {{{SDLK_r}}},
              .icon = Icon::Record,
              .group = CommandGroup::program,
              .name = "Record",
              .tip = "Record a clip of the run",
              .help = "record a clip",
              .whenOn = {Icon::None, "End the recording", "End the recording"}},
     .run = [](PlayParts& parts) { parts.film.toggle(); },
     .on = [](PlayParts const& parts) { return parts.film.recording(); }},
    {.info = {.id = "picture",
              .keys = {{{SDLK_F12}}},
              .icon = Icon::Camera,
              .group = CommandGroup::program,
              .name = "Picture",
              .tip = "Take a picture",
              .help = "take a picture"},
     .run = [](PlayParts& parts) { parts.film.wantPicture(); }},
    {.info = {.id = "save",
              .keys = {{withCtrl(SDLK_s)}},
              .icon = Icon::Save,
              .group = CommandGroup::program,
              .name = "Save",
              .tip = "Save your placements and inputs as a solution",
              .help = "save a solution"},
     .run =
         [](PlayParts& parts) {
             saveSolution(parts.session, parts.id, parts.context.solutions, parts.context.toasts,
                          parts.context.pending);
         }},
    {.info = {.id = "solutions",
              .icon = Icon::List,
              .group = CommandGroup::program,
              .name = "Solutions",
              .tip = "Load, rename or delete saved solutions",
              .help = "saved solutions"},
     .run = openMenu<MenuPage::solutions>},
    {.info = {.id = "levels",
              .keys = {{{SDLK_l}}},
              .icon = Icon::List,
              .group = CommandGroup::program,
              .name = words::levels,
              .tip = "Levels",
              .help = "levels, menu"},
     .run = openMenu<MenuPage::levels>},
    {.info = common::back, .run = back},
    {.info = {.id = "menu",
              .pad = {render::padKey(SDL_CONTROLLER_BUTTON_START)},
              .icon = Icon::Menu,
              .group = CommandGroup::program,
              .name = "Menu",
              .tip = "Menu",
              .help = "menu",
              .alsoBy = "back"},
     .run = openMenu<MenuPage::main>},
    {.info = {.id = "help",
              .keys = {{{SDLK_F1}}},
              .icon = Icon::Why,
              .group = CommandGroup::program,
              .name = words::keys,
              .tip = "Keys",
              .help = "this page"},
     .run = openMenu<MenuPage::help>},
    {.info = common::fullscreen,
     .run = [](PlayParts& parts) { parts.request = request::SwitchFullscreen{}; }},
};

} // namespace

std::span<Command<PlayParts> const> programCommands() {
    return programTable;
}

} // namespace trembler::ui
