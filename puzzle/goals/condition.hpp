// What has to come about for a level to be solved, as its file states it.
#pragma once

#include "runtime/level/model/level.hpp"

#include <optional>
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

enum class ConditionKind {
    inside,   ///< the subject's centre lies in the area
    touching, ///< subject and object touch
    on,       ///< the subject is part of a working circuit
    off,      ///< it is not
    moved,    ///< the subject is at least a distance away from where it was at the start
    count,    ///< the child holds for a number of objects
    all,      ///< all children hold at the same time
    any,      ///< at least one child holds
    negation, ///< the child does not hold
    sequence, ///< the children came true one after the other; then it holds for good
};

enum class Towards { anywhere, up, down, left, right };
enum class Quantity { atLeast, atMost, exactly };

struct Condition {
    ConditionKind kind = ConditionKind::all;
    Selector subject; ///< of count: the objects that are counted
    Selector object;  ///< touching
    Area area;        ///< inside
    std::string areaName = "the marked area";
    double distance = 0; ///< m, moved
    Towards towards = Towards::anywhere;
    Quantity quantity = Quantity::atLeast;
    int number = 1; ///< count
    std::vector<Condition> children;

    std::optional<double> seconds; ///< must hold for that long without a break
    std::string id;
    std::string text; ///< in the words of the level's author; empty: made from the condition
    std::string path;
};

} // namespace trembler
