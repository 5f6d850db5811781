// The condition for solving a level, as the level file states it.
#pragma once

#include "puzzle/goals/model/condition_kind.hpp"
#include "runtime/level/model/level.hpp"

#include <any>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// The objects that a condition is about: a named one, all that are made from a part, or several of these. A
/// condition on several objects holds if it holds for any of them.
struct Selector {
    std::vector<std::string> names;
    /// All objects of the level and all that the player placed that are made from these.
    std::vector<std::string> parts;
    bool it = false;  ///< the object that a surrounding count looks at
    std::string path; ///< in the file, for messages

    [[nodiscard]] bool empty() const { return names.empty() && parts.empty() && !it; }
};

/// A condition of any kind. A kind uses the members that it needs, and keeps in `details` what no other kind
/// has.
struct Condition {
    ConditionKind const* kind = nullptr;      ///< null only in what could not be read
    Selector subject;                         ///< the objects that it is about
    Selector object;                          ///< the other objects, if the kind relates two
    std::optional<Area> area;                 ///< the area that it is about, if the kind has one
    std::string areaName = "the marked area"; ///< in sentences
    std::vector<Condition> children;
    std::any details; ///< numbers and choices that only the kind knows; it sets and reads them

    std::optional<double> seconds; ///< must hold for that long without a break
    std::string id;
    std::string text; ///< in the words of the level's author; empty: made from the condition
    std::string path; ///< in the file, for messages
};

/// Whether each child is a goal of its own to the player: the kind lists goals, and the level states neither
/// a time nor a text for the condition as a whole.
[[nodiscard]] bool splitsIntoGoals(Condition const& condition);
/// The goals of a level with this condition, in order: its children if it splits, else the condition itself.
[[nodiscard]] std::span<Condition const> goalsOf(Condition const& condition);

} // namespace trembler
