// A part is flattened for a moment when it is put down.
#include "game/ui/play/view/squash_view.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

TEST(SquashView, MovesForAMomentWhenAPartIsPlaced) {
    Session session(gameData().registry, gameData().parts,
                    loadLevel(gameData().registry, levelsFolder() / "first/1-first-contact.json"));
    SquashView squash;
    squash.look(session, 0.01, true);
    EXPECT_FALSE(squash.moving());
    auto const number = session.place({"steel bar", {-1.8, 1.5}, 0, ""});
    ASSERT_TRUE(number);
    squash.look(session, 0.01, true);
    ASSERT_TRUE(squash.moving());
    EXPECT_EQ(squash.objects(session), session.objectsOf(*number));
    render::Flattening const how = squash.flattening(session);
    EXPECT_LT(how.y, 0.95) << "flat";
    EXPECT_GT(how.x, 1.02) << "and wide";
    EXPECT_NEAR(how.about.x, -1.8, 0.01);
    EXPECT_LT(how.about.y, 1.5) << "it stands on its lower edge";
    squash.look(session, SquashView::life + 0.01, true);
    EXPECT_FALSE(squash.moving());
    ASSERT_TRUE(session.move(*number, {-1.6, 1.5}, 0));
    squash.look(session, 0.01, true);
    EXPECT_TRUE(squash.moving()) << "also when it is moved";
    session.start();
    squash.look(session, 0.01, true);
    EXPECT_FALSE(squash.moving());
}

TEST(SquashView, IsOffWithReducedMotion) {
    Player player;
    auto const flatter = [&](bool reduced) {
        player.app().context().profile.setSettings({.volume = 0, .reducedMotion = reduced});
        player.open(levelsFolder() / "first/1-first-contact.json");
        player.play().session().putAllBack();
        player.drag(player.item("part steel bar"), player.at({-1.8, 1.5}));
        render::Image const soon = player.look("squash-720");
        player.frames(60);
        return !(soon == player.look("squash-later-720"));
    };
    EXPECT_TRUE(flatter(false));
    EXPECT_FALSE(flatter(true));
}

} // namespace
} // namespace trembler::ui::test
