// The shape of an object.
#pragma once

#include "runtime/property/description.hpp"

#include <array>
#include <vector>

namespace trembler {

inline constexpr std::size_t maximumPieces = 256; ///< of a shape
inline constexpr std::size_t maximumCorners = 8;  ///< of a piece

enum class ShapeForm : int { circle, box, polygon, capsule };
template <>
inline constexpr std::array<std::string_view, 4> choiceNames<ShapeForm>{"circle", "box", "polygon",
                                                                        "capsule"};

/// One convex piece. Which of the measures are used depends on the form; files state only these.
struct ShapePiece {
    ShapeForm form = ShapeForm::box;
    Vec2 at;                   ///< m, centre in the object's frame
    double angle = 0;          ///< rad, in the object's frame
    double radius = 0.1;       ///< m: circle, capsule (of its round ends)
    double width = 0.2;        ///< m: box; capsule: whole length along its x axis, ends included
    double height = 0.2;       ///< m: box
    std::vector<Vec2> corners; ///< m: polygon, 3 to 8 corners, convex, anticlockwise, in the piece's frame

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "form", .unit = "", .meaning = "kind of piece", .required = true}, self.form);
        visit(FieldInfo{.key = "at",
                        .unit = "m",
                        .meaning = "centre in the object's frame",
                        .minimum = -1e3,
                        .maximum = 1e3,
                        .geometry = FieldGeometry::ownVector},
              self.at);
        visit(FieldInfo{.key = "angle_deg",
                        .unit = "rad",
                        .meaning = "angle in the object's frame, anticlockwise",
                        .minimum = -1e3,
                        .maximum = 1e3,
                        .geometry = FieldGeometry::turning},
              self.angle);
        if (self.form == ShapeForm::circle || self.form == ShapeForm::capsule) {
            visit(FieldInfo{.key = "radius",
                            .unit = "m",
                            .meaning = "radius of a circle or of the ends of a capsule",
                            .minimum = 0.005,
                            .maximum = 1e3},
                  self.radius);
        }
        if (self.form == ShapeForm::box || self.form == ShapeForm::capsule) {
            visit(FieldInfo{.key = "width",
                            .unit = "m",
                            .meaning = "width of a box; total length of a capsule",
                            .minimum = 0.01,
                            .maximum = 1e4},
                  self.width);
        }
        if (self.form == ShapeForm::box) {
            visit(FieldInfo{.key = "height",
                            .unit = "m",
                            .meaning = "height of a box",
                            .minimum = 0.01,
                            .maximum = 1e4},
                  self.height);
        }
        if (self.form == ShapeForm::polygon) {
            visit(FieldInfo{.key = "corners",
                            .unit = "m",
                            .meaning = "corners of a convex polygon, anticlockwise",
                            .minimum = -1e3,
                            .maximum = 1e3,
                            .geometry = FieldGeometry::ownOutline,
                            .least = 3,
                            .most = maximumCorners},
                  self.corners);
        }
    }
    friend bool operator==(ShapePiece const&, ShapePiece const&) = default;
};

/// One piece, or several rigidly connected pieces (a compound).
struct Shape {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Shape", "shape", "The shape of the object."};
    std::vector<ShapePiece> pieces;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "",
                        .meaning = "convex pieces",
                        .required = true,
                        .least = 1,
                        .most = maximumPieces},
              self.pieces);
    }
    friend bool operator==(Shape const&, Shape const&) = default;
};

[[nodiscard]] ShapePiece circlePiece(double radius, Vec2 at = {});
[[nodiscard]] ShapePiece boxPiece(double width, double height, Vec2 at = {}, double angle = 0);
[[nodiscard]] ShapePiece capsulePiece(double length, double radius, Vec2 at = {}, double angle = 0);
[[nodiscard]] ShapePiece polygonPiece(std::vector<Vec2> corners, Vec2 at = {}, double angle = 0);

/// Area of a piece in m².
[[nodiscard]] double areaOf(ShapePiece const& piece);
/// Area in m², pieces added up (overlaps count twice).
[[nodiscard]] double areaOf(Shape const& shape);

} // namespace trembler
