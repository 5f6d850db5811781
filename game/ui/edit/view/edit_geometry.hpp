// The places of everything in the edited scene that can be clicked: objects, handles, areas, joints, wires.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

/// The topmost object under a point that is not locked; "" if there is none.
[[nodiscard]] std::string pickObject(EditParts const& parts, Vec2 at);
/// The topmost object of the edited world under a point, a piece of a composite part by itself, locked or
/// not; invalid if there is none.
[[nodiscard]] ObjectId pickTopmost(EditParts const& parts, Vec2 at);
/// The piece under a point of an object that is made from a composite part, as "pieces" of its entry states
/// it; "" for its main piece, if that entry says nothing else about it, and where no piece of it is.
[[nodiscard]] std::string pickPiece(EditParts const& parts, std::string const& entry, Vec2 at);
/// The objects that lie completely in a box and are not locked.
[[nodiscard]] std::vector<std::string> objectsWithin(EditParts const& parts, Vec2 a, Vec2 b);

/// The handles around the selected objects, m.
struct SelectionHandles {
    Box box;
    Vec2 turn;
    /// Corners and, from index 4 on, middles of sides: left, right, bottom, top. Empty: nothing scales.
    std::vector<Vec2> scaling;
    /// For each of these, the point of the box that it stands for, a little further inside.
    std::vector<Vec2> edges;
    [[nodiscard]] Vec2 middle() const { return box.corner + 0.5 * box.size; }
    /// Whether each direction can be scaled by itself.
    [[nodiscard]] bool stretches() const { return edges.size() > 4; }
};
[[nodiscard]] std::optional<SelectionHandles> handlesOf(EditParts const& parts);

/// The corners of the selected polygon by which it is changed, m; empty for any other selection.
[[nodiscard]] std::vector<Vec2> shapeCorners(EditParts const& parts);

/// An area that is seen in the scene.
struct SceneArea {
    EntryKind kind = EntryKind::none; ///< placing or goalArea
    std::string path;                 ///< "/placing/0", or the place of the condition
    Area area;
    bool selected = false;
};
[[nodiscard]] std::vector<SceneArea> sceneAreas(EditParts const& parts);
/// The corners by which an area is dragged: of a box, or of a polygon.
[[nodiscard]] std::vector<Vec2> areaCorners(Area const& area);
/// The area with one of these corners elsewhere; of a box, the opposite corner stays.
[[nodiscard]] Area withCorner(Area const& area, std::size_t corner, Vec2 to);
[[nodiscard]] Area movedArea(Area const& area, Vec2 by);
/// The area whose edge is under a point; its kind is none if there is none.
[[nodiscard]] SceneArea pickArea(EditParts const& parts, Vec2 at);

/// A point of a joint in the scene.
struct JointPoint {
    std::size_t joint = 0;
    std::string field; ///< "at" or "at_b"; of a pulley's wheels "ground_a" or "ground_b"
    Vec2 at;
};
[[nodiscard]] std::vector<JointPoint> jointPoints(EditParts const& parts);
/// The index of the joint, or of the connection, under a point.
[[nodiscard]] std::optional<std::size_t> pickJoint(EditParts const& parts, Vec2 at);
[[nodiscard]] std::optional<std::size_t> pickConnection(EditParts const& parts, Vec2 at);
/// The line along which a connection is drawn; empty if one of its ends is not there.
[[nodiscard]] std::vector<render::Point> pathOf(EditParts const& parts, std::string const& a,
                                                std::string const& b);

/// The number at the end of a JSON pointer.
[[nodiscard]] std::size_t indexOfPath(std::string const& path);

} // namespace trembler::ui
