// The player's view of the world by itself: where it ends, and when it stays as it is.
#include "game/ui/shared/camera_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace trembler::ui::test {
namespace camera_control_test {
namespace {

using render::Point;

render::Extent scene() {
    render::Extent extent;
    extent.add(Point{-4, -0.5});
    extent.add(Point{4, 3.5});
    return extent;
}

CameraControl fittedControl() {
    CameraControl control;
    control.setSubject(scene());
    control.setLimits(scene());
    control.setView({1280, 720}, {16, 140, 268, 80});
    return control;
}

TEST(CameraControl, KeepsItsMiddleInTheLimitsWhateverThePlayerDoes) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        CameraControl control = fittedControl();
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(-1, 1);
        control.startPan();
        for (int i = 0; i < 200; ++i) {
            switch (random() % 3) {
            case 0:
                control.drag({3000 * share(random), 3000 * share(random)});
                break;
            case 1:
                control.look({share(random), share(random)});
                break;
            default:
                control.zoom({1280 * std::abs(share(random)), 720 * std::abs(share(random))},
                             12 * share(random));
            }
            Point const middle = control.camera().toWorld(control.middle());
            ASSERT_TRUE(scene().widened(1e-6).contains(middle))
                << middle.x << ", " << middle.y << " after act " << i << " of seed " << seed;
        }
    }
}

TEST(CameraControl, MovesFreelyInTheLimits) {
    CameraControl control = fittedControl();
    Point const before = control.camera().centre;
    control.startPan();
    control.drag({100, -50});
    double const scale = control.camera().pixelsPerMetre;
    EXPECT_NEAR(control.camera().centre.x, before.x - 100 / scale, 1e-9);
    EXPECT_NEAR(control.camera().centre.y, before.y - 50 / scale, 1e-9);
    control.drag({-100, 50});
    EXPECT_NEAR(control.camera().centre.x, before.x, 1e-9);
}

TEST(CameraControl, HasNoEndWithoutLimits) {
    CameraControl control = fittedControl();
    control.setLimits({});
    control.startPan();
    control.drag({9000, 0});
    EXPECT_LT(control.camera().centre.x, -50);
}

TEST(CameraControl, HoldsUntilTheWindowHasAnotherSize) {
    CameraControl control = fittedControl();
    render::Camera const before = control.camera();
    control.hold();
    control.setView({1280, 720}, {400, 140, 268, 80});
    render::Camera other = before;
    other.pixelsPerMetre = 10;
    control.setPreferred(other);
    EXPECT_EQ(control.camera().centre, before.centre);
    EXPECT_EQ(control.camera().pixelsPerMetre, before.pixelsPerMetre);
    control.fit();
    EXPECT_EQ(control.camera().pixelsPerMetre, 10) << "the player asked for it";
    control.setView({1920, 1080}, {16, 140, 268, 80});
    EXPECT_GT(control.camera().pixelsPerMetre, before.pixelsPerMetre);
}

TEST(CameraControl, ShowsTheSamePartOfTheWorldInALargerWindowIfThePlayerHasMovedIt) {
    CameraControl control = fittedControl();
    control.zoom({640, 360}, 4);
    render::Camera const before = control.camera();
    control.setView({2560, 1440}, {32, 280, 536, 160});
    EXPECT_EQ(control.camera().centre, before.centre);
    EXPECT_NEAR(control.camera().pixelsPerMetre, 2 * before.pixelsPerMetre, 1e-9);
}

} // namespace
} // namespace camera_control_test
} // namespace trembler::ui::test
