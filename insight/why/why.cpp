#include "insight/why/answer.hpp"
#include "insight/why/candidates.hpp"
#include "insight/why/question_target.hpp"
#include "insight/why/second_runs.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace trembler::insight {
namespace {

/// The steps that are told: what was confirmed, what leads from there to the asked step, and what it follows
/// from directly.
std::vector<bool> toldSteps(Story const& story, std::vector<Proof> const& proofs, SceneFacts const& facts,
                            bool everything) {
    std::vector<bool> told(story.steps.size());
    told[story.asked] = true;
    bool any = false;
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        bool const known = proofs[i] == Proof::confirmed || proofs[i] == Proof::together;
        told[i] = told[i] || known;
        any = any || known;
    }
    for (std::size_t const i : story.askedStep().because) {
        if (proofs[i] != Proof::refuted && (everything || !any || !isGranted(story.steps[i], facts))) {
            told[i] = true;
        }
    }
    return told;
}

/// For each told step its nearest told ancestors, without those that another one of them follows from.
std::vector<std::vector<std::size_t>> toldCauses(Story const& story, std::vector<bool> const& told) {
    std::size_t const count = story.steps.size();
    std::vector<std::set<std::size_t>> nearest(count);   // told ancestors with nothing told in between
    std::vector<std::set<std::size_t>> ancestors(count); // all told ancestors
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t const cause : story.steps[i].because) {
            if (told[cause]) {
                nearest[i].insert(cause);
                ancestors[i].insert(cause);
            } else {
                nearest[i].insert(nearest[cause].begin(), nearest[cause].end());
            }
            ancestors[i].insert(ancestors[cause].begin(), ancestors[cause].end());
        }
    }
    std::vector<std::vector<std::size_t>> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t const cause : nearest[i]) {
            bool const indirect = std::any_of(nearest[i].begin(), nearest[i].end(), [&](std::size_t other) {
                return ancestors[other].contains(cause);
            });
            if (!indirect) {
                result[i].push_back(cause);
            }
        }
    }
    return result;
}

/// A touch and the contact that follows it within this many frames are one thing to people.
constexpr std::uint64_t bounce = 10;

/// Leaves out of several contacts of a pair in quick succession all but the last.
void joinBounces(Story const& story, std::vector<bool>& told) {
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        Step const& step = story.steps[i];
        if (!told[i] || step.kind != StepKind::contact) {
            continue;
        }
        for (std::size_t later = i + 1; later < story.steps.size(); ++later) {
            Step const& other = story.steps[later];
            bool const follows = std::binary_search(other.because.begin(), other.because.end(), i);
            if (told[later] && other.kind == StepKind::contact && other.objects == step.objects && follows &&
                other.frame <= step.frame + bounce) {
                told[i] = false;
                break;
            }
        }
    }
}

void tell(Answer& answer, Story const& story, std::vector<Proof> const& proofs, bool everything) {
    std::vector<bool> told = toldSteps(story, proofs, answer.facts, everything);
    joinBounces(story, told);
    std::vector<std::vector<std::size_t>> const causes = toldCauses(story, told);
    std::vector<std::size_t> placeOf(story.steps.size());
    answer.confirmed = true;
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        if (!told[i]) {
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
            auto const at = answer.facts.places.find(made.step.objects.front());
            made.at = at == answer.facts.places.end() ? Vec2{} : at->second;
        }
        bool const root = made.step.because.empty();
        bool const known = proofs[i] == Proof::confirmed || proofs[i] == Proof::together;
        answer.confirmed = answer.confirmed && (!root || known);
        answer.chain.push_back(std::move(made));
    }
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
    Target const target = findTarget(runs, solution, question, options, answer);
    answer.runs = 1;
    if (!target.event) {
        return answer; // the nearest miss is in it
    }
    answer.happened = true;
    Story const& story = target.story;
    std::vector<Candidate> const candidates = candidatesOf(story, answer.facts, solution, options.everything);
    SecondRuns second(runs, solution, target, options);
    std::vector<Proof> const proofs = second.test(candidates);
    answer.runs += second.runs();
    answer.complete = second.complete();
    tell(answer, story, proofs, options.everything);
    return answer;
}

} // namespace trembler::insight
