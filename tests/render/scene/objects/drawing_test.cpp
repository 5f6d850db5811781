// Pictures of objects that are drawn from data: the right colours in the right places.
#include "physics/drawing_palette.hpp"
#include "render/scene/facts/drawn_copies.hpp"
#include "render/scene/facts/pick.hpp"
#include "render/scene/objects/body.hpp"
#include "render/scene/objects/drawing.hpp"
#include "render/scene/objects/part.hpp"
#include "runtime/level/property/move_property.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/render/scene/scene_stage.hpp"

#include <cmath>

namespace trembler::render::test {
namespace {

constexpr Size sheet{240, 160};

// 100 pixels per metre, the origin in the middle.
Pixel at(Image const& image, double x, double y) {
    return image.at(static_cast<int>(std::lround(120 + 100 * x)),
                    static_cast<int>(std::lround(80 - 100 * y)));
}

void expectColour(Pixel pixel, Colour colour, char const* what) {
    EXPECT_NEAR(pixel[0], colour.red, 3) << what;
    EXPECT_NEAR(pixel[1], colour.green, 3) << what;
    EXPECT_NEAR(pixel[2], colour.blue, 3) << what;
}

DrawnShape flatShape(DrawnForm form, std::string colour) {
    DrawnShape shape;
    shape.form = form;
    shape.colour = std::move(colour);
    shape.shading = DrawnShading::flat;
    shape.outline = 0;
    return shape;
}

DrawnShape flatCircle(std::string colour, Vec2 place, double radius) {
    DrawnShape shape = flatShape(DrawnForm::circle, std::move(colour));
    shape.at = place;
    shape.radius = radius;
    return shape;
}

struct Drawn {
    Shape body{{boxPiece(1.2, 0.8)}};
    Drawing drawing;
    Facts facts;

    explicit Drawn(std::vector<DrawnShape> shapes) {
        drawing.body = false;
        drawing.shapes = std::move(shapes);
        facts.shape = &body;
        facts.drawing = &drawing;
        facts.substance = Substance::plastic;
    }
    Drawn(Drawn const&) = delete;
    Drawn& operator=(Drawn const&) = delete;

