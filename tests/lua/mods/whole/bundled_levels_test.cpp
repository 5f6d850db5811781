// The levels of the mods that come with the program: they are valid, the same on any number of threads, and
// only won by the effects of their mod.
#include "puzzle/run/runner.hpp"
#include "puzzle/solutions/verify.hpp"
#include "tests/lua/support/bundled_mods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace trembler::lua {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> filesOf(std::string const& mod, char const* folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator at(bundledModFolder() / mod / folder, error), end; !error && at != end;
         at.increment(error)) {
        files.push_back(at->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> namesOfBundledMods() {
    std::vector<std::string> names;
    for (fs::path const& folder : listMods(std::vector<fs::path>{bundledModFolder()})) {
        names.push_back(folder.filename().string());
    }
    return names;
}

/// The same mods, whose interactions do nothing.
std::vector<Mod> inert(std::vector<Mod> mods) {
    Problems problems;
    for (Mod& mod : mods) {
        for (Manifest& manifest : mod.interactions) {
            std::string source = manifest.source;
            std::size_t const apply = source.find("apply = function(");
            EXPECT_NE(apply, std::string::npos) << manifest.file;
            source.insert(source.find(')', apply) + 1, " if true then return end ");
            manifest = readManifest(std::move(source), manifest.file, problems);
        }
    }
    problems.throwIfAny();
    return mods;
}

RunReport runSolution(GameData const& game, LevelFile const& level, Solution const& solution,
                      std::uint64_t frames, int threads) {
    WorldOptions options;
    options.threads = threads;
    options.detail = level.detail;
    options.rowsWorthThreads = 0;
    Session session(game.registry, game.parts, level, options);
    session.load(solution);
    RunOptions run;
    run.frames = frames;
    run.hashEvery = 30;
    return trembler::run(session, "", run);
}

class BundledLevels : public testing::TestWithParam<std::string> {};

TEST_P(BundledLevels, AreValidAndTheirTestsToo) {
    auto const game = gameWith({GetParam()});
    for (char const* const folder : {"levels", "tests"}) {
        auto const files = filesOf(GetParam(), folder);
        EXPECT_FALSE(files.empty()) << folder;
        for (fs::path const& file : files) {
            for (std::string const& failure : verifyLevel(*game, file)) {
                ADD_FAILURE() << failure;
            }
            EXPECT_EQ(errorsOf(*game), "") << file;
        }
    }
}

TEST_P(BundledLevels, EndInTheSameStateOnAnyNumberOfThreads) {
    auto const game = gameWith({GetParam()});
    for (fs::path const& file : filesOf(GetParam(), "levels")) {
        LevelFile const level = loadLevel(game->registry, file);
        Solution const& solution = level.solutions.front();
        RunReport const one = runSolution(*game, level, solution, 240, 1);
        for (int const threads : {2, 8, 32}) {
            RunReport const several = runSolution(*game, level, solution, 240, threads);
            EXPECT_EQ(several.stateHash, one.stateHash) << file << ' ' << threads;
            ASSERT_EQ(several.hashes.size(), one.hashes.size());
            for (std::size_t i = 0; i < one.hashes.size(); ++i) {
                EXPECT_EQ(several.hashes[i].hash, one.hashes[i].hash) << file << ' ' << threads;
            }
        }
    }
}

TEST_P(BundledLevels, AreWonByWhatTheirModDoesOnly) {
    static GameData const game(inert(bundledMods(namesOfBundledMods()))); // read once for all mods
    (void)game.scriptLog->take();
    for (fs::path const& file : filesOf(GetParam(), "levels")) {
        LevelFile const level = loadLevel(game.registry, file);
        for (Solution const& solution : level.solutions) {
            auto const frames = static_cast<std::uint64_t>(solution.frames.value_or(600));
            EXPECT_FALSE(runSolution(game, level, solution, frames, 1).solved)
                << file << ' ' << solution.name;
        }
    }
    EXPECT_EQ(errorsOf(game), "");
}

INSTANTIATE_TEST_SUITE_P(Mods, BundledLevels, testing::ValuesIn(namesOfBundledMods()),
                         [](testing::TestParamInfo<std::string> const& info) {
                             std::string name = info.param;
                             std::replace_if(
                                 name.begin(), name.end(),
                                 [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                             return name;
                         });

} // namespace
} // namespace trembler::lua
