// The list of all kinds of goal conditions.
#pragma once

#include "puzzle/goals/model/condition_kind.hpp"

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

namespace trembler::conditions {

#define TREMBLER_DECLARE(name) ConditionKind const& name();
TREMBLER_CONDITIONS(TREMBLER_DECLARE)
#undef TREMBLER_DECLARE

} // namespace trembler::conditions
