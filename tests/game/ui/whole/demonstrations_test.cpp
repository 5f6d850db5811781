// Demonstrations: goals reached without the player are no success, only the task is.
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace demonstrations_test {
namespace {

auto const gallery = dataFolder() / "gallery";
auto const withTask = gallery / "9-shown/1-task.json";
auto const without = gallery / "9-shown/2-no-task.json";

void dragBall(Player& player, Vec2 by) {
    World const& world = player.session().world();
    Vec2 const at = world.find<Position>(world.store().find("ball"))->value;
    player.moveTo(player.at(at));
    player.press();
    player.frames(20);
    for (int i = 1; i <= 20; ++i) {
        player.moveTo(player.at(at + by * (i / 20.0)));
    }
    player.frames(40);
    player.release();
    player.frames(20);
}

TEST(Demonstrations, AreNotCelebratedIfTheyGoByThemselves) {
    Player player({1280, 720}, {}, gallery);
    player.open(without);
    player.key(SDLK_SPACE);
    player.simulate(180);
    ASSERT_TRUE(player.session().solved()) << "it does work";
    player.frames(3);
    EXPECT_FALSE(player.showsCard("success"));
    EXPECT_FALSE(player.app().context().profile.solved("9-shown/2-no-task.json"));
}

TEST(Demonstrations, HaveATaskThatThePlayerFulfils) {
    Player player({1280, 720}, {}, gallery);
    player.open(withTask);
    ASSERT_EQ(player.session().judge().status().size(), 1U);
    EXPECT_EQ(player.session().judge().status()[0].text, "Move the ball to the right");
    player.key(SDLK_SPACE);
    player.simulate(180);
    EXPECT_FALSE(player.session().solved()) << "the task, not what it does by itself";
    EXPECT_FALSE(player.showsCard("success"));
    player.look("demonstration-task-720");
    dragBall(player, {1.6, 0.6});
    ASSERT_TRUE(player.session().solved());
    player.frames(4);
    ASSERT_TRUE(player.showsCard("success"));
    EXPECT_TRUE(player.app().context().profile.solved("9-shown/1-task.json"));
    player.look("demonstration-done-720");
    player.clickItem("next level");
    player.frames(2);
    ASSERT_EQ(player.play().file().filename(), "2-no-task.json");
}

TEST(Demonstrations, TheLastOneLeadsBackToTheGallery) {
    auto const folder = testFolder() / "levels";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "9-shown");
    std::filesystem::copy(gallery / "9-shown/chapter.json", folder / "9-shown/chapter.json");
    std::filesystem::copy(withTask, folder / "9-shown/1-task.json");
    Player player({1280, 720}, {}, folder);
    player.open(folder / "9-shown/1-task.json");
    player.key(SDLK_SPACE);
    player.simulate(60);
    dragBall(player, {1.6, 0.6});
    ASSERT_TRUE(player.session().solved());
    player.frames(4);
    player.clickItem("next level");
    player.frames(3);
    EXPECT_EQ(player.app().menu().page(), MenuPage::gallery);
    player.look("gallery-720");
}

} // namespace
} // namespace demonstrations_test
} // namespace trembler::ui::test
