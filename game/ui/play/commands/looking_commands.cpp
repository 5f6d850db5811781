#include "game/ui/play/commands/command_sections.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

void inspect(PlayParts& parts) {
    auto const selected = parts.placing.selected();
    parts.picking.inspect(selected ? parts.session.objectOf(*selected) : parts.picking.hovered());
}

template <bool Shown::*shown>
void show(PlayParts& parts) {
    parts.shown.*shown = !(parts.shown.*shown);
}
template <bool Shown::*shown>
bool isShown(PlayParts const& parts) {
    return parts.shown.*shown;
}

void showNames(PlayParts& parts) {
    parts.shown.names = !parts.shown.names;
    Settings settings = parts.context.profile.settings();
    settings.names = parts.shown.names;
    parts.context.profile.setSettings(settings);
}

constexpr Command<PlayParts> lookingTable[] = {
    {.info = {.id = "fit",
              .keys = {{{SDLK_HOME}}},
              .icon = Icon::Fit,
              .group = CommandGroup::looking,
              .name = "Show everything",
              .tip = "Show everything",
              .help = "show everything"},
     .run =
         [](PlayParts& parts) {
             if (parts.run.paused() && parts.timeline.shown()) {
                 parts.timeline.seek(0); // as End shows the present
             } else {
                 parts.view.fit();
             }
         }},
    {.info = {.id = "inspect",
              .keys = {{{SDLK_i}}},
              .icon = Icon::Eye,
              .group = CommandGroup::looking,
              .name = "Inspect",
              .tip = "Show all properties of the selected part, or of the object under the mouse",
              .help = "inspect the selected part"},
     .run = inspect},
    {.info = {.id = "electricity",
              .keys = {{{SDLK_1}}},
              .icon = Icon::Bolt,
              .group = CommandGroup::looking,
              .name = "Electricity",
              .tip = "Show the electricity graph",
              .help = "electricity, magnetism, contacts, names"},
     .run = show<&Shown::electricity>,
     .on = isShown<&Shown::electricity>},
    {.info = {.id = "magnetism",
              .keys = {{{SDLK_2}}},
              .icon = Icon::Magnet,
              .group = CommandGroup::looking,
              .name = "Magnetism",
              .tip = "Show magnetic forces and field lines",
              .help = "electricity, magnetism, contacts, names"},
     .run = show<&Shown::magnetism>,
     .on = isShown<&Shown::magnetism>},
    {.info = {.id = "contacts",
              .keys = {{{SDLK_3}}},
              .icon = Icon::Contact,
              .group = CommandGroup::looking,
              .name = "Contacts",
              .tip = "Show contacts",
              .help = "electricity, magnetism, contacts, names"},
     .run = show<&Shown::contacts>,
     .on = isShown<&Shown::contacts>},
    {.info = {.id = "names",
              .keys = {{{SDLK_n}}},
              .icon = Icon::Eye,
              .group = CommandGroup::looking,
              .name = "Names",
              .tip = "Show names",
              .help = "electricity, magnetism, contacts, names"},
     .run = showNames,
     .on = isShown<&Shown::names>},
};

} // namespace

std::span<Command<PlayParts> const> lookingCommands() {
    return lookingTable;
}

} // namespace trembler::ui
