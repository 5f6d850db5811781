#include "puzzle/goals/conditions/table.hpp"

// One line for each kind: conditions::NAME() is defined in NAME.cpp beside this file.
#define TREMBLER_CONDITIONS(KIND)                                                                            \
    KIND(inside)                                                                                             \
    KIND(touching)                                                                                           \
    KIND(on)                                                                                                 \
    KIND(off)                                                                                                \
    KIND(moved)                                                                                              \
    KIND(count)                                                                                              \
    KIND(all)                                                                                                \
    KIND(any)                                                                                                \
    KIND(negation)                                                                                           \
    KIND(sequence)

namespace trembler {
namespace conditions {

#define TREMBLER_DECLARE(name) ConditionKind const& name();
TREMBLER_CONDITIONS(TREMBLER_DECLARE)
#undef TREMBLER_DECLARE

} // namespace conditions

std::span<ConditionKind const* const> conditionKinds() {
#define TREMBLER_ENTRY(name) &conditions::name(),
    static ConditionKind const* const all[] = {TREMBLER_CONDITIONS(TREMBLER_ENTRY)};
#undef TREMBLER_ENTRY
    return all;
}

} // namespace trembler
#undef TREMBLER_CONDITIONS
