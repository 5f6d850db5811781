#include "insight/why/second_runs.hpp"

#include "runtime/trace/tracer.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace trembler::insight {
namespace {

/// What was asked about counts as happened in another run if it happens there by then: a quarter of the time
/// later, and at least a second.
std::uint64_t horizonOf(std::uint64_t frame) {
    return frame + std::max<std::uint64_t>(60, frame / 4);
}

using Signature = std::pair<std::string, std::vector<std::string>>;

/// Which steps of a story happen in a trace, as often as in the story.
std::vector<bool> happening(Story const& story, std::span<Event const> events) {
    std::map<Signature, std::size_t> times;
    for (Event const& event : events) {
        // A contact may be brief in one run and last in another.
        bool const contact = kindOf(event) == StepKind::contact;
        ++times[{contact ? "contact" : event.event, event.objects}];
    }
    std::map<Signature, std::size_t> wanted;
    std::vector<bool> found;
    for (Step const& step : story.steps) {
        Signature const one{step.kind == StepKind::contact ? "contact" : step.what, step.objects};
        found.push_back(step.kind == StepKind::placed || ++wanted[one] <= times[one]);
    }
    return found;
}

} // namespace

SecondRuns::SecondRuns(LevelRuns const& runs, Solution const& solution, Target const& target,
                       AskOptions const& options)
    : runs_(runs), solution_(solution), target_(target), options_(options),
      horizon_(horizonOf(target.frame)) {}

void SecondRuns::noteRun(std::size_t planned) {
    ++done_;
    if (options_.progress && !options_.progress(done_, std::max(done_, planned))) {
        complete_ = false;
    }
}

SecondRuns::Outcome SecondRuns::without(std::vector<Candidate> const& candidates,
                                        std::vector<std::size_t> const& left) {
    Variation variation{solution_, {}};
    for (std::size_t const i : left) {
        variation.leftOut.insert(variation.leftOut.end(), candidates[i].leftOut.begin(),
                                 candidates[i].leftOut.end());
    }
    std::sort(variation.leftOut.begin(), variation.leftOut.end());
    variation.leftOut.erase(std::unique(variation.leftOut.begin(), variation.leftOut.end()),
                            variation.leftOut.end());
    Outcome outcome;
    RunObserver observer;
    observer.end = [&](LevelRun const& run) {
        std::span<Event const> const events = run.world().tracer()->events();
        outcome.happens = timesIn(events, target_, horizon_) >= target_.times;
        outcome.steps = happening(target_.story, events);
    };
    RunResult const result =
        runs_.run(variation, {.frames = horizon_, .stopWhenSolved = false, .trace = true}, observer);
    if (result.fault) { // it cannot be run without it: nothing is known
        outcome = {};
    }
    return outcome;
}

std::vector<std::size_t> SecondRuns::smallestOf(std::vector<Candidate> const& candidates,
                                                std::vector<std::size_t> set) {
    std::size_t parts = 2;
    while (set.size() >= 2 && complete_) {
        std::size_t const size = (set.size() + parts - 1) / parts;
        bool reduced = false;
        for (std::size_t begin = 0; begin < set.size() && !reduced && complete_; begin += size) {
            std::vector<std::size_t> rest;
            for (std::size_t i = 0; i < set.size(); ++i) {
                if (i < begin || i >= begin + size) {
                    rest.push_back(set[i]);
                }
            }
            Outcome const outcome = without(candidates, rest);
            noteRun(done_ + set.size());
            if (!outcome.happens) {
                set = std::move(rest);
                parts = std::max<std::size_t>(2, parts - 1);
                reduced = true;
            }
        }
        if (!reduced) {
            if (size == 1) {
                break;
            }
            parts = std::min(set.size(), parts * 2);
        }
    }
    return set;
}

void SecondRuns::noteVanished(std::vector<Proof>& proofs, std::vector<std::size_t> const& from,
                              Outcome const& outcome, Proof proof) const {
    std::vector<Step> const& steps = target_.story.steps;
    std::vector<bool> follows(steps.size());
    for (std::size_t const i : from) {
        follows[i] = true;
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        bool const after = std::any_of(steps[i].because.begin(), steps[i].because.end(),
                                       [&](std::size_t cause) { return follows[cause]; });
        if (follows[i] || !after) {
            continue;
        }
        follows[i] = true;
        bool const vanished = i < outcome.steps.size() && !outcome.steps[i];
        if ((vanished || i == target_.story.asked) && proofs[i] == Proof::traced) {
            proofs[i] = proof;
        }
    }
}

std::vector<Proof> SecondRuns::test(std::vector<Candidate> const& candidates) {
    std::vector<Proof> proofs(target_.story.steps.size(), Proof::traced);
    std::vector<std::size_t> refuted;
    auto const mark = [&](std::size_t candidate, Proof proof) {
        for (std::size_t const step : candidates[candidate].steps) {
            proofs[step] = proof;
        }
    };
    std::vector<std::pair<std::size_t, Outcome>> needed;
    for (std::size_t i = 0; i < candidates.size() && complete_; ++i) {
        Outcome outcome = without(candidates, {i});
        noteRun(candidates.size());
        if (outcome.happens && !outcome.steps.empty()) {
            mark(i, Proof::refuted);
            refuted.push_back(i);
        } else if (!outcome.happens) {
            mark(i, Proof::confirmed);
            needed.emplace_back(i, std::move(outcome));
        }
    }
    for (auto const& [i, outcome] : needed) {
        noteVanished(proofs, candidates[i].steps, outcome, Proof::confirmed);
    }
    if (refuted.size() < 2 || !complete_) {
        return proofs;
    }
    Outcome const all = without(candidates, refuted);
    noteRun(candidates.size() + 1);
    if (all.happens) {
        return proofs;
    }
    std::vector<std::size_t> const smallest = smallestOf(candidates, refuted);
    std::vector<std::size_t> steps;
    for (std::size_t const i : smallest) {
        mark(i, Proof::together);
        steps.insert(steps.end(), candidates[i].steps.begin(), candidates[i].steps.end());
    }
    noteVanished(proofs, steps, without(candidates, smallest), Proof::together);
    noteRun(done_ + 1);
    return proofs;
}

} // namespace trembler::insight
