// By which of several devices a deed acted.
#include "insight/why/runs/second_runs.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace trembler::insight {

bool SecondRuns::mediates(Step const& end) {
    std::string const& name = end.objects.front();
    std::vector<LeftOut> leftOut;
    if (end.kind == StepKind::magnetOff) {
        leftOut = {withoutSwitching(name, end.frame)};
    } else if (end.kind == StepKind::magnetOn || facts_.motors.contains(name)) {
        leftOut = {withoutDevice(name, end.frame)};
    } else {
        return true;
    }
    if (!noteRun(done_ + 1)) {
        return false;
    }
    return without({{std::move(leftOut), {}}}, {0}).kind == Outcome::Kind::prevented;
}

std::optional<std::size_t> SecondRuns::bridgeFor(Tested& tested, std::size_t deed, std::size_t effect,
                                                 Outcome const& outcome) {
    Story const& story = target_.story;
    auto const bridges = story.bridges.find(deed);
    if (bridges == story.bridges.end()) {
        return std::nullopt;
    }
    auto const chosen = std::find_if(bridges->second.begin(), bridges->second.end(), [&](std::size_t end) {
        return end < effect && !outcome.steps[end] && mediates(story.steps[end]);
    });
    bool const any = chosen != bridges->second.end();
    std::set<std::size_t> kept{any ? *chosen : deed};
    std::set<std::size_t> own{deed};
    for (std::size_t i = deed + 1; i < story.asked; ++i) {
        std::vector<std::size_t> const& because = story.steps[i].because;
        bool const ofDeed = std::any_of(because.begin(), because.end(),
                                        [&](std::size_t cause) { return own.contains(cause); });
        if (story.steps[i].bridge && ofDeed) {
            own.insert(i);
        }
    }
    for (auto i = own.rbegin(); i != own.rend(); ++i) { // causes come before their effects
        if (kept.contains(*i)) {
            kept.insert(story.steps[*i].because.begin(), story.steps[*i].because.end());
        } else {
            tested.proofs[*i] = Proof::refuted;
        }
    }
    return any ? std::optional(*chosen) : std::nullopt;
}

} // namespace trembler::insight
