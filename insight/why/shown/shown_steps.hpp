// The steps of a story that an answer shows.
#pragma once

#include "insight/why/answer.hpp"
#include "insight/why/runs/candidates.hpp"
#include "insight/why/story/story.hpp"

#include <vector>

namespace trembler::insight {

/// What was confirmed by a run without it, what leads from there to the asked step, and what it follows from
/// directly; the ground only if it is asked for, or nothing else is known. Of something that happens again
/// and again at once, as when a body bounces or bobs up and down, only the last time.
[[nodiscard]] std::vector<bool> shownSteps(Story const& story, std::vector<Proof> const& proofs,
                                           std::vector<Candidate> const& candidates, SceneFacts const& facts,
                                           bool everything);

} // namespace trembler::insight