    [[nodiscard]] Image picture(Pose const& pose = {}, Marks const& marks = {}) const {
        return test::picture(sheet, palette::paper,
                             [&](Canvas& canvas) { drawObject(canvas, facts, pose, marks); },
                             {.shadows = false});
    }
};

constexpr Colour red = rgb(0xFF0000);
constexpr Colour blue = rgb(0x0000FF);
constexpr Colour lime = rgb(0x00FF00);

TEST(DrawnObject, ShowsItsShapesInTheirOrderInsteadOfTheBody) {
    DrawnShape box = flatShape(DrawnForm::box, "#0000ff");
    box.width = 0.8;
    box.height = 0.4;
    Drawn const part({box, flatCircle("#ff0000", {0.3, 0}, 0.1)});
    Image const image = part.picture();
    expectColour(at(image, -0.2, 0), blue, "the box");
    expectColour(at(image, 0.3, 0), red, "the disc on the box");
    expectColour(at(image, 0.55, 0.35), palette::paper, "the hidden body");
}

TEST(DrawnObject, KeepsItsBodyUnlessTheDrawingHidesIt) {
    Drawn part({flatCircle("#ff0000", {0.3, 0}, 0.1)});
    part.drawing.body = true;
    Image const image = part.picture();
    expectColour(at(image, 0.3, 0), red, "the disc");
    EXPECT_NE(at(image, -0.3, 0), part.picture({{5, 5}, 0}).at(0, 0)) << "the body";
}

TEST(DrawnObject, TurnsAndMovesWithTheObject) {
    Drawn const part({flatCircle("#ff0000", {0.4, 0}, 0.1)});
    Image const image = part.picture({{-0.2, 0.1}, 0.5 * pi});
    expectColour(at(image, -0.2, 0.5), red, "turned by a quarter");
    expectColour(at(image, 0.2, 0.1), palette::paper, "where it was");
}

TEST(DrawnObject, RepeatsAShapeAboutAPointOrInSteps) {
    DrawnShape spokes = flatCircle("#ff0000", {0.4, 0}, 0.06);
    spokes.repeat = 4;
    DrawnShape row = flatCircle("#0000ff", {-0.6, -0.6}, 0.06);
    row.repeat = 3;
    row.step = {0.3, 0};
    Drawn const part({spokes, row});
    Image const image = part.picture();
    for (Point const place : {Point{0.4, 0}, Point{0, 0.4}, Point{-0.4, 0}, Point{0, -0.4}}) {
        expectColour(at(image, place.x, place.y), red, "a spoke");
    }
    for (double const x : {-0.6, -0.3, 0.0}) {
        expectColour(at(image, x, -0.6), blue, "a step");
    }
    expectColour(at(image, 0.3, -0.6), palette::paper, "no fourth one");
}

TEST(DrawnObject, JoinsShapesIntoOneSilhouette) {
    DrawnShape disc = flatCircle("#0000ff", {0, 0}, 0.3);
    disc.outline = 4;
    disc.outlineColour = "#ff0000";
    DrawnShape handle = flatShape(DrawnForm::box, "#0000ff");
    handle.at = {0.4, 0};
    handle.width = 0.6;
    handle.height = 0.2;
    handle.outline = 4;
    handle.outlineColour = "#ff0000";
    Drawn part({disc, handle});
    expectColour(at(part.picture(), 0.12, 0), red, "the end of the handle on the disc");
    part.drawing.shapes[1].joined = true;
    Image const image = part.picture();
    expectColour(at(image, 0.12, 0), blue, "no line inside");
    expectColour(at(image, 0.28, 0), blue, "no line inside");
    expectColour(at(image, -0.28, 0), red, "the common outline");
    expectColour(at(image, 0.68, 0), red, "the common outline");
}

TEST(DrawnObject, FollowsTheStateOfTheObject) {
    DrawnShape on = flatCircle("#ff0000", {-0.3, 0}, 0.1);
    on.when = DrawnWhen::on;
    on.glow = 0.2;
    DrawnShape off = flatCircle("#0000ff", {-0.3, 0}, 0.1);
    off.when = DrawnWhen::off;
    DrawnShape whole = flatCircle("#00ff00", {0.3, 0}, 0.1);
    whole.when = DrawnWhen::conducts;
    Drawn part({on, off, whole});
    part.facts.device = true;
    Image const dark = part.picture();
    expectColour(at(dark, -0.3, 0), blue, "off");
    expectColour(at(dark, -0.3, 0.15), palette::paper, "no light");
    expectColour(at(dark, 0.3, 0), palette::paper, "it insulates");
    part.facts.on = true;
    part.facts.conductor = true;
    Image const lit = part.picture();
    expectColour(at(lit, -0.3, 0), red, "on");
    EXPECT_LT(at(lit, -0.3, 0.15)[2], palette::paper.blue - 20) << "a yellow light";
    expectColour(at(lit, 0.3, 0), lime, "it conducts");
}

TEST(DrawnObject, ShowsLinesRingsAndArcs) {
    DrawnShape line = flatShape(DrawnForm::line, "#ff0000");
    line.points = {{-0.8, -0.3}, {-0.4, 0.5}, {0, -0.3}};
    line.thickness = 0.06;
    DrawnShape ring = flatShape(DrawnForm::ring, "#0000ff");
    ring.at = {0.5, 0.3};
    ring.radius = 0.2;
    ring.thickness = 0.06;
    DrawnShape arc = flatShape(DrawnForm::arc, "#00ff00");
    arc.at = {0.5, -0.4};
    arc.radius = 0.2;
    arc.thickness = 0.06;
    Drawn const part({line, ring, arc});
    Image const image = part.picture();
    expectColour(at(image, -0.6, 0.1), red, "the line");
    expectColour(at(image, 0.7, 0.3), blue, "the ring");
    expectColour(at(image, 0.5, 0.3), palette::paper, "its middle");
    expectColour(at(image, 0.5, -0.2), lime, "the arc's middle is above");
    expectColour(at(image, 0.5, -0.6), palette::paper, "half a circle");
}

TEST(DrawnObject, IsMirroredWithItsObject) {
    DrawnShape hook = flatShape(DrawnForm::polygon, "#ff0000");
    hook.corners = {{0, -0.3}, {0.5, -0.3}, {0.5, 0.3}, {0.35, 0.3}, {0.35, -0.15}, {0, -0.15}};
    DrawnShape arc = flatShape(DrawnForm::arc, "#0000ff");
    arc.at = {-0.6, 0};
    arc.angle = 0.5 * pi; // open to the right
    arc.radius = 0.2;
    arc.thickness = 0.06;
    Drawing const stated{.body = false, .marks = false, .shapes = {hook, arc}};
    ValueOf<Drawing> value(stated);
    moveProperty(value, {}, true);
    Drawn part({});
    part.drawing = value.value;
    Image const image = part.picture();
    expectColour(at(image, -0.42, 0.2), red, "the hook's end");
    expectColour(at(image, 0.42, 0.2), palette::paper, "where it was");
    expectColour(at(image, 0.8, 0), blue, "the arc");
    expectColour(at(image, 0.4, 0), palette::paper, "it is open to the left");
    moveProperty(value, {}, true);
    EXPECT_EQ(value.value, stated) << "mirrored twice";
}

TEST(DrawnObject, HasNoMarksUnlessTheyAreAskedFor) {
    Drawn part({flatCircle("#ff0000", {0.5, 0.3}, 0.05)});
    part.drawing.body = true;
    Image const plain = part.picture();
    part.facts.device = true;
    EXPECT_TRUE(part.picture() == plain) << "no sign of a device";
    part.drawing.marks = true;
    EXPECT_FALSE(part.picture() == plain);
}

TEST(DrawnObject, ShowsWhereItMayNotBePlacedAndThatItIsSelected) {
    DrawnShape box = flatShape(DrawnForm::box, "#0000ff");
    box.width = 1.2;
    box.height = 0.8;
    Drawn const part({box});
    Image const usual = part.picture();
    EXPECT_FALSE(part.picture({}, {.forbidden = true}) == usual);
    EXPECT_FALSE(part.picture({}, {.ghost = true}) == usual);
    Image const selected = part.picture({}, {.selected = true});
    EXPECT_NE(at(selected, 0.63, 0), at(usual, 0.63, 0)) << "the ring around the body";
    expectColour(at(selected, 0, 0), blue, "the drawing");
}

TEST(DrawnObject, IsSeenByItsDrawingEvenWithoutABody) {
    Drawn part({flatCircle("#ff0000", {0.9, 0}, 0.1)});
    part.facts.shape = nullptr;
    Position const position{{0, 0}};
    part.facts.position = &position;
    EXPECT_TRUE(part.facts.visible());
    expectColour(at(part.picture(), 0.9, 0), red, "the disc");
    EXPECT_TRUE(pictureExtentOf(part.facts, {}).contains({0.99, 0}));
}

TEST(DrawnPart, ShowsAllPiecesAndJointsBeforeItIsInAWorld) {
    PartLibrary parts;
    parts.add(readPart(everything(), JsonDocument::parse(R"({"name": "pair", "main": "left", "objects": [
        {"name": "left", "at": [-0.6, 0.3], "properties": {"shape": [{"form": "circle", "radius": 0.1}],
         "drawing": {"shapes": [{"form": "circle", "radius": 0.1, "colour": "#ff0000", "shading": "flat", "outline": 0}]}}},
        {"name": "right", "at": [0.6, -0.3], "properties": {"shape": [{"form": "circle", "radius": 0.1}],
         "drawing": {"shapes": [{"form": "circle", "radius": 0.1, "colour": "#0000ff", "shading": "flat", "outline": 0}]}}}],
        "joints": [{"name": "tie", "form": "distance", "a": "left", "b": "right", "at": [-0.6, 0.3],
                    "at_b": [0.6, -0.3]}]})",
                                                         "pair.json")));
    auto const pictureOf = [&](Placement const& placement) {
        return picture(sheet, palette::paper, [&](Canvas& canvas) { drawPart(canvas, parts, placement); },
                       {.shadows = false});
    };
    Image const image = pictureOf({"pair", {}, 0, ""});
    expectColour(at(image, -0.6, 0.36), red, "the left one");
    expectColour(at(image, 0.6, -0.36), blue, "the right one");
    EXPECT_NE(at(image, 0, 0), at(image, 0, 0.5)) << "the rod between them";
    Placement const flipped{"pair", {0, 0.1}, 0, "", true};
    Image const mirrored = pictureOf(flipped);
    expectColour(at(mirrored, 0.6, 0.46), red, "the left one");
    expectColour(at(mirrored, -0.6, -0.26), blue, "the right one");
    EXPECT_NE(at(mirrored, 0, 0.1), at(mirrored, 0, 0.6)) << "the rod between them";
    Extent const extent = extentOfPart(parts, flipped);
    EXPECT_NEAR(extent.lower.x, -0.7, 1e-9);
    EXPECT_NEAR(extent.upper.y, 0.5, 1e-9);
    EXPECT_TRUE(extentOfPart(parts, {"nothing", {}, 0, ""}).empty());
}

