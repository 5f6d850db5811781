// The camera's transformations, and the grid for each zoom.
#include "render/draw/camera.hpp"
#include "render/draw/paper.hpp"
#include "render/draw/path.hpp"
#include "render/window/ui_scale.hpp"
#include "tests/render/stage.hpp"

#include <limits>
#include <random>

namespace trembler::render::test {
namespace {

TEST(CameraSums, RoundTripIsExactToAMillionthOfAPixel) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        Camera camera{
            {1000 * unit(random), 1000 * unit(random)}, std::pow(10, 3 * unit(random)), {1280, 720}};
        Point const screen{640 * (1 + unit(random)), 360 * (1 + unit(random))};
        Point const back = camera.toScreen(camera.toWorld(screen));
        EXPECT_NEAR(back.x, screen.x, 1e-6);
        EXPECT_NEAR(back.y, screen.y, 1e-6);
    }
}

TEST(CameraSums, UpInTheWorldIsUpOnTheScreen) {
    Camera const camera;
    EXPECT_LT(camera.toScreen({0, 1}).y, camera.toScreen({0, 0}).y);
    EXPECT_EQ(camera.toScreen(camera.centre), (Point{640, 360}));
}

TEST(CameraSums, ZoomKeepsThePointUnderTheCursor) {
    Camera camera{{3, -2}, 80, {1280, 720}};
    Point const cursor{200, 650};
    Point const under = camera.toWorld(cursor);
    for (double const factor : {1.1, 3.0, 0.2, 1e9, 1e-12}) {
        camera.zoomAt(cursor, factor);
        EXPECT_NEAR(camera.toWorld(cursor).x, under.x, 1e-6);
        EXPECT_NEAR(camera.toWorld(cursor).y, under.y, 1e-6);
        EXPECT_GE(camera.pixelsPerMetre, Camera::smallestScale);
        EXPECT_LE(camera.pixelsPerMetre, Camera::largestScale);
    }
    auto const before = camera;
    for (double const nonsense : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        camera.zoomAt(cursor, nonsense);
        EXPECT_EQ(camera.pixelsPerMetre, before.pixelsPerMetre);
        EXPECT_EQ(camera.centre, before.centre);
    }
}

TEST(CameraSums, PanMovesTheWorldWithTheCursor) {
    Camera camera;
    Point const grabbed = camera.toWorld({100, 100});
    camera.pan({50, -20});
    EXPECT_NEAR(camera.toScreen(grabbed).x, 150, 1e-9);
    EXPECT_NEAR(camera.toScreen(grabbed).y, 80, 1e-9);
}

TEST(CameraSums, FitShowsAll) {
    Camera camera;
    camera.fit({-10, -1}, {30, 2}, 40);
    EXPECT_NEAR(camera.toScreen({-10, 0}).x, 40, 1e-9);
    EXPECT_NEAR(camera.toScreen({30, 0}).x, 1240, 1e-9);
    auto const before = camera.centre;
    camera.fit({1, 1}, {1, 1}, 0);
    EXPECT_EQ(camera.centre, before);
}

TEST(Grid, LinesAreNeverCloserThanSevenPixelsAndNeverJump) {
    auto const strength = [](double scale, double spacing) {
        float most = 0.F;
        for (auto const& ruling : rulingsFor(scale, 1.F)) {
            // A line of this spacing is also drawn by every finer set that divides it.
            double const times = spacing / ruling.spacing;
            if (std::abs(times - std::round(times)) < 1e-9 && times > 0.5) {
                most = std::max(most, ruling.strength);
            }
        }
        return most;
    };
    double scale = 1;
    for (int step = 0; step < 3000; ++step, scale *= 1.003) {
        for (auto const& ruling : rulingsFor(scale, 1.F)) {
            EXPECT_GE(ruling.spacing * scale, 7 * (1 - 1e-12));
        }
        for (double const spacing : {0.01, 0.1, 1.0}) {
            EXPECT_NEAR(strength(scale, spacing), strength(scale * 1.003, spacing), 0.01) << scale;
        }
    }
}

TEST(Grid, LinesLieOnWholeMetresAndAreSharp) {
    Camera camera;
    camera.centre = {0.1234, 0.777};
    camera.pixelsPerMetre = 100.37;
    auto const image = picture(
        {400, 300}, palette::ink, [](Canvas& canvas) { canvas.paper(); }, {}, camera);
    camera.viewport = {400, 300};
    for (double const metre : {-1.0, 0.0, 1.0, 2.0}) {
        auto const x = static_cast<int>(std::floor(camera.toScreen({metre, 0}).x));
        // Away from crossings: the line's one or two candidate columns are darker than the pixels three
        // columns beside.
        int const y = static_cast<int>(camera.toScreen({0, 0.675}).y);
        int const darkest = std::min({image.at(x - 1, y)[2], image.at(x, y)[2], image.at(x + 1, y)[2]});
        EXPECT_LT(darkest + 15, image.at(x + 4, y)[2]) << metre;
    }
}

TEST(Paths, RunFromEndToEnd) {
    auto const wire = hangingWire({0, 1}, {2, 1}, 0.5, 20);
    EXPECT_EQ(wire.front(), (Point{0, 1}));
    EXPECT_EQ(wire.back(), (Point{2, 1}));
    EXPECT_NEAR(wire[10].y, 0.5, 1e-12);
    EXPECT_EQ(coil({0, 0}, {1, 0}, 0.1, 5).size(), 14U);
    std::vector<Point> const corner{{0, 0}, {1, 0}, {1, 1}};
    EXPECT_DOUBLE_EQ(pathLength(corner), 2);
    EXPECT_EQ(pointAlong(corner, 1.5), (Point{1, 0.5}));
    EXPECT_EQ(pointAlong(corner, 9), (Point{1, 1}));
    EXPECT_EQ(pointAlong(corner, -1), (Point{0, 0}));
    EXPECT_EQ(pointAlong({}, 1), (Point{0, 0}));
}

TEST(UiScale, GrowsWithTheWindow) {
    EXPECT_FLOAT_EQ(uiScaleFor({1280, 720}), 1.F);
    EXPECT_GT(uiScaleFor({3840, 2160}), 2.2F);
    EXPECT_LT(uiScaleFor({3840, 2160}), 3.F);
    EXPECT_FLOAT_EQ(uiScaleFor({1280, 720}, 1.35F), 1.35F);
    // Larger letters must not leave less room than the screens need.
    EXPECT_FLOAT_EQ(uiScaleFor({1280, 720}, 2.F), 1.6F);
    EXPECT_FLOAT_EQ(uiScaleFor({800, 600}, 1.6F), 1.F);
    EXPECT_FLOAT_EQ(uiScaleFor({800, 600}), 0.9F);
    EXPECT_FLOAT_EQ(uiScaleFor({320, 240}, 1.6F), 0.75F) << "a window that has no room anyway";
    EXPECT_GE(uiScaleFor({0, 0}), 0.375F);
}

} // namespace
} // namespace trembler::render::test
