// The steps of a story of causes that can be left out of another run.
#pragma once

#include "insight/run/variation.hpp"
#include "insight/why/story/story.hpp"

#include <vector>

namespace trembler::insight {

/// Something that may be a cause, and how to run without it.
struct Candidate {
    std::vector<LeftOut> leftOut;
    std::vector<std::size_t> steps; ///< of the story: all contacts of the pair, the placement, the deed
};

/// The pairs of objects that touch in the story, the magnets that pull or push something in it, the
/// placements, the player's wires and deeds, and the dips of each object into each liquid. Pairs whose
/// objects have the same roles, as the spokes that a motor's contact touches in turn, are left out together
/// if several of them are in the story. A pair is left out from the first frame in which it touches in the
/// run, so that until then the runs are the same. Contacts with fixed objects of the level that conduct
/// nothing are taken for granted, like gravity, unless `everything` is asked for; and steps that are the
/// asked goal itself are not candidates, as it would be no goal without them.
[[nodiscard]] std::vector<Candidate> candidatesOf(Story const& story, SceneFacts const& facts,
                                                  Solution const& solution, bool everything);

/// Whether a step is a contact that is taken for granted.
[[nodiscard]] bool isGranted(Step const& step, SceneFacts const& facts);

} // namespace trembler::insight
