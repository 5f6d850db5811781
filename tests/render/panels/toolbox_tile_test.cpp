// A part is taken from its tile.
#include "render/panels/toolbox_tile.hpp"
#include "tests/render/panels/panels.hpp"

namespace trembler::render::test {
namespace {

TEST_F(Panels, ATileIsTakenWhenTheMouseGoesDown) {
    Bench bench;
    int taken = 0;
    int count = 1;
    auto const draw = [&] {
        bench.show(
            [&] { taken += toolboxTile({.id = "bar", .name = "Steel bar", .count = count}).taken ? 1 : 0; });
    };
    frame(draw);
    frame(draw);
    pushMouseMove(window(), bench.at());
    frame(draw);
    pushMouseButton(window(), MouseButton::Left, true, bench.at());
    frame(draw);
    EXPECT_EQ(taken, 1);
    pushMouseButton(window(), MouseButton::Left, false, bench.at());
    frame(draw);
    count = 0;
    pushClick(window(), bench.at());
    frame(draw);
    frame(draw);
    EXPECT_EQ(taken, 1);
}

} // namespace
} // namespace trembler::render::test