TEST(DrawnPart, ShowsTheCablesBetweenItsPieces) {
    auto const partWith = [](std::string const& joint) {
        PartLibrary parts;
        parts.add(readPart(everything(), JsonDocument::parse(R"({"name": "cable", "main": "left", "objects": [
            {"name": "left", "at": [-0.6, 0.3], "properties": {"conductor": true, "material": "copper",
             "shape": [{"form": "circle", "radius": 0.1}]}},
            {"name": "right", "at": [0.6, 0.3], "properties": {"conductor": true, "material": "copper",
             "shape": [{"form": "circle", "radius": 0.1}]}}],
            "joints": [)" + joint + R"(], "connections": [["left", "right"]]})",
                                                             "cable.json")));
        return parts;
    };
    auto const pictureOf = [&](PartLibrary const& parts) {
        return picture(sheet, palette::paper,
                       [&](Canvas& canvas) {
                           drawPart(canvas, parts, {"cable", {}, 0, ""});
                       },
                       {.shadows = false});
    };
    PartLibrary const rope =
        partWith(R"({"form": "rope", "a": "left", "b": "right", "at": [-0.6, 0.3], "at_b": [0.6, 0.3],
                     "length": 1.5, "look": "none"})");
    // The lowest point of the cable is at x = 0, as it is symmetric; its height follows from the picture.
    Extent const extent = extentOfPart(rope, {"cable", {}, 0, ""});
    EXPECT_LT(extent.lower.y, 0.2) << "it hangs below both pieces";
    EXPECT_GT(extent.lower.y, -0.1);
    EXPECT_NEAR(extent.lower.x, -0.7, 1e-9);
    Image const image = pictureOf(rope);
    Image const blank = picture(sheet, palette::paper, [](Canvas&) {}, {.shadows = false});
    EXPECT_NE(at(image, 0, extent.lower.y), at(blank, 0, extent.lower.y)) << "the cable";
    EXPECT_EQ(at(image, 0, 0.3), at(blank, 0, 0.3)) << "no rope";
    Extent const tile = extentOnTile(rope, {"cable", {}, 0, ""});
    EXPECT_LT(tile.lower.y, extent.lower.y) << "on a tile it has its whole length";
    EXPECT_NE(at(picture(sheet, palette::paper,
                         [&](Canvas& canvas) {
                             drawPartOnTile(canvas, rope, {"cable", {}, 0, ""});
                         },
                         {.shadows = false}),
                 0, tile.lower.y),
              at(blank, 0, tile.lower.y));
    // As in a world, the cable runs inside a joint that is not drawn and holds the pieces together.
    PartLibrary const weld =
        partWith(R"({"form": "weld", "a": "left", "b": "right", "at": [0, 0.3], "look": "none"})");
    EXPECT_NEAR(extentOfPart(weld, {"cable", {}, 0, ""}).lower.y, 0.2, 1e-9);
    EXPECT_EQ(at(pictureOf(weld), 0, extent.lower.y), at(blank, 0, extent.lower.y));
}

