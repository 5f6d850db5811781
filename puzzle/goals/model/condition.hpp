// What has to come about for a level to be solved, as its file states it.
#pragma once

#include "puzzle/goals/model/condition_kind.hpp"
#include "runtime/level/model/level.hpp"

#include <any>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// Which objects a condition speaks of: a named one, all made from a part, or several of these. A condition
/// on several objects holds if it holds for any of them.
struct Selector {
    std::vector<std::string> names;
    std::vector<std::string>
        parts;       ///< everything of the level, and all that the player placed, made from these
    bool it = false; ///< the object that a surrounding count looks at
    std::string path;

    [[nodiscard]] bool empty() const { return names.empty() && parts.empty() && !it; }
};

/// What conditions of all kinds are made of. A kind uses what it needs of it, and keeps the rest in
/// `details`.
struct Condition {
    ConditionKind const* kind = nullptr; ///< null only in what could not be read
    Selector subject;                    ///< whom it speaks of
    Selector object;                     ///< whom else, where the kind relates two
    std::optional<Area> area;            ///< the place that it speaks of, where the kind has one
    std::string areaName = "the marked area";
    std::vector<Condition> children;
    std::any details; ///< numbers and choices that only the kind knows; it sets and reads them

    std::optional<double> seconds; ///< must hold for that long without a break
    std::string id;
    std::string text; ///< in the words of the level's author; empty: made from the condition
    std::string path;
};

/// Whether each child is a goal of its own to the player: the kind lists goals, and the level states nothing
/// about the condition as a whole.
[[nodiscard]] bool splitsIntoGoals(Condition const& condition);
/// The goals of a level with this condition, in order: its children if it splits, else the condition itself.
[[nodiscard]] std::span<Condition const> goalsOf(Condition const& condition);

} // namespace trembler
