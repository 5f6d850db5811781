// Shapes drawn by hand, as the value of the property "shape".
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "runtime/math/vec2.hpp"

#include <span>
#include <string>
#include <vector>

namespace trembler::edit {

/// A shape with its place, as addObject() needs them.
struct DrawnShape {
    Vec2 at;                 ///< m: the object's centre
    double angleDegrees = 0; ///< the object's angle
    Json shape;              ///< the value of "shape": pieces around the centre
};

// They throw CommandError if the drawing is too small or too large, in words for the author.

/// A box with these opposite corners, m.
[[nodiscard]] DrawnShape drawnBox(Vec2 from, Vec2 to);
/// A disc around a centre, up to a point on its edge, m.
[[nodiscard]] DrawnShape drawnDisc(Vec2 centre, Vec2 edge);
/// A capsule whose round ends have their centres there, m.
[[nodiscard]] DrawnShape drawnCapsule(Vec2 from, Vec2 to, double radius);
/// A polygon with these corners, m, in either direction, at least three; it may be concave, and is then made
/// of several convex pieces of at most eight corners. Its edges must not cross.
[[nodiscard]] DrawnShape drawnPolygon(std::span<Vec2 const> corners);

/// The corners of an object's outline by which it can be changed, m, in the world. Empty for one that is not
/// made of polygons alone, is made of several pieces or mirrored, or does not exist.
[[nodiscard]] std::vector<Vec2> outlineCorners(GameData const& data, Json const& level,
                                               std::string const& name);
/// Moves one of these corners; the object's place stays. A corner that comes to another one, or to the line
/// between its neighbours, is left out. A shape of the object's part is overridden. Throws CommandError if
/// there is no such corner, the object is locked, or the edges would cross.
[[nodiscard]] Command moveCorner(GameData const& data, Json const& level, std::string const& name,
                                 std::size_t corner, Vec2 to);

} // namespace trembler::edit
