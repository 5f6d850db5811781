// Objects that are dragged keep their edges and corners on the grid, with real input events.
#include "tests/game/ui/edit/editor_kit.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui::test {
namespace dragging_test {
namespace {

char const* const room = R"({"version": 2, "title": "Room",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "floor", "at": [0, -0.15], "properties": {"material": "stone", "fixed": true,
         "shape": [{"form": "box", "width": 7.6, "height": 0.3}]}}]})";

bool onGrid(double value, double step = 0.05) {
    return std::abs(value - std::round(value / step) * step) < 1e-7;
}

class Dragging : public testing::Test {
protected:
    Dragging() { designer.editText(room); }
    void drag(Vec2 from, Vec2 to) { designer.drag(designer.on(from), designer.on(to)); }
    /// The right upper square knob, while Shift is held or not.
    void dragCorner(Vec2 by, bool shift) {
        designer.frames(2);
        auto const handles = handlesOf(designer.parts());
        ASSERT_TRUE(handles);
        ASSERT_EQ(handles->scaling.size(), 8U);
        unsigned const modifiers = shift ? KMOD_LSHIFT : KMOD_NONE;
        render::pushKey(window(), SDLK_LSHIFT, shift, modifiers);
        drag(handles->scaling[2], handles->scaling[2] + by);
        render::pushKey(window(), SDLK_LSHIFT, false, KMOD_NONE);
        designer.frame();
    }

    Designer designer;
};

TEST_F(Dragging, ABoxOnTheFloorStaysOnIt) {
    designer.key(SDLK_b);
    drag({0, 0}, {0.3, 0.95});
    designer.key(SDLK_s);
    ASSERT_EQ(designer.placeOf("box"), (Vec2{0.15, 0.475}));
    drag({0.15, 0.5}, {0.97, 0.51});
    EXPECT_EQ(designer.placeOf("box").y, 0.475) << "its lower edge is on the floor";
    EXPECT_TRUE(onGrid(designer.placeOf("box").x - 0.15));
    EXPECT_GT(designer.placeOf("box").x, 0.8);
    drag({1, 0.5}, {1.01, 1.52});
    EXPECT_TRUE(onGrid(designer.placeOf("box").y - 0.475));
}

TEST_F(Dragging, AGroupKeepsItsOffsets) {
    designer.key(SDLK_b);
    drag({0, 0}, {0.1, 0.95});
    drag({1, 0}, {1.1, 0.95});
    drag({0.1, 0}, {1, 0.05});
    designer.key(SDLK_s);
    std::vector<Vec2> before;
    for (char const* const name : {"box", "box 2", "box 3"}) {
        before.push_back(designer.placeOf(name));
    }
    designer.parts().selection.set({"box", "box 2", "box 3"});
    designer.ctrl(SDLK_g);
    drag({0.05, 0.5}, {-1.23, 0.51});
    std::size_t i = 0;
    for (char const* const name : {"box", "box 2", "box 3"}) {
        Vec2 const by = designer.placeOf(name) - before[i++];
        EXPECT_NEAR(by.x, -1.3, 0.051) << name;
        EXPECT_TRUE(onGrid(by.x)) << name;
        EXPECT_EQ(by.y, 0) << name;
    }
}

TEST_F(Dragging, APolygonKeepsItsCornersOnTheGrid) {
    designer.key(SDLK_p);
    for (Vec2 const corner : {Vec2{0, 0}, Vec2{0.7, 0}, Vec2{0.2, 0.55}, Vec2{0, 0}}) {
        designer.click(designer.on(corner));
    }
    designer.key(SDLK_s);
    drag({0.25, 0.2}, {1.31, 0.77});
    Vec2 const at = designer.placeOf("polygon");
    auto const& corners = designer.tree()["objects"].back()["properties"]["shape"][0]["corners"];
    ASSERT_EQ(corners.size(), 3U);
    for (auto const& corner : corners) {
        EXPECT_TRUE(onGrid(at.x + corner[0].get<double>())) << at.x + corner[0].get<double>();
        EXPECT_TRUE(onGrid(at.y + corner[1].get<double>())) << at.y + corner[1].get<double>();
    }
    EXPECT_GT(at.x, 1);
}

