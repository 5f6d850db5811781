// A picture of an object, drawn by the author of the part: shapes in the object's own frame. No component
// reads it, so it does not affect the simulation.
#pragma once

#include "physics/drawn_shape.hpp"
#include "runtime/property/coverage.hpp"

namespace trembler {

class Registry;

struct Drawing {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Drawing", "drawing",
        "A picture of the object, made of simple shapes. It has no other consequences. An object that states "
        "another shape than its part does not take its part's drawing.",
        PropertyPlace::properties, "shape"};
    static constexpr Coverage coverage = leftOut("no component reads it; parts may get new drawings");

    bool body = true;       ///< whether the plain body lies under the shapes; if not, only its shadow
    bool marks = false;     ///< whether the marks that follow from other properties are drawn, too
    std::int32_t layer = 0; ///< objects of higher layers lie on those of lower ones
    std::vector<DrawnShape> shapes;

    static constexpr std::size_t mostShapes = 200;
    static constexpr std::int32_t mostCopies = 1000; ///< of all shapes together

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "body",
                        .unit = "",
                        .meaning =
                            "whether the object's plain body is drawn under the shapes; its shadow is in any "
                            "case"},
              self.body);
        visit(FieldInfo{.key = "marks",
                        .unit = "",
                        .meaning =
                            "whether windings, poles, signs and the like, which follow from the object's "
                            "other properties, are drawn under the shapes"},
              self.marks);
        visit(
            FieldInfo{
                .key = "layer",
                .unit = "",
                .meaning =
                    "objects of higher layers are drawn over those of lower ones; that of objects without a "
                    "drawing is 0. Within one, moving objects are drawn over fixed ones",
                .minimum = -10,
                .maximum = 10},
            self.layer);
        visit(FieldInfo{.key = "shapes",
                        .unit = "",
                        .meaning = "what is drawn, from bottom to top; at most 200 shapes",
                        .required = true,
                        .least = 1,
                        .most = mostShapes},
              self.shapes);
    }
    friend bool operator==(Drawing const&, Drawing const&) = default;
};

/// Registers the property, with the rule that it can be drawn.
void registerDrawing(Registry& registry);

} // namespace trembler
