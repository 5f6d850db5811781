// The rectangles around shapes of drawings, compared with the pixels that are painted.
#include "render/scene/facts/drawn_copies.hpp"
#include "render/scene/facts/facts.hpp"
#include "render/scene/objects/drawing.hpp"
#include "tests/render/stage.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace trembler::render::test {
namespace {

constexpr Size paintedSheet{240, 240};

/// The rectangle around all pixels that differ from the background, in metres, at 100 pixels for each.
Extent paintedExtent(DrawnShape const& shape, Pose const& pose) {
    Drawing drawing;
    drawing.shapes = {shape};
    Facts facts;
    facts.drawing = &drawing;
    Image const image =
        picture(paintedSheet, rgb(0xFFFFFF), [&](Canvas& canvas) { drawShapes(canvas, facts, pose, {}); },
                {.shadows = false});
    Extent around;
    for (int y = 0; y < paintedSheet.height; ++y) {
        for (int x = 0; x < paintedSheet.width; ++x) {
            if (image.at(x, y)[1] < 128) {
                double const left = 0.01 * (x - 0.5 * paintedSheet.width);
                double const top = 0.01 * (0.5 * paintedSheet.height - y);
                around.add(Point{left, top - 0.01});
                around.add(Point{left + 0.01, top});
            }
        }
    }
    return around;
}

DrawnShape blackShape(DrawnForm form) {
    DrawnShape shape;
    shape.form = form;
    shape.colour = "#000000";
    shape.shading = DrawnShading::flat;
    shape.outline = 0;
    shape.width = 1.1;
    shape.height = 0.3;
    shape.radius = form == DrawnForm::capsule ? 0.15 : 0.5;
    shape.thickness = 0.1;
    shape.sweep = 2.0;
    shape.corners = {{-0.4, -0.2}, {0.7, -0.1}, {0.1, 0.6}};
    shape.points = {{-0.6, -0.3}, {0.1, 0.4}, {0.5, 0.3}};
    return shape;
}

TEST(DrawnCopies, LieInExactlyTheRectangleThatIsPainted) {
    for (DrawnForm const form : {DrawnForm::box, DrawnForm::circle, DrawnForm::ring, DrawnForm::capsule,
                                 DrawnForm::polygon, DrawnForm::line, DrawnForm::arc}) {
        for (double const angle : {0.0, 0.7, 2.0, -1.3, 4.4}) {
            DrawnShape const shape = blackShape(form);
            Pose const pose{{0.1, -0.15}, angle};
            SCOPED_TRACE(std::string(choiceNames<DrawnForm>[static_cast<std::size_t>(form)]) + " at " +
                         std::to_string(angle));
            Extent const painted = paintedExtent(shape, pose);
            Extent const stated = extentOf(shape, pose);
            // Ends of lines and arcs are cut square: the rectangle may be larger by half of their thickness.
            double const spare = shape.isArea() ? 0.015 : 0.015 + 0.5 * shape.thickness;
            ASSERT_FALSE(painted.empty());
            EXPECT_LE(stated.lower.x, painted.lower.x + 0.015);
            EXPECT_LE(stated.lower.y, painted.lower.y + 0.015);
            EXPECT_GE(stated.upper.x, painted.upper.x - 0.015);
            EXPECT_GE(stated.upper.y, painted.upper.y - 0.015);
            EXPECT_GE(stated.lower.x, painted.lower.x - spare);
            EXPECT_GE(stated.lower.y, painted.lower.y - spare);
            EXPECT_LE(stated.upper.x, painted.upper.x + spare);
            EXPECT_LE(stated.upper.y, painted.upper.y + spare);
        }
    }
}

} // namespace
} // namespace trembler::render::test
