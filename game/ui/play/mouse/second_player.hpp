// The buttons and keys of a second player, which are commands like all others and can be bound like them.
#pragma once

#include "game/ui/shared/ui_context.hpp"
#include "render/window/second_pad.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace trembler::ui {

/// The ids of the second player's commands.
namespace second_player {

inline constexpr std::string_view left = "second-left";
inline constexpr std::string_view right = "second-right";
inline constexpr std::string_view up = "second-up";
inline constexpr std::string_view down = "second-down";
inline constexpr std::string_view grab = "second-grab";

} // namespace second_player

/// The buttons of their gamepad.
[[nodiscard]] render::SecondPadButtons secondPadButtons(KeyBindings const& bindings);

/// What the second player does at present, with their gamepad or with keys of the keyboard. nullopt if there
/// is no second player: one without a gamepad comes with the first press of such a key, and stays.
/// `before`: whether there was one in the last picture. Window thread only.
[[nodiscard]] std::optional<render::SecondPad> secondPlayerNow(UiContext const& context, bool before);

} // namespace trembler::ui
