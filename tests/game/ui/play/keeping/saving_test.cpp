// A run that is saved as a solution file.
#include "game/ui/play/keeping/saving.hpp"
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"

#include <fstream>

namespace trembler::ui::test {
namespace {

TEST(Saving, OnlyARunIsSaved) {
    auto const folder = testFolder() / "saved";
    std::filesystem::remove_all(folder);
    SavedSolutions const saved(folder);
    render::Toasts toasts;
    PendingWrites pending(toasts);
    Session session(
        gameData().registry, gameData().parts,
        loadLevel(gameData().registry, levelsFolder() / "experiments/1-switched-electromagnet.json"));
    saveSolution(session, "magnet", saved, toasts, pending);
    EXPECT_EQ(toasts.count(), 1U) << "a message that the level has to run first";
    EXPECT_FALSE(std::filesystem::exists(folder));
    for (int i = 0; i < 120; ++i) {
        session.step();
    }
    saveSolution(session, "magnet", saved, toasts, pending);
    EXPECT_EQ(toasts.count(), 2U);
    ASSERT_EQ(saved.of("magnet").size(), 1U);
    EXPECT_TRUE(saved.of("another").empty());
    auto const file = saved.of("magnet").front().file;
    Solution const solution = findOrLoadSolution(gameData().registry, session.level(), file.string());
    EXPECT_EQ(solution.frames, 120);
    EXPECT_TRUE(solution.solves);
    EXPECT_EQ(toasts.newest(), "Saved as \"my solution 1\": see Solutions in the menu.");
    // Where nothing can be written, it is kept and written later.
    std::filesystem::remove_all(folder);
    std::ofstream(folder) << "not a folder";
    saveSolution(session, "magnet", saved, toasts, pending);
    EXPECT_NE(toasts.newest().find("The solution cannot be saved"), std::string::npos) << toasts.newest();
    for (int i = 0; i < 10; ++i) {
        session.step();
    }
    std::filesystem::remove(folder);
    pending.pass(PendingWrites::patience);
    ASSERT_EQ(saved.of("magnet").size(), 1U);
    auto const later =
        findOrLoadSolution(gameData().registry, session.level(), saved.of("magnet").front().file.string());
    EXPECT_EQ(later.frames, 120) << "as it was when the player asked";
}

TEST(Saving, ADamagedSolutionIsMovedAside) {
    auto const folder = testFolder() / "saved";
    std::filesystem::remove_all(folder);
    SavedSolutions saved(folder);
    Solution solution;
    solution.name = "first";
    auto const file = saved.save("magnet", solution);
    SavedSolutions::rename(saved.of("magnet").front(), "second");
    EXPECT_TRUE(saved.takeDamaged().empty());
    std::ofstream(file) << "{\"na";
    ASSERT_EQ(saved.of("magnet").size(), 1U);
    EXPECT_EQ(saved.of("magnet").front().name, "first") << "the last good one";
    ASSERT_EQ(saved.takeDamaged().size(), 1U);
    EXPECT_EQ(std::filesystem::file_size(file.string() + ".damaged-1"), 4U);
    SavedSolutions::remove(saved.of("magnet").front());
    EXPECT_TRUE(saved.of("magnet").empty());
}

} // namespace
} // namespace trembler::ui::test
