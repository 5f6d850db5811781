#include "insight/why/answer.hpp"
#include "insight/why/runs/candidates.hpp"
#include "insight/why/runs/held_back.hpp"
#include "insight/why/runs/in_the_way.hpp"
#include "insight/why/runs/not_pushed.hpp"
#include "insight/why/runs/own_deeds.hpp"
#include "insight/why/runs/question_target.hpp"
#include "insight/why/runs/second_runs.hpp"
#include "insight/why/story/fold_repeats.hpp"
#include "insight/why/story/join_pulls.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

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

/// Without the magnet that alone pulled two objects apart, what was asked about happened all the same; but
/// that they came apart is part of the answer, and would not be understood without the pull: it is told as
/// traced.
void keepWhatPartedObjects(Story const& story, std::vector<Proof>& proofs) {
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        std::vector<std::size_t> const& because = story.steps[i].because;
        bool const known = std::any_of(because.begin(), because.end(),
                                       [&](std::size_t cause) { return proofs[cause] != Proof::refuted; });
        for (std::size_t const cause : because) {
            if (story.steps[i].kind == StepKind::apart && !known && isPull(story.steps[cause].kind)) {
                proofs[cause] = Proof::traced;
            }
        }
    }
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

/// The steps that are shown: what was confirmed by a run without it, what leads from there to the asked step,
/// and what it follows from directly; the ground only if it is asked for, or nothing else is known.
std::vector<bool> shownSteps(Story const& story, std::vector<Proof> const& proofs,
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

using StepSet = std::set<std::size_t>;

/// The shown ancestors of each step with nothing shown in between.
std::vector<StepSet> nearestShown(Story const& story, std::vector<bool> const& shown) {
    std::vector<StepSet> nearest(story.steps.size());
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        for (std::size_t const cause : story.steps[i].because) {
            if (shown[cause]) {
                nearest[i].insert(cause);
            } else {
                nearest[i].insert(nearest[cause].begin(), nearest[cause].end());
            }
        }
    }
    return nearest;
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

/// Leaves out causes that are dips of the same object into the same liquid, except for the last dip.
void keepLastDips(Story const& story, StepSet& causes) {
    std::erase_if(causes, [&](std::size_t cause) {
        Step const& dip = story.steps[cause];
        return dip.kind == StepKind::liquid &&
               std::any_of(causes.upper_bound(cause), causes.end(), [&](std::size_t later) {
                   Step const& other = story.steps[later];
                   return other.kind == StepKind::liquid && other.objects == dip.objects;
               });
    });
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

/// Whether a cause of a parting only says that the two touched before, or that the one that moved lay on
/// something fixed besides.
bool isPresupposed(Step const& cause, Step const& parting, SceneFacts const& facts) {
    if (parting.kind != StepKind::apart || cause.kind != StepKind::contact) {
        return false;
    }
    return cause.objects == parting.objects ||
           (std::any_of(cause.objects.begin(), cause.objects.end(),
                        [&](std::string const& name) { return facts.fixed.contains(name); }) &&
            std::any_of(cause.objects.begin(), cause.objects.end(), [&](std::string const& name) {
                return !facts.fixed.contains(name) &&
                       std::find(parting.objects.begin(), parting.objects.end(), name) !=
                           parting.objects.end();
            }));
}

/// The causes of a step with the causes of what it presupposes in its place; as they are if none are left.
StepSet withoutPresupposed(Story const& story, std::vector<StepSet> const& causes, std::size_t step,
                           SceneFacts const& facts) {
    StepSet left;
    for (std::size_t const cause : causes[step]) {
        if (isPresupposed(story.steps[cause], story.steps[step], facts)) {
            left.insert(causes[cause].begin(), causes[cause].end());
        } else {
            left.insert(cause);
        }
    }
    return left.empty() ? causes[step] : left;
}

/// For each shown step its nearest shown ancestors, without the ancestors from which another one of them
/// follows. The contacts that close or bridge a circuit are causes side by side: that one came before the
/// other is no reason for it.
std::vector<StepSet> shownCauses(Story const& story, std::vector<bool> const& shown,
                                 SceneFacts const& facts) {
    std::size_t const count = story.steps.size();
    std::vector<StepSet> nearest = nearestShown(story, shown);
    for (StepSet& causes : nearest) {
        keepLastDips(story, causes);
    }
    std::vector<StepSet> beside(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t const cause : nearest[i]) {
            StepKind const kind = story.steps[i].kind;
            bool const switches = (kind == StepKind::on || kind == StepKind::off) &&
                                  story.steps[cause].kind == StepKind::contact;
            if (shown[i] && switches) {
                beside[cause].insert(nearest[i].begin(), nearest[i].end());
            }
        }
    }
    std::vector<StepSet> ancestors(count);
    std::vector<StepSet> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        StepSet causes;
        for (std::size_t const cause : nearest[i]) {
            if (beside[i].contains(cause)) {
                causes.insert(result[cause].begin(), result[cause].end()); // in its place, its own causes
            } else {
                causes.insert(cause);
            }
        }
        for (std::size_t const cause : causes) {
            ancestors[i].insert(cause);
            ancestors[i].insert(ancestors[cause].begin(), ancestors[cause].end());
        }
        for (std::size_t const cause : causes) {
            bool const indirect = std::any_of(causes.begin(), causes.end(), [&](std::size_t other) {
                return ancestors[other].contains(cause);
            });
            if (!indirect) {
                result[i].insert(cause);
            }
        }
        result[i] = withoutPresupposed(story, result, i, facts);
    }
    return result;
}

