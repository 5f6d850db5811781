// The contacts that a condition of the kind "touching" is about.
#pragma once

#include "physics/dynamics/properties/contacts.hpp"
#include "puzzle/goals/judging/condition_state.hpp"

#include <utility>
#include <vector>

namespace trembler::conditions {

/// Each pair of one of the state's subjects with one of its objects that touches at the end of the frame or
/// has touched within it, once, as (subject, object). In the order of contacts.
[[nodiscard]] std::vector<std::pair<ObjectId, ObjectId>> wantedTouches(ConditionState const& state,
                                                                       Contacts const& contacts);

} // namespace trembler::conditions
