// Small pictures on buttons, drawn with lines so that they are sharp at any scale and need no icon font.
#pragma once

#include <imgui.h>

#include <cstdint>

namespace trembler::render {

enum class Icon : std::uint8_t {
    None,
    Play,
    Pause,
    Stop,
    Step,
    Record,
    Reset,
    Camera,
    TurnLeft,
    TurnRight,
    Flip,
    Remove,
    Hint,
    Why,
    Menu,
    Settings,
    Back,
    Next,
    Tick,
    Cross,
    Plus,
    Eye,
    Magnet,
    Bolt,
    FastForward,
    Slower,
    Undo,
    Redo,
    List,
    Scissors,
    Contact,
    Gauge,
    Fit,
    Save,
    Script,
    Timeline,
    Curve,
    Repeat,
    GoOn,
    Drop,
    Note,
    Wall,
    Solids,
    Grid,
};

/// Draws the icon within a square of `size` pixels around `centre`.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);

} // namespace trembler::render
