#include "insight/why/shown/shown_steps.hpp"

#include "insight/why/shown/shown_causes.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace trembler::insight {
namespace {

/// Whether a step is a contact that is taken for granted with an object that the question does not name.
bool isGround(Step const& step, Story const& story, SceneFacts const& facts) {
    std::vector<std::string> const& asked = story.askedStep().objects;
    return isGranted(step, facts) &&
           std::none_of(step.objects.begin(), step.objects.end(), [&](std::string const& name) {
               return facts.fixed.contains(name) &&
                      std::find(asked.begin(), asked.end(), name) != asked.end();
           });
}

/// From which steps something leads to the asked step, other than the pulls of a magnet without which it
/// happened all the same.
std::vector<bool> leadingSteps(Story const& story, std::vector<Proof> const& proofs) {
    std::vector<bool> leads(story.steps.size());
    leads[story.asked] = true;
    for (std::size_t i = story.steps.size(); i-- > 0;) {
        for (std::size_t const cause : story.steps[i].because) {
            bool const idle = isPull(story.steps[i].kind) && proofs[i] == Proof::refuted;
            leads[cause] = leads[cause] || (leads[i] && !idle);
        }
    }
    return leads;
}

/// What was confirmed by a run without it, what leads from there to the asked step,
/// and what it follows from directly; the ground only if it is asked for, or nothing else is known.
std::vector<bool> knownSteps(Story const& story, std::vector<Proof> const& proofs,
                             std::vector<Candidate> const& candidates, SceneFacts const& facts,
                             bool everything) {
    std::vector<bool> shown(story.steps.size());
    std::vector<bool> confirmable = leadingSteps(story, proofs);
    for (Candidate const& candidate : candidates) {
        for (std::size_t const i : candidate.steps) {
            confirmable[i] = true;
        }
    }
    shown[story.asked] = true;
    bool any = false;
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        bool const known = confirmable[i] && (proofs[i] == Proof::confirmed || proofs[i] == Proof::together);
        bool const told = known && (everything || !isGround(story.steps[i], story, facts));
        shown[i] = shown[i] || told;
        any = any || (told && i != story.asked);
    }
    for (std::size_t i = 0; i < story.steps.size() && !any; ++i) {
        shown[i] = shown[i] || proofs[i] == Proof::confirmed || proofs[i] == Proof::together;
    }
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        if (shown[i] && story.steps[i].kind == StepKind::apart) {
            for (std::size_t const cause : story.steps[i].because) {
                bool const pull = isPull(story.steps[cause].kind) && proofs[cause] == Proof::traced;
                shown[cause] = shown[cause] || pull;
            }
        }
    }
    for (std::size_t const i : story.askedStep().because) {
        if (proofs[i] != Proof::refuted && (everything || !any || !isGround(story.steps[i], story, facts))) {
            shown[i] = true;
        }
    }
    return shown;
}

/// Leaves out of several contacts of a pair that follow from each other, as when something bounces, all but
/// the last, and of pulls by a magnet that was switched on again at once. A contact from which the later one
/// follows by way of other steps, as that of a doorbell's striker, is no bounce.
void joinBounces(Story const& story, std::vector<bool>& shown) {
    std::vector<StepSet> const nearest = nearestShown(story, shown);
    std::vector<StepSet> ancestors(story.steps.size());
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        for (std::size_t const cause : nearest[i]) {
            ancestors[i].insert(cause);
            ancestors[i].insert(ancestors[cause].begin(), ancestors[cause].end());
        }
    }
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        for (std::size_t const cause : nearest[i]) {
            Step const& before = story.steps[cause];
            StepKind const kind = story.steps[i].kind;
            bool const same = shown[i] && (kind == StepKind::contact || isPull(kind)) &&
                              before.kind == kind && before.objects == story.steps[i].objects;
            if (same && std::none_of(nearest[i].begin(), nearest[i].end(), [&](std::size_t other) {
                    return story.steps[other].kind != kind && ancestors[other].contains(cause);
                })) {
                shown[cause] = false;
            }
        }
    }
}

/// A body that bobs up and down dips into the water many times: keeps only the last dips before each step.
void joinDips(Story const& story, std::vector<bool>& shown) {
    std::vector<StepSet> nearest = nearestShown(story, shown);
    StepSet last;
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        if (shown[i]) {
            keepLastDips(story, nearest[i]);
            last.insert(nearest[i].begin(), nearest[i].end());
        }
    }
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        bool const dip = story.steps[i].kind == StepKind::liquid && i != story.asked;
        shown[i] = shown[i] && (!dip || last.contains(i));
    }
}

} // namespace

std::vector<bool> shownSteps(Story const& story, std::vector<Proof> const& proofs,
                             std::vector<Candidate> const& candidates, SceneFacts const& facts,
                             bool everything) {
    std::vector<bool> shown = knownSteps(story, proofs, candidates, facts, everything);
    joinBounces(story, shown);
    joinDips(story, shown);
    return shown;
}

} // namespace trembler::insight
