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

/// The objects that a condition is about: a named object, all objects made from a part, or a list of these. A
/// condition on several objects holds if it holds for any of them.
struct Selector {
    std::vector<std::string> names;
    /// Refers to all objects that the level or the player made from these parts.
    std::vector<std::string> parts;
    bool it = false;  ///< the object that a surrounding count tests
    std::string path; ///< in the file, for messages

    [[nodiscard]] bool empty() const { return names.empty() && parts.empty() && !it; }
};

/// A condition of any kind. A kind uses the members that it needs, and keeps in `details` the data that no
/// other kind has.
struct Condition {
    ConditionKind const* kind = nullptr;      ///< null only if the condition could not be read
    Selector subject;                         ///< the objects that it is about
    Selector object;                          ///< the other objects, if the kind relates two
    std::optional<Area> area;                 ///< the area that it is about, if the kind has one
    std::string areaName = "the marked area"; ///< in sentences
    std::vector<Condition> children;
    std::any details; ///< numbers and choices that only the kind sets and reads

    std::optional<double> seconds; ///< how long it must hold without a break
    std::string id;
    std::string text; ///< by the level's author; empty: the text is made from the condition
    std::string path; ///< in the file, for messages
};

/// Whether the player sees each child as a separate goal: the kind lists goals, and the level states neither
/// a time nor a text for the whole condition.
[[nodiscard]] bool splitsIntoGoals(Condition const& condition);
/// The goals of a level with this condition, in order: its children if it splits, else the condition itself.
[[nodiscard]] std::span<Condition const> goalsOf(Condition const& condition);

} // namespace trembler
