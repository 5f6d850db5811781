#include "game/ui/shared/commands/menu_keys.hpp"

#include "game/ui/shared/commands/common_commands.hpp"
#include "render/window/gamepad.hpp"

#include <algorithm>
#include <array>

namespace trembler::ui {
namespace {

using render::padKey;

constexpr Chord pad(SDL_GameControllerButton button) {
    return {.key = padKey(button)};
}

constexpr CommandInfo menuCommand(std::string_view id, std::array<Chord, 3> keys, Chord button, Phrase name,
                                  Phrase tip, bool essential = false) {
    return {.id = id,
            .keys = keys,
            .pad = button,
            .use = KeyUse::repeats,
            .essential = essential,
            .group = CommandGroup::menus,
            .name = name,
            .tip = tip,
            .help = tip};
}

constexpr std::size_t pageCommands = 12;

/// In the order of MenuKey, and behind them those that only the keyboard on the screen has.
constexpr std::array menuTable{
    menuCommand("menu-up", {{{SDLK_UP}}}, pad(SDL_CONTROLLER_BUTTON_DPAD_UP), "Item above",
                "In menus and lists: go to the item above", true),
    menuCommand("menu-down", {{{SDLK_DOWN}}}, pad(SDL_CONTROLLER_BUTTON_DPAD_DOWN), "Item below",
                "In menus and lists: go to the item below", true),
    menuCommand("menu-left", {{{SDLK_LEFT}}}, pad(SDL_CONTROLLER_BUTTON_DPAD_LEFT), "Item on the left",
                "In menus and lists: go to the left, or make the value smaller", true),
    menuCommand("menu-right", {{{SDLK_RIGHT}}}, pad(SDL_CONTROLLER_BUTTON_DPAD_RIGHT), "Item on the right",
                "In menus and lists: go to the right, or make the value larger", true),
    menuCommand("menu-press", {{{SDLK_RETURN}, {SDLK_SPACE}, {SDLK_KP_ENTER}}}, pad(SDL_CONTROLLER_BUTTON_A),
                "Press", "In menus and lists: press or choose the item", true),
    common::back,
    menuCommand("menu-next", {{{SDLK_TAB}}}, {}, "Next item", "In menus: go to the next item in their order"),
    menuCommand("menu-before", {{{.key = SDLK_TAB, .shift = true}}}, {}, "Item before",
                "In menus: go to the item before, in their order"),
    menuCommand("menu-type", {}, pad(SDL_CONTROLLER_BUTTON_X), "Type",
                "In panels and lists: type a number or a word; on the page of keys: take the keys away"),
    menuCommand("menu-erase", {{{SDLK_DELETE}}}, {}, "Take the keys away",
                "On the page of keys: take the keys of a command away"),
    menuCommand("menu-page-next", {}, pad(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER), "Next page of the panel",
                "While the panel has the keys: turn to its next page"),
    menuCommand("menu-page-before", {}, pad(SDL_CONTROLLER_BUTTON_LEFTSHOULDER), "Page of the panel before",
                "While the panel has the keys: turn to the page before"),
    menuCommand("letters-erase", {}, pad(SDL_CONTROLLER_BUTTON_X), "Delete the letter",
                "On the keyboard on the screen: delete the letter before the cursor"),
    menuCommand("letters-space", {}, pad(SDL_CONTROLLER_BUTTON_Y), "Space",
                "On the keyboard on the screen: type a space"),
    menuCommand("letters-left", {}, pad(SDL_CONTROLLER_BUTTON_LEFTSHOULDER), "Cursor to the left",
                "On the keyboard on the screen: move the cursor to the left"),
    menuCommand("letters-right", {}, pad(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER), "Cursor to the right",
                "On the keyboard on the screen: move the cursor to the right"),
    menuCommand("letters-capitals", {}, {.key = render::padLeftTrigger}, "Capital letters",
                "On the keyboard on the screen: the next letter is a capital"),
    menuCommand("letters-signs", {}, {.key = render::padRightTrigger}, "Signs",
                "On the keyboard on the screen: digits and signs"),
    menuCommand("letters-done", {}, pad(SDL_CONTROLLER_BUTTON_START), "End of the typing",
                "On the keyboard on the screen: keep what was typed"),
};

/// The page commands as a set, for KeyBindings::find.
class PageCommands final : public CommandSet {
public:
    using CommandSet::run;
    [[nodiscard]] std::size_t size() const override { return pageCommands; }
    [[nodiscard]] CommandInfo const& info(std::size_t index) const override { return menuTable[index]; }
    [[nodiscard]] bool available(std::size_t) const override { return true; }
    [[nodiscard]] bool on(std::size_t) const override { return false; }
    void run(std::size_t) override {}
};

/// Whether the key writes something in a text field, or takes it away.
bool writes(SDL_Keycode key) {
    bool const keypad = key >= SDLK_KP_DIVIDE && key <= SDLK_KP_PERIOD && key != SDLK_KP_ENTER;
    return keypad || key == SDLK_BACKSPACE || (key >= SDLK_SPACE && key < render::firstPadKey);
}

/// The meaning by default of keys that text fields use, too.
std::optional<MenuKey> usualMeaning(SDL_Keysym const& pressed) {
    switch (pressed.sym) {
    case SDLK_UP:
        return MenuKey::up;
    case SDLK_DOWN:
        return MenuKey::down;
    case SDLK_LEFT:
        return MenuKey::left;
    case SDLK_RIGHT:
        return MenuKey::right;
    case SDLK_RETURN:
    case SDLK_KP_ENTER:
        return MenuKey::press;
    case SDLK_ESCAPE:
        return MenuKey::back;
    case SDLK_TAB:
        return (pressed.mod & KMOD_SHIFT) != 0 ? MenuKey::before : MenuKey::next;
    default:
        return std::nullopt;
    }
}

SDL_Keysym keysym(SDL_Keycode key, Uint16 modifiers = KMOD_NONE) {
    SDL_Keysym made{};
    made.sym = key;
    made.scancode = SDL_GetScancodeFromKey(key);
    made.mod = modifiers;
    return made;
}

/// The key of ImGui's with this meaning; SDLK_UNKNOWN if there is none.
SDL_Keysym widgetKey(SDL_Keysym const& pressed, std::optional<MenuKey> meaning) {
    SDL_Keycode const key = pressed.sym;
    bool const enter = key == SDLK_RETURN || key == SDLK_KP_ENTER;
    if (!meaning) {
        // A key that widgets would take, although the player has bound another.
        bool const plain = (pressed.mod & (KMOD_CTRL | KMOD_ALT)) == 0;
        return plain && (usualMeaning(pressed) || key == SDLK_SPACE) ? keysym(SDLK_UNKNOWN) : pressed;
    }
    switch (*meaning) {
    case MenuKey::up:
        return keysym(SDLK_UP, pressed.mod);
    case MenuKey::down:
        return keysym(SDLK_DOWN, pressed.mod);
    case MenuKey::left:
        return keysym(SDLK_LEFT, pressed.mod);
    case MenuKey::right:
        return keysym(SDLK_RIGHT, pressed.mod);
    case MenuKey::press:
        return enter ? pressed : keysym(SDLK_SPACE, pressed.mod);
    case MenuKey::type:
        return keysym(SDLK_RETURN, pressed.mod);
    case MenuKey::back:
        return keysym(SDLK_ESCAPE, pressed.mod);
    case MenuKey::next:
        return keysym(SDLK_TAB, pressed.mod);
    case MenuKey::before:
    case MenuKey::erase:
    case MenuKey::pageNext:
    case MenuKey::pageBefore:
        break;
    }
    return pressed;
}

CommandList listed(std::initializer_list<std::pair<std::size_t, std::size_t>> ranges) {
    CommandList list;
    for (auto const& [from, to] : ranges) {
        for (std::size_t i = from; i < to; ++i) {
            list.commands.push_back(&menuTable[i]);
        }
    }
    return list;
}

} // namespace

CommandList menuCommands() {
    return listed({{0, pageCommands}});
}

CommandList letterCommands() {
    return listed({{0, static_cast<std::size_t>(MenuKey::next)}, {pageCommands, menuTable.size()}});
}

std::optional<MenuKey> menuKeyOf(SDL_Keysym const& pressed, KeyBindings const& bindings) {
    static PageCommands const commands;
    auto const index = bindings.find(commands, pressed);
    return index ? std::optional(static_cast<MenuKey>(*index)) : std::nullopt;
}

void MenuKeys::read(std::span<SDL_Event const> events, KeyBindings const& bindings, bool typing) {
    presses_.clear();
    for (SDL_Event const& event : events) {
        if (event.type != SDL_KEYDOWN) {
            continue;
        }
        SDL_Keysym const& pressed = event.key.keysym;
        bool const fieldHasIt = typing && writes(pressed.sym);
        auto meaning = fieldHasIt ? std::nullopt : menuKeyOf(pressed, bindings);
        if (!meaning && typing) {
            meaning = usualMeaning(pressed);
        }
        if (meaning) {
            presses_.push_back({*meaning, event.key.repeat != 0});
        }
    }
}

bool MenuKeys::pressed(MenuKey key, bool repeats) const {
    return std::any_of(presses_.begin(), presses_.end(),
                       [&](Press const& press) { return press.key == key && (repeats || !press.repeat); });
}

SDL_Keycode letterButtonOf(SDL_Keycode pressed, KeyBindings const& bindings) {
    for (CommandInfo const* command : letterCommands().commands) {
        for (Chord const& chord : bindings.keysOf(command->id)) {
            if (chord.key == pressed) {
                return command->pad.key;
            }
        }
    }
    return 0;
}

SDL_Event WidgetKeys::read(SDL_Event event, KeyBindings const& bindings, bool typing) {
    if (event.type != SDL_KEYDOWN && event.type != SDL_KEYUP) {
        return event;
    }
    SDL_Keycode const key = event.key.keysym.sym;
    auto const held =
        std::find_if(held_.begin(), held_.end(), [&](auto const& one) { return one.first == key; });
    if (held != held_.end() && (event.type == SDL_KEYUP || event.key.repeat != 0)) {
        event.key.keysym.sym = held->second.sym;
        event.key.keysym.scancode = held->second.scancode;
        if (event.type == SDL_KEYUP) {
            held_.erase(held);
        }
        return event;
    }
    bool const fieldHasIt = typing && !render::isPadKey(key);
    SDL_Keysym const shown =
        fieldHasIt ? event.key.keysym : widgetKey(event.key.keysym, menuKeyOf(event.key.keysym, bindings));
    if (event.type == SDL_KEYDOWN) {
        if (held != held_.end()) {
            held_.erase(held);
        }
        held_.emplace_back(key, shown);
    }
    event.key.keysym = shown;
    return event;
}

} // namespace trembler::ui
