// What the mouse does on the field: it leads the tools, looks around, and opens the inspector.
#pragma once

#include "game/ui/play/mouse/picking.hpp"
#include "game/ui/tools/camera_control.hpp"
#include "game/ui/tools/hand_tool.hpp"
#include "game/ui/tools/placing_tool.hpp"

#include <optional>

namespace trembler::ui {

/// Pixels at UI scale 1 around the middle of the handle that turns a part within which it is meant.
inline constexpr double handleReach = 13;

/// Window thread only.
class FieldMouse {
public:
    /// All must outlive this.
    FieldMouse(Session& session, PlacingTool& placing, HandTool& hand, CameraControl& view, Picking& picking)
        : session_(session), placing_(placing), hand_(hand), view_(view), picking_(picking) {}

    /// What it must know of the rest of the screen.
    struct Surroundings {
        std::optional<Vec2> handle; ///< middle of the handle that turns the selected part, m
        bool watching = false;      ///< a run is watched again: things cannot be taken
    };
    /// One picture's worth of mouse. True if the session's world is another one since.
    bool update(Pointer const& pointer, Surroundings const& around, double seconds);
    /// A part has left the toolbox in this picture: the press has been used.
    void tookPart();

private:
    bool usePlacing(Pointer const& pointer, std::optional<Vec2> const& handle);
    void useHand(Pointer const& pointer, bool watching, double seconds);
    void lookAround(Pointer const& pointer);

    Session& session_;
    PlacingTool& placing_;
    HandTool& hand_;
    CameraControl& view_;
    Picking& picking_;
    render::Point pressedAt_; // pixels
    bool leftOnPaper_ = false;
    bool rightOnPaper_ = false;
    bool tookPart_ = false;
};

} // namespace trembler::ui
