// The keys that commands have at present, as sentences name them: no text names a key that the player may
// have changed.
#pragma once

#include "game/ui/shared/commands/key_bindings.hpp"

#include <initializer_list>
#include <string>
#include <string_view>

namespace trembler::ui {

enum class KeyDevice : std::uint8_t { keyboard, pad };

/// The label of the command's first key of a device; "" if it has none.
[[nodiscard]] std::string keyOfDevice(std::string_view command, KeyDevice device,
                                      KeyBindings const& bindings);

/// The same with "–" for none.
[[nodiscard]] std::string keyOrNone(std::string_view command, KeyDevice device, KeyBindings const& bindings);

/// "Esc or Pad B": the first key, and the first button, that any of the commands has; "–" if none has one.
[[nodiscard]] std::string namedKeys(std::initializer_list<std::string_view> commands,
                                    KeyBindings const& bindings);

/// "The arrow keys", or "J, L, I, K": what moves parts and the pointer on a device.
[[nodiscard]] std::string namedDirections(KeyDevice device, KeyBindings const& bindings);

/// The tip of a command, of a switch that is on or off, with keys in its gaps.
[[nodiscard]] std::string shownTip(CommandInfo const& command, bool on, KeyBindings const& bindings);
/// The same with the command's own key: "Undo (Ctrl+Z)".
[[nodiscard]] std::string tipOf(CommandInfo const& command, bool on, KeyBindings const& bindings);

} // namespace trembler::ui
