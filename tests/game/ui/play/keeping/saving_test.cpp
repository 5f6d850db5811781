// A run that is saved as a solution file.
#include "game/ui/play/keeping/saving.hpp"
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

TEST(Saving, OnlyARunIsSaved) {
    auto const folder = testFolder() / "saved";
    std::filesystem::remove_all(folder);
    SavedSolutions const saved(folder);
    render::Toasts toasts;
    Session session(
        gameData().registry, gameData().parts,
        loadLevel(gameData().registry, levelsFolder() / "experiments/1-switched-electromagnet.json"));
    saveSolution(session, "magnet", saved, toasts);
    EXPECT_EQ(toasts.count(), 1U) << "a message that the level has to run first";
    EXPECT_FALSE(std::filesystem::exists(folder));
    for (int i = 0; i < 120; ++i) {
        session.step();
    }
    saveSolution(session, "magnet", saved, toasts);
    EXPECT_EQ(toasts.count(), 2U);
    ASSERT_EQ(saved.of("magnet").size(), 1U);
    EXPECT_TRUE(saved.of("another").empty());
    auto const file = saved.of("magnet").front().file;
    Solution const solution = findOrLoadSolution(gameData().registry, session.level(), file.string());
    EXPECT_EQ(solution.frames, 120);
    EXPECT_TRUE(solution.solves);
}

} // namespace
} // namespace trembler::ui::test
