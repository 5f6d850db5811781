#include "puzzle/goals/model/condition.hpp"

namespace trembler {

bool splitsIntoGoals(Condition const& condition) {
    return condition.kind->listsGoals() && !condition.seconds && condition.text.empty();
}

std::span<Condition const> goalsOf(Condition const& condition) {
    return splitsIntoGoals(condition) ? std::span(condition.children) : std::span(&condition, 1);
}

} // namespace trembler
