#include "puzzle/checks/checked_level.hpp"

#include "puzzle/checks/level_checks.hpp"
#include "puzzle/goals/goal_judge.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "runtime/level/read/read_level.hpp"

namespace trembler {
namespace {

LevelFile withDetail(LevelFile level, std::map<std::string, std::string> const& detail) {
    for (auto const& [effect, name] : detail) {
        level.detail[effect] = name;
    }
    return level;
}

} // namespace

BuiltLevel checkPlayable(Registry const& registry, PartLibrary const& parts, LevelFile const& level) {
    BuiltLevel built = buildLevel(registry, level, parts);
    GoalJudge const goals(level, *built.world);
    GoalJudge const task(level, *built.world, readTask(level));
    return built;
}

LevelFile loadPlayable(Registry const& registry, PartLibrary const& parts, std::filesystem::path const& file,
                       std::map<std::string, std::string> const& detail) {
    LevelFile level = loadLevel(registry, file);
    (void)checkPlayable(registry, parts, withDetail(level, detail));
    return level;
}

std::vector<std::string> doubtsAbout(Registry const& registry, PartLibrary const& parts,
                                     LevelFile const& level,
                                     std::map<std::string, std::string> const& detail) {
    Problems problems;
    complainAboutMatter(parts, level, checkPlayable(registry, parts, withDetail(level, detail)), problems);
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
