// One shape of an object's drawing.
#pragma once

#include "runtime/property/description.hpp"

#include <array>
#include <string>
#include <vector>

namespace trembler {

enum class DrawnForm : int { box, circle, ring, capsule, polygon, line, arc };
template <>
inline constexpr std::array<std::string_view, 7> choiceNames<DrawnForm>{
    "box", "circle", "ring", "capsule", "polygon", "line", "arc"};

/// The surface of an area; `own` is that of the object's body, the later ones those of materials.
enum class DrawnPattern : int {
    plain,
    own,
    steel,
    iron,
    copper,
    wood,
    glass,
    rubber,
    stone,
    plastic,
    brick,
    water,
    gold
};
template <>
inline constexpr std::array<std::string_view, 13> choiceNames<DrawnPattern>{
    "plain",  "own",   "steel",   "iron",  "copper", "wood", "glass",
    "rubber", "stone", "plastic", "brick", "water",  "gold"};

enum class DrawnShading : int {
    usual, ///< areas in two tones, lines even
    flat,  ///< one even colour
    round  ///< lines as tubes
};
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<DrawnShading>{"usual", "flat", "round"};

/// In which states of the object a shape is drawn.
enum class DrawnWhen : int {
    always,
    on,       ///< part of a working circuit; a coil: its magnet acts
    off,      ///< the opposite of `on`
    conducts, ///< it is a conductor at present
    insulates ///< it is no conductor at present
};
template <>
inline constexpr std::array<std::string_view, 5> choiceNames<DrawnWhen>{"always", "on", "off", "conducts",
                                                                        "insulates"};

/// Areas (box, circle, capsule, polygon) are filled; rings, lines and arcs have a thickness. Which of the
/// measures are used depends on the form; files state only these. All forms but polygon and line are their
/// own mirror images at angle 0.
struct DrawnShape {
    DrawnForm form = DrawnForm::box;
    Vec2 at;                   ///< m, in the object's frame
    double angle = 0;          ///< rad
    double width = 0.2;        ///< m: box; capsule: whole length along its x axis
    double height = 0.2;       ///< m: box
    double corner = 0;         ///< m: box, radius of its corners
    double radius = 0.1;       ///< m: circle, capsule; ring and arc: of the middle of their line
    double thickness = 0.02;   ///< m: ring, line, arc
    double sweep = pi;         ///< rad: arc; its middle is above its centre
    std::vector<Vec2> corners; ///< m: polygon, 3 to 64, either way round, need not be convex
    std::vector<Vec2> points;  ///< m: line, 2 to 64
    bool curved = false;       ///< line: a smooth curve through its points
    std::string colour;        ///< see colourInDrawing(); empty: that of the pattern
    double opacity = 1;
    DrawnPattern pattern = DrawnPattern::plain; ///< of areas
    DrawnShading shading = DrawnShading::usual;
    double outline = -1;       ///< pixels at UI scale 1; -1: one pixel for areas, none for lines
    std::string outlineColour; ///< empty: ink with a touch of the colour
    double raised = 0;         ///< apparent height above its background, which its shadow shows; a body has 1
    DrawnWhen when = DrawnWhen::always;
    double glow = 0;         ///< m, reach of a light around it
    std::string glowColour;  ///< empty: that of a live wire
    bool joined = false;     ///< one outline with the area before it
    std::int32_t repeat = 1; ///< number of copies
    Vec2 step;               ///< m, from one copy to the next
    Vec2 about;              ///< m, in the object's frame: the point about which copies are turned
    double turn = 0;         ///< rad, from one copy to the next; without a step, 0: a full circle / repeat

    static constexpr std::size_t mostCorners = 64;

