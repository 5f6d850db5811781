// A run's success: reported once, celebrated until the player has seen it.
#include "game/ui/cards/celebration.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

TEST(Celebrations, BeginOncePerRunAndEndWhenSeen) {
    Session session(gameData().registry, gameData().parts,
                    loadLevel(gameData().registry, levelsFolder() / "first/1-first-contact.json"));
    session.load(session.level().solutions.front());
    Celebration celebration;
    int begun = 0;
    std::uint64_t solvedIn = 0;
    for (int i = 0; i < 600; ++i) {
        session.step();
        if (celebration.noteStep(session)) {
            ++begun;
            solvedIn = session.world().frame();
        }
    }
    ASSERT_EQ(begun, 1);
    ASSERT_TRUE(celebration.solvedAt());
    EXPECT_NEAR(*celebration.solvedAt(), static_cast<double>(solvedIn) / 60, 1e-9);
    EXPECT_TRUE(celebration.showing());
    celebration.pass(0.25);
    celebration.pass(0.5);
    EXPECT_DOUBLE_EQ(celebration.age(), 0.75);
    celebration.dismiss();
    celebration.pass(1);
    EXPECT_FALSE(celebration.showing());
    EXPECT_FALSE(celebration.noteStep(session)) << "this run's success has already been reported";
    celebration.reset();
    EXPECT_FALSE(celebration.solvedAt());
}

TEST(Celebrations, AreForWhatThePlayerDid) {
    Session session(
        gameData().registry, gameData().parts,
        loadLevel(gameData().registry, levelsFolder() / "experiments/1-switched-electromagnet.json"));
    Celebration celebration;
    for (int i = 0; i < 180; ++i) {
        session.step();
        EXPECT_FALSE(celebration.noteStep(session));
    }
    EXPECT_TRUE(session.solved()) << "by itself";
    EXPECT_FALSE(byPlayer(session));
}

} // namespace
} // namespace trembler::ui::test
