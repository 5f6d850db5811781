// From which of the shown steps of a story each of them follows.
#pragma once

#include "insight/why/story/story.hpp"

#include <cstddef>
#include <set>
#include <vector>

namespace trembler::insight {

/// By their places in the story.
using StepSet = std::set<std::size_t>;

/// The shown ancestors of each step with nothing shown in between.
[[nodiscard]] std::vector<StepSet> nearestShown(Story const& story, std::vector<bool> const& shown);

/// Leaves out causes that are dips of the same object into the same liquid, except for the last dip.
void keepLastDips(Story const& story, StepSet& causes);

/// For each shown step its nearest shown ancestors, without the ancestors from which another one of them
/// follows. The contacts that close or bridge a circuit are causes side by side: that one came before the
/// other is no reason for it.
[[nodiscard]] std::vector<StepSet> shownCauses(Story const& story, std::vector<bool> const& shown,
                                               SceneFacts const& facts);

} // namespace trembler::insight
