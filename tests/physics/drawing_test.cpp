// The values that a drawing may contain: limits, colours, and clear messages for everything else.
#include "physics/drawing.hpp"
#include "physics/drawing_palette.hpp"
#include "physics/register_physics.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/read/read_part.hpp"
#include "runtime/world/registry.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

namespace trembler {
namespace {

Registry const& drawingRegistry() {
    static Registry const* const registry = [] {
        auto* const made = new Registry;
        registerEverything(*made);
        return made;
    }();
    return *registry;
}

std::unique_ptr<World> worldWith(std::string const& drawing) {
    std::string const text = R"({"version": 2, "title": "t", "objects": [{"name": "a", "at": [0, 0],
        "properties": {"shape": [{"form": "box", "width": 1, "height": 1}])" +
                             (drawing.empty() ? drawing : R"(, "drawing": )" + drawing) + "}}]}";
    LevelFile const level = readLevel(drawingRegistry(), JsonDocument::parse(text, "level.json"));
    return buildWorld(drawingRegistry(), level, {});
}

std::string complaint(std::string const& drawing) {
    try {
        (void)worldWith(drawing);
    } catch (InputError const& bad) {
        return bad.what();
    }
    return "";
}

std::string complaintOfShapes(std::string const& shapes) {
    return complaint(R"({"shapes": [)" + shapes + "]}");
}

TEST(Drawing, IsReadWithAllOfItsForms) {
    auto const world = worldWith(R"({"body": false, "shapes": [
        {"form": "box", "width": 0.5, "height": 0.1, "corner": 0.02, "colour": "dark_wood", "pattern": "wood"},
        {"form": "circle", "radius": 0.1, "joined": true, "repeat": 8, "about": [0, 0.1]},
        {"form": "ring", "radius": 0.2, "thickness": 0.05, "colour": "#12345678"},
        {"form": "capsule", "width": 0.4, "radius": 0.1, "when": "on", "glow": 0.2, "glow_colour": "red"},
        {"form": "polygon", "corners": [[0, 0], [1, 0], [0.2, 0.2], [0, 1]]},
        {"form": "line", "points": [[0, 0], [1, 1]], "curved": true, "shading": "round"},
        {"form": "arc", "radius": 0.1, "sweep_deg": 90, "angle_deg": 45, "repeat": 3, "step": [0.1, 0]}]})");
    Drawing const* const drawing = world->find<Drawing>(world->store().find("a"));
    ASSERT_NE(drawing, nullptr);
    EXPECT_FALSE(drawing->body);
    ASSERT_EQ(drawing->shapes.size(), 7U);
    EXPECT_EQ(drawing->shapes[1].repeat, 8);
    EXPECT_EQ(drawing->shapes[1].about, (Vec2{0, 0.1}));
    EXPECT_EQ(drawing->shapes[3].when, DrawnWhen::on);
    EXPECT_NEAR(drawing->shapes[6].sweep, pi / 2, 1e-12);
}

TEST(Drawing, ChangesNoStateHash) {
    auto const drawn = worldWith(R"({"shapes": [{"form": "circle"}]})");
    auto const other = worldWith(R"({"body": false, "shapes": [{"form": "box"}, {"form": "ring"}]})");
    auto const none = worldWith("");
    EXPECT_EQ(drawn->stateHash(), other->stateHash());
    EXPECT_EQ(drawn->stateHash(), none->stateHash());
}

