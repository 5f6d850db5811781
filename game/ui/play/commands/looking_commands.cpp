#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/shared/commands/named_keys.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/window/gamepad.hpp"

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

template <int x, int y>
void look(PlayParts& parts) {
    parts.view.look({x * viewStep, y * viewStep});
}

/// At the pointer that keys move, if it is in use, so that zooming leads to it.
template <int notches>
void zoom(PlayParts& parts) {
    bool const byKeys = parts.keyPointer.active();
    parts.view.zoom(byKeys ? parts.pointer.screen : parts.view.middle(), notches);
}

void moveView(PlayParts& parts) {
    parts.movesView = !parts.movesView;
    if (parts.movesView) {
        KeyBindings const& keys = parts.context.keys;
        KeyDevice const device = keyDevice(parts.lesson.device());
        auto const key = [&](std::string_view id) { return keyOrNone(id, device, keys); };
        parts.context.toasts.add(textWith("view.moves", namedDirections(device, keys), key("zoom-in"),
                                          key("zoom-out"), key("back")),
                                 render::ToastKind::News, 6);
    }
}

constexpr Command<PlayParts> lookingTable[] = {
    {.info = {.id = "fit",
              .keys = {{{SDLK_HOME}}},
              .icon = Icon::Fit,
              .group = CommandGroup::looking,
              .name = "Fit",
              .tip = "Fit: show the whole scene, as large as the cards leave room for it",
              .help = "show everything"},
     .run = [](PlayParts& parts) { parts.fitWanted = true; }},
    {.info = {.id = "view-left",
              .keys = {{withCtrl(SDLK_LEFT)}},
              .use = KeyUse::repeats,
              .group = CommandGroup::looking,
              .name = "Look left",
              .tip = "Move the view to the left",
              .help = "move the view"},
     .run = look<-1, 0>},
    {.info = {.id = "view-right",
              .keys = {{withCtrl(SDLK_RIGHT)}},
              .use = KeyUse::repeats,
              .group = CommandGroup::looking,
              .name = "Look right",
              .tip = "Move the view to the right",
              .help = "move the view"},
     .run = look<1, 0>},
    {.info = {.id = "view-up",
              .keys = {{withCtrl(SDLK_UP)}},
              .use = KeyUse::repeats,
              .group = CommandGroup::looking,
              .name = "Look up",
              .tip = "Move the view up",
              .help = "move the view"},
     .run = look<0, 1>},
    {.info = {.id = "view-down",
              .keys = {{withCtrl(SDLK_DOWN)}},
              .use = KeyUse::repeats,
              .group = CommandGroup::looking,
              .name = "Look down",
              .tip = "Move the view down",
              .help = "move the view"},
     .run = look<0, -1>},
    {.info = {.id = "zoom-in",
              .keys = {{withCtrl(SDLK_PLUS), withCtrl(SDLK_EQUALS)}},
              .pad = {render::padRightTrigger},
              .use = KeyUse::repeats,
              .group = CommandGroup::looking,
              .name = "Closer",
              .tip = "Closer",
              .help = "zoom",
              .padPhase = PadPhase::view},
     .run = zoom<2>},
    {.info = {.id = "zoom-out",
              .keys = {{withCtrl(SDLK_MINUS), withCtrl(SDLK_KP_MINUS)}},
              .pad = {render::padLeftTrigger},
              .use = KeyUse::repeats,
              .group = CommandGroup::looking,
              .name = "Farther",
              .tip = "Farther",
              .help = "zoom",
              .padPhase = PadPhase::view},
     .run = zoom<-2>},
    {.info = {.id = "move-view",
              .icon = Icon::Fit,
              .group = CommandGroup::looking,
              .name = "Move the view",
              .tip = "Let what moves the pointer move the view; {} ends it",
              .tipKey = "back",
              .help = "move the view as the pointer"},
     .run = moveView,
     .on = [](PlayParts const& parts) { return parts.movesView; }},
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
