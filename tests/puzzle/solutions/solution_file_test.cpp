// A solution that is named: one of the level's, or one in a file.
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

namespace trembler {
namespace {

std::string refusalOfSolution(std::string const& nameOrFile) {
    Registry const& registry = gameData().registry;
    LevelFile const level =
        loadLevel(registry, std::filesystem::path(TREMBLER_SOURCE_DIR) / "levels/first/1-first-contact.json");
    try {
        (void)findOrLoadSolution(registry, level, nameOrFile);
        return "found";
    } catch (std::exception const& error) {
        return error.what();
    }
}

TEST(SolutionFile, IsCalledMissingOnlyIfItIs) {
    EXPECT_NE(refusalOfSolution("absent").find("there is neither a file nor a recorded solution"),
              std::string::npos);
    std::string const tooLong(300, 's');
    EXPECT_EQ(refusalOfSolution(tooLong), tooLong + ": cannot be read: File name too long");
}

} // namespace
} // namespace trembler