    /// Whether it is filled, and not a line.
    [[nodiscard]] bool isArea() const {
        return form == DrawnForm::box || form == DrawnForm::circle || form == DrawnForm::capsule ||
               form == DrawnForm::polygon;
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        constexpr double far = 100;
        auto const metres = [&](std::string_view key, std::string_view meaning, double least, auto& field) {
            visit(FieldInfo{.key = key, .unit = "m", .meaning = meaning, .minimum = least, .maximum = far},
                  field);
        };
        auto const place = [&](std::string_view key, std::string_view meaning, auto& field) {
            visit(FieldInfo{.key = key,
                            .unit = "m",
                            .meaning = meaning,
                            .minimum = -far,
                            .maximum = far,
                            .geometry = FieldGeometry::ownVector},
                  field);
        };
        auto const places = [&](std::string_view key, std::string_view meaning, std::size_t least,
                                auto& field) {
            visit(FieldInfo{.key = key,
                            .unit = "m",
                            .meaning = meaning,
                            .minimum = -far,
                            .maximum = far,
                            .geometry = FieldGeometry::ownVector,
                            .least = least,
                            .most = mostCorners},
                  field);
        };
        auto const angle = [&](std::string_view key, std::string_view meaning, auto& field) {
            visit(FieldInfo{.key = key,
                            .unit = "rad",
                            .meaning = meaning,
                            .minimum = -1e3,
                            .maximum = 1e3,
                            .geometry = FieldGeometry::turning},
                  field);
        };
        auto const plain = [&](std::string_view key, std::string_view meaning, auto& field) {
            visit(FieldInfo{.key = key, .unit = "", .meaning = meaning}, field);
        };
        visit(FieldInfo{.key = "form", .unit = "", .meaning = "kind of shape", .required = true}, self.form);
        place("at", "centre in the object's frame", self.at);
        angle("angle_deg", "angle in the object's frame, anticlockwise", self.angle);
        switch (self.form) {
        case DrawnForm::box:
            metres("width", "of the box", 1e-3, self.width);
            metres("height", "of the box", 1e-3, self.height);
            metres("corner", "radius of the box's corners", 0, self.corner);
            break;
        case DrawnForm::capsule:
            metres("width", "total length of the capsule", 1e-3, self.width);
            metres("radius", "of the capsule's ends", 1e-3, self.radius);
            break;
        case DrawnForm::circle:
            metres("radius", "of the circle", 1e-3, self.radius);
            break;
        case DrawnForm::ring:
        case DrawnForm::arc:
            metres("radius", "of the middle of the line", 1e-3, self.radius);
            metres("thickness", "of the line", 1e-3, self.thickness);
            if (self.form == DrawnForm::arc) {
                visit(FieldInfo{.key = "sweep_deg",
                                .unit = "rad",
                                .meaning = "of the arc, whose middle is above its centre",
                                .minimum = 0,
                                .maximum = 2 * pi,
                                .minimumExcluded = true,
                                .geometry = FieldGeometry::invariant},
                      self.sweep);
            }
            break;
        case DrawnForm::polygon:
            places("corners", "3 to 64 corners of the polygon, which need not be convex", 3, self.corners);
            break;
        case DrawnForm::line:
            places("points", "2 to 64 points of the line", 2, self.points);
            metres("thickness", "of the line", 1e-3, self.thickness);
            plain("curved", "whether the line is a smooth curve through its points", self.curved);
            break;
        }
        plain("colour", "#rrggbb, #rrggbbaa or a name of the palette; left out: the pattern's own",
              self.colour);
        visit(
            FieldInfo{
                .key = "opacity", .unit = "", .meaning = "1: not translucent", .minimum = 0, .maximum = 1},
            self.opacity);
        if (self.isArea()) {
            plain("pattern", "pattern of the surface; own: that of the object's body", self.pattern);
        }
        plain("shading", "usual: areas in two tones, lines even; flat: even; round: lines as tubes",
              self.shading);
        visit(FieldInfo{.key = "outline",
                        .unit = "",
                        .meaning =
                            "width of the outline in pixels, inside the edge; -1: 1 of areas, 0 of lines",
                        .minimum = -1,
                        .maximum = 20},
              self.outline);
        plain("outline_colour", "of the outline; left out: ink with a touch of the colour",
              self.outlineColour);
        visit(FieldInfo{.key = "raised",
                        .unit = "",
                        .meaning =
                            "how far the shape seems to stand above what it lies on; 0: no shadow, 1: as a "
                            "body",
                        .minimum = 0,
                        .maximum = 3},
              self.raised);
        plain("when", "the states in which the shape is drawn; on: part of a working circuit", self.when);
        metres("glow", "reach of a light around the shape", 0, self.glow);
        plain("glow_colour", "of the light; left out: that of a live wire", self.glowColour);
        if (self.isArea()) {
            plain("joined", "whether it has one outline with the area before it", self.joined);
        }
        visit(FieldInfo{.key = "repeat",
                        .unit = "",
                        .meaning = "number of copies, itself included",
                        .minimum = 1,
                        .maximum = 100},
              self.repeat);
        place("step", "from one copy to the next", self.step);
        place("about", "point that copies are turned about, in the object's frame", self.about);
        angle("turn_deg", "from one copy to the next; 0, and no step: a full circle divided by their number",
              self.turn);
    }
    friend bool operator==(DrawnShape const&, DrawnShape const&) = default;
};

} // namespace trembler
