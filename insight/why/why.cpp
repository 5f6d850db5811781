#include "insight/why/answer.hpp"
#include "insight/why/runs/candidates.hpp"
#include "insight/why/runs/held_back.hpp"
#include "insight/why/runs/in_the_way.hpp"
#include "insight/why/runs/not_pushed.hpp"
#include "insight/why/runs/own_deeds.hpp"
#include "insight/why/runs/question_target.hpp"
#include "insight/why/runs/second_runs.hpp"
#include "insight/why/shown/shown_causes.hpp"
#include "insight/why/shown/shown_steps.hpp"
#include "insight/why/story/fold_repeats.hpp"
#include "insight/why/story/join_pulls.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace trembler::insight {
namespace {

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
    std::vector<bool> const shown = shownSteps(story, proofs, candidates, answer.facts, everything);
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
