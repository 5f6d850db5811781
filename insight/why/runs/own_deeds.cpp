#include "insight/why/runs/own_deeds.hpp"

#include "insight/ablation/needs.hpp"
#include "insight/why/runs/goal_runs.hpp"

#include <algorithm>
#include <vector>

namespace trembler::insight {
namespace own_deeds {
namespace {

constexpr std::size_t mostDeeds = 8; // that are tested

/// Whether the miss names the wire already, as one that had been cut.
bool namesCut(Miss const& miss, RecordedInput const& input) {
    return std::any_of(miss.gaps.begin(), miss.gaps.end(),
                       [&](CircuitGap const& gap) {
                           return gap.reason == GapReason::cut &&
                                  ((gap.nameA == input.object && gap.nameB == input.other) ||
                                   (gap.nameA == input.other && gap.nameB == input.object));
                       }) ||
           std::any_of(miss.besides.begin(), miss.besides.end(),
                       [&](Miss const& other) { return namesCut(other, input); });
}

Miss missOf(RecordedInput const& input) {
    using Kind = PlayerInput::Kind;
    Miss miss;
    miss.lack = input.kind == Kind::cut ? Lack::cut : input.kind == Kind::remove ? Lack::removal : Lack::grab;
    miss.by = 1;
    miss.names = {input.object};
    if (input.kind == Kind::cut) {
        miss.names.push_back(input.other);
    }
    return miss;
}

} // namespace
} // namespace own_deeds

void addOwnDeeds(LevelRuns const& runs, Solution const& solution, AskOptions const& options, Answer& answer) {
    if (!answer.complete || !answer.nearest) {
        return;
    }
    Miss const& nearest = answer.nearest->nearest;
    std::vector<Deed> deeds = deedsOf(solution);
    std::erase_if(deeds, [&](Deed const& deed) {
        return own_deeds::namesCut(nearest, solution.inputs[deed.inputs.front()]);
    });
    deeds.resize(std::min(deeds.size(), own_deeds::mostDeeds));
    std::vector<Variation> variations;
    for (Deed const& deed : deeds) {
        Variation& without = variations.emplace_back(Variation{solution, {}});
        for (std::size_t const input : deed.inputs) {
            without.leftOut.push_back(withoutInput(input));
        }
    }
    addWhatCameNearer(runs, options, answer, variations, [&](std::size_t i) {
        return own_deeds::missOf(solution.inputs[deeds[i].inputs.front()]);
    });
}

} // namespace trembler::insight
