// Shortens a chain in which the same steps repeat.
#pragma once

#include "insight/why/answer.hpp"

#include <vector>

namespace trembler::insight {

/// Of the same steps, up to 24, that follow each other three times or more in the same order, known equally
/// well, only the last time stays, with the number of times in `times` and a number of its own in `cycle`.
/// What followed from an earlier time follows from what led to the first. What the player did is never
/// folded. Steps are the same if their objects are, or have the same role, as the spokes of a motor, whose
/// turns are the same for each spoke. O(steps * 24).
void foldRepeats(std::vector<ChainStep>& chain, SceneFacts const& facts);

} // namespace trembler::insight
