#include "game/ui/shared/commands/chord.hpp"

#include "game/ui/shared/texts.hpp"
#include "render/window/gamepad.hpp"

#include <array>
#include <cctype>
#include <utility>

namespace trembler::ui {
namespace {

/// The prefixes are the same in nameOf and labelOf, so that players can find a label's key in a file.
std::string modifiersOf(Chord const& chord) {
    return std::string(chord.ctrl ? "Ctrl+" : "") + (chord.alt ? "Alt+" : "") + (chord.shift ? "Shift+" : "");
}

/// Removes `prefix` from the beginning of `text` if more text follows it.
bool takePrefix(std::string_view& text, std::string_view prefix) {
    if (text.size() <= prefix.size()) {
        return false;
    }
    for (std::size_t i = 0; i < prefix.size(); ++i) {
        if (std::tolower(static_cast<unsigned char>(text[i])) !=
            std::tolower(static_cast<unsigned char>(prefix[i]))) {
            return false;
        }
    }
    text.remove_prefix(prefix.size());
    return true;
}

/// The same in the player's language.
std::string shownModifiers(Chord const& chord) {
    return std::string(chord.ctrl ? text("Ctrl+") : "") + (chord.alt ? text("Alt+") : "") +
           (chord.shift ? text("Shift+") : "");
}

} // namespace

Chord chordOf(SDL_Keysym const& keysym) {
    auto const held = [&](int modifier) { return (keysym.mod & modifier) != 0; };
    if (render::isPadKey(keysym.sym)) {
        return {.key = keysym.sym}; // a gamepad has no modifiers
    }
    return {.key = keysym.sym, .ctrl = held(KMOD_CTRL), .shift = held(KMOD_SHIFT), .alt = held(KMOD_ALT)};
}

bool isModifier(SDL_Keycode key) {
    switch (key) {
    case SDLK_LSHIFT:
    case SDLK_RSHIFT:
    case SDLK_LCTRL:
    case SDLK_RCTRL:
    case SDLK_LALT:
    case SDLK_RALT:
    case SDLK_LGUI:
    case SDLK_RGUI:
    case SDLK_MODE:
    case SDLK_CAPSLOCK:
    case SDLK_NUMLOCKCLEAR:
    case SDLK_SCROLLLOCK:
        return true;
    default:
        return false;
    }
}

std::string nameOf(Chord const& chord) {
    if (render::isPadKey(chord.key)) {
        return std::string(render::nameOfPadKey(chord.key));
    }
    return chord.any() ? modifiersOf(chord) + SDL_GetKeyName(chord.key) : std::string();
}

std::optional<Chord> chordFrom(std::string_view name) {
    if (auto const button = render::padKeyFrom(name)) {
        return Chord{.key = *button};
    }
    Chord chord;
    for (bool taken = true; taken;) {
        bool const ctrl = takePrefix(name, "Ctrl+");
        bool const alt = takePrefix(name, "Alt+");
        bool const shift = takePrefix(name, "Shift+");
        chord.ctrl = chord.ctrl || ctrl;
        chord.alt = chord.alt || alt;
        chord.shift = chord.shift || shift;
        taken = ctrl || alt || shift;
    }
    if (name.empty() || static_cast<unsigned char>(name.front()) < 0x20) {
        return std::nullopt; // SDL would accept a control character as a key
    }
    chord.key = SDL_GetKeyFromName(std::string(name).c_str());
    if (!chord.any() || isModifier(chord.key)) {
        return std::nullopt;
    }
    return chord;
}

std::string labelOf(Chord const& chord) {
    static constexpr std::array<std::pair<SDL_Keycode, char const*>, 8> shorter{{
        {SDLK_ESCAPE, "Esc"},
        {SDLK_RETURN, "Enter"},
        {SDLK_LEFT, "←"},
        {SDLK_RIGHT, "→"},
        {SDLK_UP, "↑"},
        {SDLK_DOWN, "↓"},
        {SDLK_COMMA, "comma"}, // punctuation is hard to see between other characters
        {SDLK_PERIOD, "full stop"},
    }};
    for (auto const& [key, label] : shorter) {
        if (chord.key == key) {
            return shownModifiers(chord) + text(label);
        }
    }
    if (render::isPadKey(chord.key)) {
        return translated(nameOf(chord));
    }
    return chord.any() ? shownModifiers(chord) + translated(SDL_GetKeyName(chord.key)) : std::string();
}

} // namespace trembler::ui
