#include "puzzle/goals/conditions/table.hpp"

#include "puzzle/goals/conditions/kinds.hpp"

namespace trembler {

std::span<ConditionKind const* const> conditionKinds() {
#define TREMBLER_ENTRY(name) &conditions::name(),
    static ConditionKind const* const all[] = {TREMBLER_CONDITIONS(TREMBLER_ENTRY)};
#undef TREMBLER_ENTRY
    return all;
}

} // namespace trembler
