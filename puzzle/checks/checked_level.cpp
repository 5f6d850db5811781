#include "puzzle/checks/checked_level.hpp"

#include "puzzle/checks/level_checks.hpp"
#include "puzzle/goals/goal_judge.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "runtime/level/read/read_level.hpp"

#include <utility>

namespace trembler {

BuiltLevel checkPlayable(Registry const& registry, PartLibrary const& parts, LevelFile const& level,
                         WorldOptions options) {
    BuiltLevel built = buildLevel(registry, level, parts, {}, std::move(options));
    GoalJudge const goals(level, *built.world);
    GoalJudge const task(level, *built.world, readTask(level));
    return built;
}

ReadyLevel loadPlayable(Registry const& registry, PartLibrary const& parts, std::filesystem::path const& file,
                        WorldOptions options) {
    LevelFile level = loadLevel(registry, file);
    BuiltLevel built = checkPlayable(registry, parts, level, options);
    return {.level = std::move(level), .options = std::move(options), .built = std::move(built)};
}

std::vector<std::string> doubtsAbout(PartLibrary const& parts, LevelFile const& level,
                                     BuiltLevel const& built) {
    Problems problems;
    complainAboutMatter(parts, level, built, problems);
    std::vector<std::string> doubts;
    try {
        problems.throwIfAny();
    } catch (InputError const& found) { // in order of the places in the file
        for (Diagnostic const& doubt : found.diagnostics()) {
            doubts.push_back(doubt.print());
        }
    }
    return doubts;
}

} // namespace trembler