TEST(Drawing, SaysWhichShapeIsWrongAndWhatWasExpected) {
    auto const expectWords = [](std::string const& message, std::vector<std::string> const& words) {
        for (std::string const& word : words) {
            EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' in: " << message;
        }
    };
    expectWords(complaintOfShapes(""), {"0 shapes", "1 to 200"});
    expectWords(complaintOfShapes(R"({"form": "circle"}, {"form": "box", "colour": "stel"})"),
                {"shape 2", "a box", "stel", "did you mean 'steel'", "#rrggbb"});
    expectWords(complaintOfShapes(R"({"form": "ring", "glow_colour": "#12345"})"), {"glow_colour", "#12345"});
    expectWords(complaintOfShapes(R"({"form": "polygon", "corners": [[0, 0], [1, 0]]})"),
                {"2 corners", "3 to 64"});
    expectWords(complaintOfShapes(R"({"form": "polygon", "corners": [[0, 0], [1, 0], [2, 0]]})"),
                {"no area"});
    expectWords(complaintOfShapes(R"({"form": "line", "points": [[0, 0]]})"), {"1 points", "2 to 64"});
    expectWords(complaintOfShapes(R"({"form": "capsule", "width": 0.1, "radius": 0.1})"), {"0.2 m"});
    expectWords(complaintOfShapes(R"({"form": "box", "joined": true})"), {"joined", "before"});
    expectWords(complaintOfShapes(R"({"form": "ring"}, {"form": "box", "joined": true})"),
                {"shape 2", "joined"});
    expectWords(complaintOfShapes(R"({"form": "box", "radius": 1})"), {"unknown key 'radius'"});
    expectWords(complaintOfShapes(R"({"form": "star"})"), {"star", "polygon"});
    expectWords(complaintOfShapes(R"({"form": "circle", "repeat": 101})"), {"repeat", "100"});
    expectWords(complaintOfShapes(R"({"form": "circle", "radius": -1})"), {"radius", "0.001"});
}

TEST(Drawing, HasAtMostTwoHundredShapesAndAThousandCopies) {
    auto const many = [](int count, int repeat) {
        std::string text;
        for (int i = 0; i < count; ++i) {
            text += fmt::format(R"({}{{"form": "circle", "repeat": {}}})", i == 0 ? "" : ", ", repeat);
        }
        return text;
    };
    EXPECT_EQ(complaintOfShapes(many(200, 5)), "");
    EXPECT_NE(complaintOfShapes(many(201, 1)).find("201 entries; expected at most 200"), std::string::npos);
    EXPECT_NE(complaintOfShapes(many(11, 100)).find("1100"), std::string::npos);
}

TEST(Drawing, OfAPartIsNotTakenByAnObjectOfAnotherShape) {
    PartLibrary parts;
    parts.add(readPart(drawingRegistry(), JsonDocument::parse(R"({"name": "box", "properties": {
        "shape": [{"form": "box", "width": 1, "height": 1}], "drawing": {"shapes": [{"form": "circle"}]}}})",
                                                              "box.json")));
    LevelFile const level =
        readLevel(drawingRegistry(), JsonDocument::parse(R"({"version": 2, "title": "t", "objects": [
        {"name": "same", "part": "box", "at": [0, 0], "properties": {"friction": 0.1}},
        {"name": "other", "part": "box", "at": [3, 0], "properties": {"shape": [{"form": "circle", "radius": 1}]}},
        {"name": "own", "part": "box", "at": [6, 0], "properties": {
            "shape": [{"form": "circle", "radius": 1}], "drawing": {"shapes": [{"form": "ring"}]}}}]})",
                                                         "level.json"));
    auto const world = buildWorld(drawingRegistry(), level, parts);
    auto const drawingOf = [&](char const* name) { return world->find<Drawing>(world->store().find(name)); };
    EXPECT_NE(drawingOf("same"), nullptr);
    EXPECT_EQ(drawingOf("other"), nullptr);
    ASSERT_NE(drawingOf("own"), nullptr);
    EXPECT_EQ(drawingOf("own")->shapes[0].form, DrawnForm::ring);
}

TEST(DrawingPalette, HasNamesThatAreUniqueAndReadBack) {
    std::set<std::string_view> names;
    for (NamedColour const& colour : drawingPalette) {
        EXPECT_TRUE(names.insert(colour.name).second) << colour.name;
        EXPECT_EQ(colourInDrawing(colour.name), colour.rgba);
    }
    EXPECT_EQ(colourInDrawing("#102030"), 0x102030FFU);
    EXPECT_EQ(colourInDrawing("#10203040"), 0x10203040U);
    for (std::string_view const bad : {"", "#", "#1234567", "#12345g", "#-12345", "red ", "Red", "102030"}) {
        EXPECT_FALSE(colourInDrawing(bad).has_value()) << bad;
    }
}

} // namespace
} // namespace trembler
