#include "game/ui/play/commands/play_commands.hpp"

#include "game/ui/commands/common_commands.hpp"
#include "game/ui/play/keeping/saving.hpp"
#include "game/ui/play/play_parts.hpp"
#include "game/ui/shared/words.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using render::Icon;

constexpr double budgetStep = 1.25; // by which a key makes it more or less

bool building(PlayParts const& parts) {
    return parts.run.building();
}
bool inARun(PlayParts const& parts) {
    return !parts.run.building();
}
/// Something is in the hand or selected, so keys can turn it, move it, put it back.
bool partAtHand(PlayParts const& parts) {
    return building(parts) && (parts.placing.carried() || parts.placing.selected());
}

/// What the tools do may make another world.
template <class Doing>
void place(PlayParts& parts, Doing&& doing) {
    World const* const world = &parts.session.world();
    doing(parts.placing);
    if (world != &parts.session.world()) {
        parts.newWorld();
    }
}

template <int steps>
void turn(PlayParts& parts) {
    place(parts, [&](PlacingTool& placing) { placing.turn(steps, parts.context.shiftHeld()); });
}

template <int x, int y>
void nudge(PlayParts& parts) {
    place(parts, [&](PlacingTool& placing) { placing.nudge({x, y}, parts.context.shiftHeld()); });
}

void undo(PlayParts& parts) {
    parts.placing.cancel();
    if (parts.session.undo()) {
        parts.newWorld();
    }
}

void redo(PlayParts& parts) {
    parts.placing.cancel();
    if (parts.session.redo()) {
        parts.newWorld();
    }
}

void allBack(PlayParts& parts) {
    if (!parts.allBack.ask()) {
        parts.context.toasts.add(words::allBackAgain, render::ToastKind::News, AskedTwice::patience);
        return;
    }
    parts.placing.reset();
    parts.session.putAllBack();
    parts.newWorld();
    parts.context.toasts.add(words::allBackDone);
}

void showNames(PlayParts& parts) {
    parts.shown.names = !parts.shown.names;
    Settings settings = parts.context.profile.settings();
    settings.names = parts.shown.names;
    parts.context.profile.setSettings(settings);
}

void hint(PlayParts& parts) {
    auto const& hints = parts.session.level().hints;
    if (hints.empty()) {
        parts.context.toasts.add(words::noHints);
    }
    parts.hintsShown = std::min(parts.hintsShown + 1, hints.size());
}

void inspect(PlayParts& parts) {
    auto const selected = parts.placing.selected();
    parts.picking.inspect(selected ? parts.session.objectOf(*selected) : parts.picking.hovered());
}

/// One thing at a time: what is open or in the hand, and at last the menu.
void back(PlayParts& parts) {
    if (parts.hand.cutting()) {
        parts.hand.setCutting(false);
    } else if (parts.placing.cancel()) {
        return;
    } else if (parts.inspector.open()) {
        parts.inspector.close();
    } else {
        parts.request = request::OpenMenu{MenuPage::main};
    }
}

CatalogEntry const* nextLevel(PlayParts const& parts) {
    return parts.context.levels.after(parts.file);
}

template <bool Shown::*shown>
void show(PlayParts& parts) {
    parts.shown.*shown = !(parts.shown.*shown);
}
template <bool Shown::*shown>
bool isShown(PlayParts const& parts) {
    return parts.shown.*shown;
}

template <MenuPage page>
void openMenu(PlayParts& parts) {
    parts.request = request::OpenMenu{page};
}

using Row = Command<PlayParts>;

