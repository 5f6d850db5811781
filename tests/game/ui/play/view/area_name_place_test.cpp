// The name of an area is written where it covers no object.
#include "game/ui/play/view/area_name_place.hpp"
#include "render/scene/facts/pick.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace trembler::ui::test {
namespace area_name_place_test {
namespace {

using render::Extent;

Extent around(Point lower, Point upper) {
    Extent extent;
    extent.add(lower);
    extent.add(upper);
    return extent;
}

bool coversAny(Point at, Point half, std::vector<Extent> const& objects) {
    Extent const name = around(at - half, at + half);
    return std::any_of(objects.begin(), objects.end(),
                       [&](Extent const& object) { return object.overlaps(name); });
}

TEST(AreaNamePlace, IsAboveTheMiddleUnlessAnObjectLiesThere) {
    render::Camera camera;
    camera.viewport = {800, 600};
    camera.pixelsPerMetre = 100;
    Extent const area = around({-1, -0.5}, {1, 0.5});
    Point const size{40, 20};
    Point const free = areaNamePlace(camera, area, size, {});
    EXPECT_DOUBLE_EQ(free.x, 0);
    EXPECT_DOUBLE_EQ(free.y, 0.6);
    std::vector<Extent> const boxes{around({-0.1, 0.5}, {0.1, 0.7}), around({-0.6, 0.55}, {-0.4, 0.75})};
    Point const beside = areaNamePlace(camera, area, size, boxes);
    EXPECT_FALSE(coversAny(beside, {0.2, 0.1}, boxes));
    EXPECT_DOUBLE_EQ(beside.y, 0.6);
}

TEST(AreaNamePlace, IsInsideTheView) {
    render::Camera camera;
    camera.viewport = {800, 600};
    camera.pixelsPerMetre = 100;
    Point const at = areaNamePlace(camera, around({-1, 1}, {1, 2.95}), {40, 20}, {});
    EXPECT_DOUBLE_EQ(at.y, 2.85);
}

// "the surface" was printed over the boxes.
TEST(AreaNamePlace, CoversNoBoxOfTheRaft) {
    for (render::Size const size : {render::Size{800, 600}, {1280, 720}, {2560, 1440}}) {
        Player player(size);
        player.open(levelsFolder() / "experiments/4-raft.json");
        std::vector<Extent> const objects = render::extentsOf(player.session().world());
        render::Camera const& camera = player.play().camera();
        Point const words{70, 18}; // about that of "the surface"
        Point const half = (0.5 / camera.pixelsPerMetre) * words;
        Extent const area = around({-2.5, 0}, {2.5, 0.5});
        if (size.width == 800) { // in larger windows the name covers less of the world
            EXPECT_TRUE(coversAny({0, 0.5 + half.y}, half, objects)) << "above the middle, where it was";
        }
        EXPECT_FALSE(coversAny(areaNamePlace(camera, area, words, objects), half, objects));
        player.look("raft-area-" + std::to_string(size.width));
    }
}

TEST(AreaNamePlace, IsUnderNoCard) {
    render::Camera camera;
    camera.viewport = {800, 600};
    camera.pixelsPerMetre = 100;
    Placed const card{"card", {{300, 200}, {500, 280}}};
    Point const at = areaNamePlace(camera, around({-1, -0.5}, {1, 0.5}), {40, 20}, {}, {&card, 1});
    Point const pixel = camera.toScreen(at);
    EXPECT_FALSE(card.rect.overlaps({pixel - Point{20, 10}, pixel + Point{20, 10}}));
}

// A post stands on the area, which is narrower than its name; in larger windows the letters cover less.
TEST(AreaNamePlace, IsBesideAPostThatStandsOnTheArea) {
    for (render::Size const size : {render::Size{800, 600}, {1280, 720}, {2560, 1440}}) {
        Player player(size);
        player.open(levelsFolder() / "5-everything/3-the-quiet-gate.json");
        player.frames(10);
        render::Camera const& camera = player.play().camera();
        Point const words = static_cast<double>(window().uiScale()) * Point{76, 18}; // about "the road bed"
        Point const half = (0.5 / camera.pixelsPerMetre) * words;
        std::vector<Extent> const mast{around({1.5, 0}, {1.6, 2.6})};
        Extent const area = around({1.3, -0.3}, {1.9, 0.2});
        std::vector<Extent> const objects = render::extentsOf(player.session().world());
        EXPECT_TRUE(coversAny({1.6, area.upper.y + half.y}, half, mast)) << "above the middle, where it was";
        EXPECT_FALSE(coversAny(areaNamePlace(camera, area, words, objects), half, mast)) << size.width;
        player.look("road-bed-" + std::to_string(size.width));
    }
}

// "the basket" lay over the hole in the table through which the ball gets into it.
TEST(AreaNamePlace, LeavesTheWayIntoTheAreaFree) {
    Player player;
    player.open(levelsFolder() / "3-magnets/3-too-fast-for-the-hole.json");
    player.frames(10);
    render::Camera const& camera = player.play().camera();
    Point const half = (0.5 / camera.pixelsPerMetre) * Point{62, 18}; // about "the basket"
    Extent const area = around({0.57, 0.75}, {1.23, 1.22});
    std::vector<Extent> const hole{around({0.72, 1.23}, {1.08, 1.3})};
    EXPECT_TRUE(coversAny({0.9, area.upper.y + half.y}, half, hole)) << "above the middle, where it was";
    Point const at = areaNamePlace(camera, area, Point{62, 18}, render::extentsOf(player.session().world()));
    EXPECT_FALSE(coversAny(at, half, hole)) << at.x << ", " << at.y;
    player.look("basket");
}

} // namespace
} // namespace area_name_place_test
} // namespace trembler::ui::test