TEST_F(Dragging, AKnobAtACornerTakesBothEdgesToTheGrid) {
    designer.key(SDLK_b);
    drag({0.5, 0.25}, {1.5, 0.75});
    designer.key(SDLK_s);
    dragCorner({0.29, 0.09}, false);
    auto const& shape = designer.tree()["objects"].back()["properties"]["shape"][0];
    Vec2 const half{shape["width"].get<double>() / 2, shape["height"].get<double>() / 2};
    Vec2 const at = designer.placeOf("box");
    EXPECT_NEAR(at.x + half.x, 1.8, 1e-8);
    EXPECT_NEAR(at.y + half.y, 0.85, 1e-8);
    EXPECT_NEAR(at.x - half.x, 0.5, 1e-8) << "the corner on the other side stays";
    EXPECT_NEAR(at.y - half.y, 0.25, 1e-8);
}

TEST_F(Dragging, WithShiftAKnobKeepsTheProportionsAndTakesAnEdgeToTheGrid) {
    designer.key(SDLK_b);
    drag({0, 0}, {0.3, 0.95});
    designer.key(SDLK_s);
    dragCorner({0.113, 0.37}, true);
    auto const& shape = designer.tree()["objects"].back()["properties"]["shape"][0];
    double const width = shape["width"].get<double>();
    double const height = shape["height"].get<double>();
    EXPECT_NEAR(width / height, 0.3 / 0.95, 1e-6) << "in both directions alike";
    Vec2 const at = designer.placeOf("box");
    EXPECT_NEAR(at.x - width / 2, 0, 1e-8);
    EXPECT_NEAR(at.y - height / 2, 0, 1e-8);
    EXPECT_TRUE(onGrid(at.x + width / 2) || onGrid(at.y + height / 2));
    EXPECT_GT(height, 1.1);
}

TEST_F(Dragging, ACornerOfAPolygonIsDraggedToTheGrid) {
    designer.key(SDLK_p);
    for (Vec2 const corner : {Vec2{0, 0.5}, Vec2{1, 0.5}, Vec2{1, 1}, Vec2{0, 1}, Vec2{0, 0.5}}) {
        designer.click(designer.on(corner));
    }
    designer.key(SDLK_s);
    designer.frames(2);
    ASSERT_EQ(shapeCorners(designer.parts()).size(), 4U);
    std::size_t const before = designer.parts().document.done();
    drag({1, 1}, {0.52, 0.71});
    designer.frames(2);
    std::vector<Vec2> const corners = shapeCorners(designer.parts());
    ASSERT_EQ(corners.size(), 4U) << "it is concave now, and in pieces";
    EXPECT_GT(designer.tree()["objects"].back()["properties"]["shape"].size(), 1U);
    EXPECT_EQ(std::count_if(corners.begin(), corners.end(),
                            [](Vec2 at) {
                                return length(at - Vec2{0.5, 0.7}) < 1e-8;
                            }),
              1);
    EXPECT_EQ(designer.parts().document.done(), before + 1) << "one step of undo";
    designer.look("edit-corners-dragged");
    designer.ctrl(SDLK_z);
    designer.frames(2);
    EXPECT_EQ(designer.tree()["objects"].back()["properties"]["shape"].size(), 1U);
    auto const toasts = designer.app().context().toasts.count();
    drag({1, 1}, {-0.5, 0.75}); // across the other edge
    for (Vec2 const corner : shapeCorners(designer.parts())) {
        EXPECT_GE(corner.x, -1e-8) << "the edges would cross";
    }
    EXPECT_GT(designer.app().context().toasts.count(), toasts) << "and the designer is told";
}

} // namespace
} // namespace dragging_test
} // namespace trembler::ui::test
