// Buttons are pressed by clicks on them.
#include "render/panels/buttons.hpp"
#include "tests/render/panels/panels.hpp"

namespace trembler::render::test {
namespace {

TEST_F(Panels, AClickWithinOneFrameClicks) {
    Bench bench;
    int clicks = 0;
    auto const draw = [&] { bench.show([&] { clicks += bigButton("Start") ? 1 : 0; }); };
    frame(draw);
    frame(draw);
    pushMouseMove(window(), bench.at());
    frame(draw);
    pushClick(window(), bench.at());
    frame(draw);
    frame(draw);
    frame(draw);
    EXPECT_EQ(clicks, 1);
    // A click beside the button is ignored by panels and left to the world.
    pushClick(window(), {900, 600});
    frame(draw);
    frame(draw);
    EXPECT_EQ(clicks, 1);
    EXPECT_FALSE(gui_->wantsMouse());
}

TEST_F(Panels, ADisabledButtonCannotBeClicked) {
    Bench bench;
    int clicks = 0;
    auto const draw = [&] { bench.show([&] { clicks += bigButton("Start", {.enabled = false}) ? 1 : 0; }); };
    frame(draw);
    frame(draw);
    pushClick(window(), bench.at());
    frame(draw);
    frame(draw);
    EXPECT_EQ(clicks, 0);
}

} // namespace
} // namespace trembler::render::test