TEST(DrawnCopies, OfACurveRunThroughTheStatedPoints) {
    DrawnShape line;
    line.form = DrawnForm::line;
    line.points = {{0, 0}, {1, 1}, {2, 0}, {2, 0}, {3, 0.5}};
    EXPECT_EQ(pathOf(line).size(), 5U);
    line.curved = true;
    std::vector<Point> const path = pathOf(line);
    for (Vec2 const stated : line.points) {
        double nearest = 1;
        for (Point const point : path) {
            EXPECT_TRUE(finite(point));
            nearest = std::min(nearest, length(point - Point{stated.x, stated.y}));
        }
        EXPECT_LT(nearest, 1e-9);
    }
}

TEST(DrawingPalette, AgreesWithTheColoursOfPatternsAndMeanings) {
    auto const same = [](char const* name, Colour colour) {
        auto const found = colourInDrawing(name);
        ASSERT_TRUE(found.has_value()) << name;
        EXPECT_EQ(rgb(*found >> 8U), (Colour{colour.red, colour.green, colour.blue, 255})) << name;
        EXPECT_EQ(*found & 0xFFU, colour.alpha) << name;
    };
    same("ink", palette::ink);
    same("soft_ink", palette::inkSoft);
    same("paper", palette::paper);
    same("white", palette::paperLight);
    same("cream", palette::paperShade);
    same("steel", palette::steel);
    same("copper", palette::copper);
    same("wood", palette::wood);
    same("dark", palette::rubber);
    same("grey", palette::stone);
    same("plastic", palette::plastic);
    same("glass", palette::glass);
    same("water", palette::water);
    same("red", palette::northPole);
    same("blue", palette::southPole);
    same("yellow", palette::live);
    same("glow", palette::liveCore);
    same("green", palette::goal);
    same("rust", palette::warning);
    same("purple", palette::force);
    same("olive", palette::sound);
}

} // namespace
} // namespace trembler::render::test
