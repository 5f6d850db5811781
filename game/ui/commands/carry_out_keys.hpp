// From key events to commands.
#pragma once

#include "game/ui/commands/key_bindings.hpp"
#include "render/window/input_events.hpp"

#include <SDL_events.h>

#include <span>

namespace trembler::ui {

/// Carries out what the keys of one picture's events ask for, each command at most once, in the order in
/// which the keys went down. A held key counts again where the command says so.
void carryOutKeys(std::span<SDL_Event const> events, KeyBindings const& bindings, CommandSet& commands);

/// Whether a key of a command of KeyUse::held is down; modifiers that its chord does not have make no
/// difference.
[[nodiscard]] bool isHeld(render::InputEvents const& input, KeyBindings const& bindings, std::string_view id);

} // namespace trembler::ui
