// The mouse on the edited scene: it selects, moves, turns, scales and draws.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/edit/tools/join_tool.hpp"
#include "game/ui/edit/view/edit_geometry.hpp"
#include "puzzle/edit/tree/grid_features.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

/// Window thread only.
class EditMouse {
public:
    /// The action of the held button.
    enum class Doing : std::uint8_t {
        nothing,
        pressing, ///< on an object, not moved yet
        moving,
        turning,
        scaling,
        boxing,      ///< selecting with a box
        drawing,     ///< a shape or an area, from start() to the mouse
        connecting,  ///< a joint or a wire, from an object
        shapeCorner, ///< of the polygon that is selected
        areaCorner,
        areaMoving,
        jointMoving,
    };

    /// Handles the mouse for one picture.
    void update(EditParts& parts);
    /// Ends the present drag or selection as if it had not begun. False if there was none.
    bool cancel(EditParts& parts);
    /// The press in this picture took a part out of the catalogue.
    void tookPart() { tookPart_ = true; }

    [[nodiscard]] Doing doing() const { return doing_; }
    /// Where the button went down, on the grid for drawing, m.
    [[nodiscard]] Vec2 start() const { return start_; }
    /// The clicked corners of a polygon.
    [[nodiscard]] std::vector<Vec2> const& corners() const { return corners_; }
    [[nodiscard]] JoinTool const& join() const { return join_; }
    /// The object under the mouse; "" if there is none.
    [[nodiscard]] std::string const& hovered() const { return hovered_; }
    /// Where the dragged object is, m.
    [[nodiscard]] Vec2 movedTo() const { return anchor_ + moved_; }
    /// Why the present drag cannot be, in words; empty if it can.
    [[nodiscard]] std::string const& refused() const { return refused_; }

private:
    void press(EditParts& parts);
    void pressSelect(EditParts& parts);
    bool pressHandle(EditParts& parts);
    void pressOther(EditParts& parts);
    void clickCorner(EditParts& parts);
    void drag(EditParts& parts);
    void release(EditParts& parts);
    void releaseDrawing(EditParts& parts);
    void look(EditParts& parts);
    void beginGesture(EditParts& parts, Doing doing);
    /// Runs a command made from the tree before the gesture, in its place.
    void change(EditParts& parts, std::function<edit::Command(edit::Json const&)> const& make);
    [[nodiscard]] Vec2 snapped(EditParts const& parts, Vec2 at) const;
    /// The way by which objects go that are dragged by `way`, m.
    [[nodiscard]] Vec2 wayOnGrid(EditParts const& parts, Vec2 way) const;

    Doing doing_ = Doing::nothing;
    Vec2 start_;
    render::Point pressedAt_; // pixels
    std::optional<SelectionHandles> handles_;
    std::size_t handle_ = 0; // of the scaling handles, or of an area's corners
    SceneArea area_;
    JointPoint joint_;
    std::vector<Vec2> corners_;
    JoinTool join_;
    Tool tool_ = Tool::select; // in the last picture
    std::string hovered_;
    std::string refused_;
    std::string clicked_;         // the object that was pressed
    bool pressedTwice_ = false;   // the second press of a double click
    Vec2 anchor_;                 // of the object that is dragged, m
    edit::GridFeatures features_; // of the dragged objects before the drag
    Vec2 moved_;                  // by which they are moved, m
    edit::Json before_;           // the tree before the gesture
    edit::Gesture gesture_;
    std::size_t stepsBefore_ = 0;
    bool tookPart_ = false;
    bool draggingPart_ = false; // out of the catalogue, with the button held
    bool rightOnPaper_ = false;
};

} // namespace trembler::ui
