// The mouse on the field, where the world is shown: it guides the tools, moves the camera and opens the
// inspector.
#pragma once

#include "game/ui/play/mouse/picking.hpp"
#include "game/ui/shared/camera_control.hpp"
#include "game/ui/tools/group_tool.hpp"
#include "game/ui/tools/hand_tool.hpp"
#include "game/ui/tools/placing_tool.hpp"
#include "game/ui/tools/wire_tool.hpp"

#include <optional>

namespace trembler::ui {

/// The mouse is on the handle that turns a part within this distance of its middle, pixels at UI scale 1.
inline constexpr double handleReach = 13;

/// Window thread only.
class FieldMouse {
public:
    /// All must outlive this.
    FieldMouse(Session& session, PlacingTool& placing, GroupTool& group, WireTool& wires, HandTool& hand,
               HandTool& second, CameraControl& view, Picking& picking)
        : session_(session), placing_(placing), group_(group), wires_(wires), hand_(hand), second_(second),
          view_(view), picking_(picking) {}

    /// The state of the rest of the screen that FieldMouse depends on.
    struct Surroundings {
        std::optional<Vec2> handle; ///< middle of the handle that turns the selected part, m
        bool watching = false;      ///< a run is watched again: objects cannot be grabbed
        bool past = false;          ///< the past is shown: nothing in it can be grabbed or cut
        bool taken = false;         ///< the hand of a what-if uses the pointer
        bool second = false;        ///< the mouse is the second hand, and the first one stays where it is
    };
    /// Handles the mouse for one picture, `seconds` after the last. True if the session now has another
    /// world.
    bool update(Pointer const& pointer, Surroundings const& around, double seconds);
    /// The press in this picture took a part out of the toolbox, so it has no other meaning.
    void tookPart();

private:
    bool usePlacing(Pointer const& pointer, std::optional<Vec2> const& handle);
    void useHand(Pointer const& pointer, Surroundings const& around, double seconds);
    void lookAround(Pointer const& pointer);

    Session& session_;
    PlacingTool& placing_;
    GroupTool& group_;
    WireTool& wires_;
    HandTool& hand_;
    HandTool& second_;
    CameraControl& view_;
    Picking& picking_;
    render::Point pressedAt_;  // of the left button, pixels
    bool leftOnPaper_ = false; // the left button went down on empty paper
    bool rightOnPaper_ = false;
    bool wasSecond_ = false;
    bool tookPart_ = false;
};

} // namespace trembler::ui