// The order is that of the page of keys.
constexpr Row table[] = {
    {.info = {.id = "run",
              .keys = {{{SDLK_SPACE}}},
              .icon = Icon::Play,
              .group = CommandGroup::running,
              .name = "Run",
              .tip = "Let the world run",
              .help = "run and stop",
              .whenOn = {Icon::Stop, "Stop", "Stop and put everything back as it was placed"}},
     .run = [](PlayParts& parts) { parts.run.runOrStop(); },
     .on = inARun},
    {.info = {.id = "pause",
              .keys = {{{SDLK_p}}},
              .icon = Icon::Pause,
              .group = CommandGroup::running,
              .name = "Pause",
              .tip = "Pause",
              .help = "pause",
              .whenOn = {Icon::Play, "Go on", "Go on"}},
     .run = [](PlayParts& parts) { parts.run.pauseOrGo(); },
     .available = inARun,
     .on = [](PlayParts const& parts) { return parts.run.paused(); }},
    {.info = {.id = "step",
              .keys = {{{SDLK_f}}},
              .use = KeyUse::repeats, // held: slow motion
              .icon = Icon::Step,
              .group = CommandGroup::running,
              .name = "One frame",
              .tip = "One frame, a sixtieth of a second",
              .help = "one frame"},
     .run = [](PlayParts& parts) { parts.run.step(); }},
    {.info = {.id = "fast",
              .keys = {{{SDLK_TAB}}},
              .use = KeyUse::held,
              .icon = Icon::FastForward,
              .group = CommandGroup::running,
              .name = "Fast",
              .tip = "Four times as fast",
              .help = "hold: four times as fast"},
     .run = [](PlayParts& parts) { parts.run.switchFast(); },
     .available = inARun,
     .on = [](PlayParts const& parts) { return parts.run.fast(); }},
    {.info = {.id = "turn-left",
              .keys = {{{SDLK_q}}},
              .use = KeyUse::repeats,
              .icon = Icon::TurnLeft,
              .group = CommandGroup::building,
              .name = "Turn left",
              .tip = "Turn the part in hand to the left by 15°, with Shift by 1°",
              .help = "turn the part in hand (Shift: 1°)"},
     .run = turn<1>,
     .available = partAtHand},
    {.info = {.id = "turn-right",
              .keys = {{{SDLK_e}}},
              .use = KeyUse::repeats,
              .icon = Icon::TurnRight,
              .group = CommandGroup::building,
              .name = "Turn right",
              .tip = "Turn the part in hand to the right by 15°, with Shift by 1°",
              .help = "turn the part in hand (Shift: 1°)"},
     .run = turn<-1>,
     .available = partAtHand},
    {.info = {.id = "move-left",
              .keys = {{{SDLK_LEFT}}},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move left",
              .tip = "Move the selected part to the left, with Shift by less",
              .help = "move the selected part (Shift: finer)"},
     .run = nudge<-1, 0>,
     .available = partAtHand},
    {.info = {.id = "move-right",
              .keys = {{{SDLK_RIGHT}}},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move right",
              .tip = "Move the selected part to the right, with Shift by less",
              .help = "move the selected part (Shift: finer)"},
     .run = nudge<1, 0>,
     .available = partAtHand},
    {.info = {.id = "move-up",
              .keys = {{{SDLK_UP}}},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move up",
              .tip = "Move the selected part up, with Shift by less",
              .help = "move the selected part (Shift: finer)"},
     .run = nudge<0, 1>,
     .available = partAtHand},
    {.info = {.id = "move-down",
              .keys = {{{SDLK_DOWN}}},
              .use = KeyUse::repeats,
              .group = CommandGroup::building,
              .name = "Move down",
              .tip = "Move the selected part down, with Shift by less",
              .help = "move the selected part (Shift: finer)"},
     .run = nudge<0, -1>,
     .available = partAtHand},
    {.info = {.id = "put-back",
              .keys = {{{SDLK_DELETE}}},
              .icon = Icon::Remove,
              .group = CommandGroup::building,
              .name = "Put back",
              .tip = "Put the part in hand back into the toolbox",
              .help = "put the part back"},
     .run = [](PlayParts& parts) { place(parts, [](PlacingTool& placing) { placing.putBack(); }); },
     .available = partAtHand},
    {.info = {.id = "undo",
              .keys = {{withCtrl(SDLK_z)}},
              .use = KeyUse::repeats,
              .icon = Icon::Undo,
              .group = CommandGroup::building,
              .name = "Undo",
              .tip = "Undo",
              .help = "undo, redo"},
     .run = undo,
     .available = [](PlayParts const& parts) { return parts.session.canUndo() || parts.placing.carried(); }},
    {.info = {.id = "redo",
              .keys = {{withCtrlShift(SDLK_z), withCtrl(SDLK_y)}},
              .use = KeyUse::repeats,
              .icon = Icon::Redo,
              .group = CommandGroup::building,
              .name = "Redo",
              .tip = "Redo",
              .help = "undo, redo"},
     .run = redo,
     .available = [](PlayParts const& parts) { return parts.session.canRedo(); }},
    {.info = {.id = "all-back",
              .keys = {{{SDLK_BACKSPACE}}},
              .icon = Icon::Reset,
              .group = CommandGroup::building,
              .name = "Put all back",
              .tip = "Put all parts back into the toolbox",
              .help = "put all parts back"},
     .run = allBack,
     .available = [](PlayParts const& parts) { return building(parts) && !parts.session.placed().empty(); }},
    {.info = {.id = "fit",
              .keys = {{{SDLK_HOME}}},
              .icon = Icon::Fit,
              .group = CommandGroup::looking,
              .name = "Show everything",
              .tip = "Show everything",
              .help = "show everything"},
     .run = [](PlayParts& parts) { parts.view.fit(); }},
    {.info = {.id = "inspect",
              .keys = {{{SDLK_i}}},
              .icon = Icon::Eye,
              .group = CommandGroup::looking,
              .name = "Inspect",
              .tip = "Show all properties of the selected part, or of what the mouse points at",
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
    {.info = {.id = "cut",
              .keys = {{{SDLK_x}}},
              .icon = Icon::Scissors,
              .group = CommandGroup::running,
              .name = "Cut",
              .tip = "Cut a wire",
              .help = "cut a wire"},
     .run = [](PlayParts& parts) { parts.hand.setCutting(!parts.hand.cutting()); },
     .available = inARun,
     .on = [](PlayParts const& parts) { return parts.hand.cutting(); }},
    {.info = {.id = "hint",
              .keys = {{{SDLK_h}}},
              .icon = Icon::Hint,
              .group = CommandGroup::building,
              .name = words::hint,
              .tip = "Show a hint",
              .help = "hint"},
     .run = hint},
    {.info = {.id = "components",
              .keys = {{{SDLK_c}, {SDLK_F3}}},
              .icon = Icon::Gauge,
              .group = CommandGroup::looking,
              .name = words::components,
              .tip = "Components of the simulation",
              .help = "components, what they cost"},
     .run = [](PlayParts& parts) { parts.components.toggle(); },
     .on = [](PlayParts const& parts) { return parts.components.open(); }},
    {.info = {.id = "budget",
              .keys = {{{SDLK_b}}},
              .group = CommandGroup::looking,
              .name = "Time budget",
              .tip = "Keep to a time budget, or no longer",
              .help = "keep to a time budget"},
     .run = [](PlayParts& parts) { parts.context.toasts.add(switchBudget(parts.budget)); },
     .on = [](PlayParts const& parts) { return parts.budget.budget().has_value(); }},
    {.info = {.id = "less-budget",
              .keys = {{{SDLK_COMMA}}},
              .group = CommandGroup::looking,
              .name = "Less time",
              .tip = "A smaller time budget",
              .help = "less and more of it"},
     .run = [](PlayParts& parts) { parts.context.toasts.add(changeBudget(parts.budget, 1 / budgetStep)); }},
    {.info = {.id = "more-budget",
              .keys = {{{SDLK_PERIOD}}},
              .group = CommandGroup::looking,
              .name = "More time",
              .tip = "A larger time budget",
              .help = "less and more of it"},
     .run = [](PlayParts& parts) { parts.context.toasts.add(changeBudget(parts.budget, budgetStep)); }},
    {.info = {.id = "record",
              .keys = {{{SDLK_r}}},
              .icon = Icon::Record,
              .group = CommandGroup::program,
              .name = "Record",
              .tip = "Record frames as pictures",
              .help = "record frames",
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
              .tip = "Save what you placed and did as a solution",
              .help = "save what you did"},
     .run =
         [](PlayParts& parts) {
             saveSolution(parts.session, parts.file.stem().string(), parts.context.recorder,
                          parts.context.toasts);
         }},
    {.info = {.id = "levels",
              .keys = {{{SDLK_l}}},
              .icon = Icon::List,
              .group = CommandGroup::program,
              .name = words::levels,
              .tip = "Levels",
              .help = "levels, menu"},
     .run = openMenu<MenuPage::levels>},
    {.info = {.id = "back",
              .keys = {{{SDLK_ESCAPE}}},
              .fixed = true,
              .icon = Icon::Back,
              .group = CommandGroup::program,
              .name = words::back,
              .tip = "Let go of what is in the hand, close what is open, or else open the menu",
              .help = "levels, menu"},
     .run = back},
    {.info = {.id = "menu",
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
    {.info = {.id = "restart",
              .icon = Icon::Reset,
              .group = CommandGroup::building,
              .name = words::restart,
              .tip = "Put all parts back and forget the hints: the level as it was opened",
              .help = "start the level again"},
     .run = [](PlayParts& parts) { parts.restart(); }},
    {.info = {.id = "next-level",
              .icon = Icon::Next,
              .group = CommandGroup::program,
              .name = words::nextLevel,
              .tip = "Open the next level",
              .help = "next level"},
     .run = [](PlayParts& parts) { parts.request = request::OpenLevel{nextLevel(parts)->file}; },
     .available = [](PlayParts const& parts) { return nextLevel(parts) != nullptr; }},
    {.info = {.id = "watch-again",
              .icon = Icon::Play,
              .group = CommandGroup::running,
              .name = words::watchAgain,
              .tip = "Watch this run again from its beginning",
              .help = "watch again"},
     .run = [](PlayParts& parts) { parts.run.watchAgain(); },
     .available = inARun},
    {.info = {.id = "keep-playing",
              .group = CommandGroup::running,
              .name = words::keepPlaying,
              .tip = "Close the card that says that it works",
              .help = "keep playing"},
     .run = [](PlayParts& parts) { parts.celebration.dismiss(); },
     .available = [](PlayParts const& parts) { return parts.celebration.showing(); }},
};

constexpr Gesture gestures[] = {
    {.with = "wheel", .does = "turn the part in hand (Shift: 1°)", .beside = "turn-left"},
    {.with = "Ctrl, Alt", .does = "hold: place without the grid", .beside = "move-down"},
    {.with = "right click", .does = "put a part back, let go", .beside = "put-back"},
    {.with = "wheel", .does = "zoom; drag the paper to move it", .beside = "all-back"},
};

} // namespace

std::span<Command<PlayParts> const> playCommands() {
    return table;
}

std::span<Gesture const> playGestures() {
    return gestures;
}

} // namespace trembler::ui
