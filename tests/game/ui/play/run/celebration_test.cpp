// A run's success: reported once, celebrated until the player has seen it.
#include "game/ui/play/run/celebration.hpp"
#include "tests/game/ui/play/run/controlled_run.hpp"

namespace trembler::ui::test {
namespace {

TEST(Celebrations, BeginOncePerRunAndEndWhenSeen) {
    Controlled level;
    Celebration celebration;
    int begun = 0;
    std::uint64_t solvedIn = 0;
    level.run.runOrStop();
    for (int i = 0; i < 150; ++i) {
        level.pictures(1);
        if (celebration.noteStep(level.session)) {
            ++begun;
            solvedIn = level.frame();
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
    EXPECT_FALSE(celebration.noteStep(level.session)) << "this run's success has already been reported";
    celebration.reset();
    EXPECT_FALSE(celebration.solvedAt());
}

} // namespace
} // namespace trembler::ui::test
