// Buttons for players: large, with an ink rim and a lip that goes down when pressed.
#pragma once

#include "render/panels/icons.hpp"

#include <cstdint>

namespace trembler::render {

// Between Gui::beginFrame and endFrame, inside an ImGui window. The part of a label after "##" makes the id
// unique and is not shown, as everywhere in ImGui.

/// Width of the line around a button, pixels at UI scale 1; half of it lies outside the button.
inline constexpr float buttonOutline = 1.6F;

enum class ButtonLook : std::uint8_t {
    Primary, ///< the usual next action
    Quiet,   ///< all other actions
    Danger,  ///< an action that loses data
};

struct ButtonOptions {
    Icon icon = Icon::None;
    ButtonLook look = ButtonLook::Quiet;
    float width = 0.F; ///< pixels at UI scale 1; 0 fits the label, negative fills the line
    bool enabled = true;
    char const* tip = nullptr; ///< shown when the mouse rests on it
};

/// True in the frame in which the button is clicked.
bool bigButton(char const* label, ButtonOptions const& options = {});

/// A square button with a picture only; `on` shows it pressed in (a switch). The tip describes its action in
/// words.
bool iconButton(char const* id, Icon icon, char const* tip, bool on = false, bool enabled = true);

} // namespace trembler::render
