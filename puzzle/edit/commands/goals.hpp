// Commands on the tree of goals.
#pragma once

#include "puzzle/edit/document/command.hpp"
#include "runtime/level/model/level.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace trembler::edit {

/// A demonstration has two trees: the goals that it reaches by itself, and the task of its player.
enum class GoalTree : std::uint8_t { goals, task };
/// "goals" or "task", the tree's key in files.
[[nodiscard]] char const* keyOf(GoalTree tree);

// A condition's place is a JSON pointer below "goals", or "task": "" for the whole goal, "/all/0", "/not",
// "/any/1/count/that". A place where there is no condition throws CommandError. The conditions' own contents
// are not checked here: their faults are problems, see puzzle/edit/problems/.

/// One condition of the tree, for a list of lines.
struct GoalLine {
    std::string place; ///< of the condition
    std::size_t depth = 0;
    std::string kind;       ///< "all", "touching" ...; empty if it states none
    Json condition;         ///< without the inner conditions of its lists
    bool takesMore = false; ///< whether conditions can be added to it, as to "all"
};
/// All conditions, outer ones first, in the order of the file; empty for a level without goals.
[[nodiscard]] std::vector<GoalLine> goalLines(Json const& level, GoalTree tree = GoalTree::goals);

/// A condition of a kind, to begin with: about `objects` in their order, as far as the kind takes them, and
/// the area, if it needs one. {"inside": {"object": ..., "area": ...}} and so on. Throws CommandError for a
/// kind that does not exist, or if it needs more objects than there are.
[[nodiscard]] Json newCondition(std::string const& kind, std::vector<std::string> const& objects,
                                Area const& area = {});

/// Adds a condition at the end of the list at `place`. Where the condition there takes no more, or there are
/// no goals, "all" of both, or the new one, is put there. Only a demonstration has a task.
[[nodiscard]] Command addGoal(Json const& level, std::string const& place, Json const& condition,
                              GoalTree tree = GoalTree::goals);
/// Puts the condition inside `kind`, one whose value is a condition ("not") or a list of conditions ("all").
[[nodiscard]] Command wrapGoal(Json const& level, std::string const& place, std::string const& kind,
                               GoalTree tree = GoalTree::goals);
/// Puts the only inner condition of such a kind in its place.
[[nodiscard]] Command unwrapGoal(Json const& level, std::string const& place,
                                 GoalTree tree = GoalTree::goals);
/// Removes a condition. The list or the "not" around it is removed with its last condition.
[[nodiscard]] Command removeGoal(Json const& level, std::string const& place,
                                 GoalTree tree = GoalTree::goals);
/// Replaces a condition by another one.
[[nodiscard]] Command changeGoal(Json const& level, std::string const& place, Json const& condition,
                                 GoalTree tree = GoalTree::goals);
/// Sets "for" (s), "id" or "text" of a condition; null removes it.
[[nodiscard]] Command setGoalOption(Json const& level, std::string const& place, std::string const& key,
                                    Json const& value, GoalTree tree = GoalTree::goals);
/// Changes an "area" inside a condition, m.
[[nodiscard]] Command setGoalArea(Json const& level, std::string const& place, Area const& area,
                                  GoalTree tree = GoalTree::goals);
/// Moves a condition within its list.
[[nodiscard]] Command moveGoal(Json const& level, std::string const& place, std::size_t to,
                               GoalTree tree = GoalTree::goals);

} // namespace trembler::edit
