// What led to each event of a trace: the causes that the trace states, and those that follow from how
// circuits, magnets and liquids act.
#pragma once

#include "insight/why/story/scene_facts.hpp"
#include "runtime/trace/event.hpp"

#include <cstddef>
#include <set>
#include <span>
#include <vector>

namespace trembler::insight {

/// For each event the places of the events that led to it directly and that a person would name, see kindOf()
/// and storyOf().
[[nodiscard]] std::vector<std::set<std::size_t>> causesIn(std::span<Event const> events,
                                                          SceneFacts const& facts);

} // namespace trembler::insight
