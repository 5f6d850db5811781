// Saved solutions: how many of a level are listed.
#include "game/ui/shared/kept/saved_solutions.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <fstream>
#include <sys/stat.h>

namespace trembler::ui::test {
namespace {

TEST(SavedSolutionsList, HasAThousandAtMostAndLeavesTheRestInTheirFiles) {
    namespace fs = std::filesystem;
    fs::path const folder = testFolder() / "solutions";
    fs::remove_all(folder);
    SavedSolutions saved(folder);
    Solution solution;
    solution.name = "one of many";
    fs::path const first = saved.save("a level", solution);
    std::string const text = textOfFile(first);
    fs::path const place = first.parent_path();
    constexpr int files = 1004;
    for (int i = 2; i <= files; ++i) {
        std::ofstream(place / ("solution-" + std::to_string(i) + ".json")) << text;
    }
    std::vector<SavedSolution> const listed = saved.of("a level");
    EXPECT_EQ(listed.size(), 1000U);
    EXPECT_EQ(listed.front().file, first);
    EXPECT_EQ(listed.front().name, "one of many");
    for (int i = 0; i < 4; ++i) { // what is removed makes room
        SavedSolutions::remove(listed[static_cast<std::size_t>(i)]);
    }
    EXPECT_EQ(saved.of("a level").size(), 1000U);
    EXPECT_EQ(std::distance(fs::directory_iterator(place), {}), files - 4);
    fs::remove_all(folder);
}

TEST(SavedSolutionsList, NamesAFileThatCannotBeReadOnce) {
    namespace fs = std::filesystem;
    fs::path const folder = testFolder() / "unread-solutions";
    fs::remove_all(folder);
    SavedSolutions saved(folder);
    Solution solution;
    solution.name = "good";
    fs::path const pipe = saved.save("a level", solution).parent_path() / "solution-2.json";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    for (int i = 0; i < 3; ++i) { // a list is drawn again and again
        EXPECT_EQ(saved.of("a level").size(), 1U);
    }
    std::vector<InputError> const notRead = saved.takeNotRead();
    ASSERT_EQ(notRead.size(), 1U);
    EXPECT_NE(std::string(notRead.front().what()).find(pipe.string() + ": is no ordinary file"),
              std::string::npos)
        << notRead.front().what();
    fs::remove_all(folder);
}

} // namespace
} // namespace trembler::ui::test
