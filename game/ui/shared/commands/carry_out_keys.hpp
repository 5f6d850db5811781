// Runs commands from key events.
#pragma once

#include "game/ui/shared/commands/key_bindings.hpp"
#include "render/window/input_events.hpp"

#include <SDL_events.h>

#include <optional>
#include <span>

namespace trembler::ui {

/// Runs the commands of one picture's key events, each at most once, in the order in which the keys went
/// down. Key repeats count where the command's KeyUse says so.
/// Returns the last command that was asked for and is not available.
std::optional<std::size_t> carryOutKeys(std::span<SDL_Event const> events, KeyBindings const& bindings,
                                        CommandSet& commands);

/// Whether a key acts on the screen while widgets have the keys: function keys, those with Ctrl, and that
/// which leads back; of a gamepad the buttons of commands that by default have one of `leading`.
[[nodiscard]] bool passesWidgets(SDL_Event const& event, KeyBindings const& bindings,
                                 CommandSet const& commands, std::span<SDL_Keycode const> leading);

/// Whether a key is down; modifiers that are not part of the chord are ignored.
[[nodiscard]] bool isHeld(render::InputEvents const& input, Chord const& chord);
/// The same for a key of a command of KeyUse::held.
[[nodiscard]] bool isHeld(render::InputEvents const& input, KeyBindings const& bindings, std::string_view id);

} // namespace trembler::ui