/// Makes each step that is known without the trace a cause of the steps that did not happen without it.
void connect(Story& story, SecondRuns::Tested const& tested) {
    for (auto const& [cause, effect] : tested.effects) {
        std::vector<std::size_t>& because = story.steps[effect].because;
        because.insert(std::upper_bound(because.begin(), because.end(), cause), cause);
    }
}

void tell(Answer& answer, Target const& target, std::vector<Proof> const& proofs,
          std::vector<Candidate> const& candidates, bool everything) {
    Story const& story = target.story;
    std::vector<bool> shown = shownSteps(story, proofs, candidates, answer.facts, everything);
    joinBounces(story, shown);
    joinDips(story, shown);
    std::vector<StepSet> const causes = shownCauses(story, shown, answer.facts);
    std::vector<std::size_t> placeOf(story.steps.size());
    answer.confirmed = true;
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        if (!shown[i]) {
            answer.dropped += proofs[i] == Proof::refuted ? 1 : 0;
            continue;
        }
        placeOf[i] = answer.chain.size();
        ChainStep made{story.steps[i], proofs[i], {}};
        made.step.because.clear();
        for (std::size_t const cause : causes[i]) {
            made.step.because.push_back(placeOf[cause]);
        }
        if (!made.step.objects.empty()) {
            auto const start = answer.facts.places.find(made.step.objects.front());
            made.at = target.places.of(made.step.event,
                                       start == answer.facts.places.end() ? Vec2{} : start->second);
        }
        bool const root = made.step.because.empty();
        bool const known = proofs[i] == Proof::confirmed || proofs[i] == Proof::together;
        answer.confirmed = answer.confirmed && (!root || known);
        answer.chain.push_back(std::move(made));
    }
    joinPulls(answer.chain, answer.facts);
    foldRepeats(answer.chain, answer.facts);
}

} // namespace

std::string_view nameOf(Proof proof) {
    switch (proof) {
    case Proof::traced:
        return "traced";
    case Proof::confirmed:
        return "confirmed";
    case Proof::together:
        return "together";
    case Proof::refuted:
        break;
    }
    return "refuted";
}

Answer why(LevelRuns const& runs, Solution const& solution, Question const& question,
           AskOptions const& options) {
    Answer answer;
    Target target = findTarget(runs, solution, question, options, answer);
    answer.runs = 1;
    if (!target.event) {
        addHeldBack(runs, solution, options, answer);
        addInTheWay(runs, solution, options, answer);
        addNotPushed(runs, solution, options, answer);
        addOwnDeeds(runs, solution, options, answer);
        return answer; // the nearest miss is in it
    }
    answer.happened = true;
    std::vector<Candidate> const candidates =
        candidatesOf(target.story, answer.facts, solution, options.everything);
    SecondRuns second(runs, solution, target, answer.facts, options);
    SecondRuns::Tested tested = second.test(candidates);
    answer.runs += second.runs();
    answer.complete = second.complete();
    connect(target.story, tested);
    keepWhatPartedObjects(target.story, tested.proofs);
    tell(answer, target, tested.proofs, candidates, options.everything);
    return answer;
}

} // namespace trembler::insight
