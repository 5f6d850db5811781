// The pages about engines and hard cases are those of the present levels: the frames that docs/engines.md
// states are computed again, and docs/measurements/stability.md has a row for each level.
#include "puzzle/run/runner.hpp"
#include "tests/support/experiment.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace trembler {
namespace {

class EnginesPage : public Experiment {
protected:
    [[nodiscard]] static std::vector<std::string> linesOf(std::string const& page) {
        std::ifstream in(gameData().home / "docs" / page);
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) {
            lines.push_back(line);
        }
        return lines;
    }
    /// The cells of a row of a table, without blanks around them.
    [[nodiscard]] static std::vector<std::string> cellsOf(std::string const& line) {
        std::vector<std::string> cells;
        std::istringstream in(line.substr(1));
        for (std::string cell; std::getline(in, cell, '|');) {
            std::size_t const first = cell.find_first_not_of(' ');
            std::size_t const last = cell.find_last_not_of(' ');
            cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
        }
        return cells;
    }
    /// The frame in which the level is solved on an engine; "–" if never.
    [[nodiscard]] static std::string solvedIn(std::string const& name, std::string const& solution,
                                              std::string const& engine) {
        LevelFile const level = loadLevel(gameData().registry, gameData().home / "levels" / (name + ".json"));
        WorldOptions options;
        options.detail = level.detail;
        options.detail["dynamics"] = engine;
        Session session(gameData().registry, gameData().parts, level, options);
        RunOptions run;
        run.frames = 3600;
        run.stopWhenSolved = true;
        if (solution != "hands off") {
            Solution const* const recorded = level.findSolution(solution);
            if (recorded == nullptr) {
                return "no such solution";
            }
            session.load(*recorded);
        }
        auto const frame = trembler::run(session, "", run).solvedFrame;
        return frame ? std::to_string(*frame) : "–";
    }
};

TEST_F(EnginesPage, StatesTheFramesInWhichSolutionsSolve) {
    constexpr std::array<char const*, 4> engines{"native", "box2d", "chipmunk", "ode"};
    std::size_t rows = 0;
    bool inside = false;
    for (std::string const& line : linesOf("engines.md")) {
        inside = line.starts_with("| level | recorded solution |") || (inside && line.starts_with("|"));
        if (!inside || line.starts_with("| level") || line.starts_with("|---")) {
            continue;
        }
        std::vector<std::string> const stated = cellsOf(line);
        ASSERT_EQ(stated.size(), 6U) << line;
        std::string now = fmt::format("| {} | {} |", stated[0], stated[1]);
        for (std::size_t i = 0; i < engines.size(); ++i) {
            bool const built = [&] {
                for (Registration const& registration : gameData().registry.components()) {
                    if (registration.info->text.effect == "dynamics" &&
                        registration.info->text.level == engines[i]) {
                        return registration.missing.empty();
                    }
                }
                return false;
            }();
            now += " " + (built ? solvedIn(stated[0], stated[1], engines[i]) : stated[i + 2]) + " |";
        }
        EXPECT_EQ(line, now) << "docs/engines.md is stale: the second line is the right one";
        ++rows;
    }
    EXPECT_GE(rows, 8U);
}

// A hundred thousand frames of each level take minutes; its first ten seconds show whether it has changed.
TEST_F(EnginesPage, OfHardCasesIsAboutThePresentLevels) {
    std::map<std::string, std::string> stated;
    for (std::string const& line : linesOf("measurements/stability.md")) {
        constexpr std::string_view begin = "1e5 frames hands off, ";
        if (line.starts_with("| " + std::string(begin))) {
            std::vector<std::string> const cells = cellsOf(line);
            stated[cells.front().substr(begin.size())] = cells.back();
        }
    }
    std::map<std::string, std::string> now;
    for (std::filesystem::path const& path : gameData().levels()) {
        LevelFile const level = loadLevel(gameData().registry, path);
        WorldOptions options;
        options.detail = level.detail;
        Session session(gameData().registry, gameData().parts, level, options);
        for (int frame = 0; frame < 600; ++frame) {
            session.step();
        }
        now[gameData().shortName(path)] = fmt::format("frame 600: {:016x}", session.world().stateHash());
    }
    for (auto const& [level, state] : now) {
        EXPECT_EQ(stated[level], state) << level << ": make docs/measurements/stability.md again, as it says";
    }
    EXPECT_EQ(stated.size(), now.size()) << "rows of levels that are gone";
}

} // namespace
} // namespace trembler
