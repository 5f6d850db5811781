// The consequences, in a trace, of a deed that it does not connect with what was asked about.
#pragma once

#include "insight/why/story/story.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace trembler::insight {

/// The events, by their places in the trace, that lead from some events to the first magnet that is switched
/// because of them, by the fewest steps; if there is none, to the first of these objects whose current begins
/// or ends. Only events that a story names (kindOf()), ascending, without the first ones unless they are
/// named by `alsoFirst`; empty if there is no such consequence before the event `last`. O(causes of all
/// events).
[[nodiscard]] std::vector<std::size_t> bridgeFrom(std::span<Event const> events,
                                                  std::vector<std::size_t> const& first, bool alsoFirst,
                                                  std::vector<std::string> const& objects, EventId last);

} // namespace trembler::insight
