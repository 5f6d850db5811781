// Cut wires fall and fade, the scissors are put away, and keys without a use at present cause a message.
#include "game/ui/play/view/cut_view.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace cut_view_test {
namespace {

TEST(CutView, FadesAway) {
    CutView cuts;
    cuts.add({{0, 0}, {0.5, -0.1}, {1, 0}});
    cuts.add({});
    EXPECT_TRUE(cuts.moving());
    cuts.pass(0.5 * CutView::life);
    EXPECT_TRUE(cuts.moving());
    cuts.pass(0.6 * CutView::life);
    EXPECT_FALSE(cuts.moving());
}

TEST(Scissors, ArePutAwayAfterACutUnlessShiftIsHeld) {
    Player player;
    player.open(dataFolder() / "wires.json");
    player.key(SDLK_SPACE);
    player.simulate(4);
    player.key(SDLK_p);
    World const& world = player.session().world();
    auto const middle = [&] {
        render::FactsReader const reader(world);
        ObjectId const a = world.store().find("lamp");
        ObjectId const b = world.store().find("minus");
        auto const path =
            render::cablePath(reader.of(a), render::poseOf(world, a), reader.of(b), render::poseOf(world, b));
        Point const at = path[path.size() / 2];
        return player.at({at.x, at.y});
    }();
    player.key(SDLK_x);
    ASSERT_TRUE(player.play().hand().cutting());
    player.moveTo(middle);
    player.click(middle);
    EXPECT_FALSE(player.play().hand().cutting());
    player.look("cut-wire-720");
}

TEST(KeysThatMeanNothingNow, SaySo) {
    Player player;
    player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
    auto const told = [&](SDL_Keycode key) {
        auto const before = player.app().context().toasts.count();
        player.key(key);
        return player.app().context().toasts.count() > before;
    };
    EXPECT_TRUE(told(SDLK_p));
    EXPECT_TRUE(told(SDLK_x));
    EXPECT_TRUE(told(SDLK_TAB));
    EXPECT_FALSE(told(SDLK_1));
    player.key(SDLK_SPACE);
    EXPECT_FALSE(told(SDLK_p));
}

} // namespace
} // namespace cut_view_test
} // namespace trembler::ui::test
