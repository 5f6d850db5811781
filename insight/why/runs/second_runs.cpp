#include "insight/why/runs/second_runs.hpp"

#include "insight/run/reduced_level.hpp"
#include "insight/why/runs/side_by_side.hpp"
#include "insight/why/story/deed_steps.hpp"
#include "runtime/trace/tracer.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
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
std::vector<bool> happening(Story const& story, std::span<Event const> events, PlacedNames const& names) {
    std::map<Signature, std::size_t> times;
    for (Event const& event : events) {
        // A contact may be brief in one run and last in another.
        bool const contact = kindOf(event) == StepKind::contact;
        std::vector<std::string> objects = event.objects;
        std::transform(objects.begin(), objects.end(), objects.begin(),
                       [&](std::string const& name) { return names.inWhole(name); });
        ++times[{contact ? "contact" : event.event, std::move(objects)}];
    }
    std::map<Signature, std::size_t> wanted;
    std::vector<bool> found;
    for (Step const& step : story.steps) {
        Signature const one{step.kind == StepKind::contact ? "contact" : step.what, step.objects};
        bool const before = step.kind == StepKind::placed || step.kind == StepKind::wired;
        found.push_back(before || ++wanted[one] <= times[one]);
    }
    return found;
}

} // namespace

SecondRuns::SecondRuns(LevelRuns const& runs, Solution const& solution, Target const& target,
                       SceneFacts const& facts, AskOptions const& options)
    : runs_(runs), solution_(solution), target_(target), facts_(facts), options_(options),
      horizon_(horizonOf(target.frame)), threads_(threadsFor(options.threads)) {}

bool SecondRuns::noteRun(std::size_t planned) {
    std::scoped_lock const lock(noting_);
    if (!complete_) {
        return false;
    }
    ++done_;
    if (options_.progress && !options_.progress(done_, std::max(done_, planned))) {
        complete_ = false;
    }
    return true;
}

bool SecondRuns::stops() {
    if (options_.stop && options_.stop()) {
        complete_ = false;
    }
    return !complete_;
}

SecondRuns::Outcome SecondRuns::without(std::vector<Candidate> const& candidates, Set const& left) {
    Variation variation{solution_, {}};
    for (std::size_t const i : left) {
        variation.leftOut.insert(variation.leftOut.end(), candidates[i].leftOut.begin(),
                                 candidates[i].leftOut.end());
    }
    std::sort(variation.leftOut.begin(), variation.leftOut.end());
    variation.leftOut.erase(std::unique(variation.leftOut.begin(), variation.leftOut.end()),
                            variation.leftOut.end());
    PlacedNames const names = namesWithout(runs_.level(), variation);
    Outcome outcome;
    bool stopped = false;
    std::size_t seen = 0; // events of the trace
    std::size_t times = 0;
    RunObserver observer;
    observer.frame = [&](LevelRun const& run) {
        std::span<Event const> const events = run.world().tracer()->events();
        times += timesIn(events.subspan(seen), target_, horizon_, names);
        seen = events.size();
        stopped = stops();
        return !stopped && times < target_.times;
    };
    observer.end = [&](LevelRun const& run) {
        bool const happens = times >= target_.times;
        outcome.kind = happens ? Outcome::Kind::happens : Outcome::Kind::prevented;
        if (!happens) {
            outcome.steps = happening(target_.story, run.world().tracer()->events(), names);
        }
    };
    RunResult const result =
        runs_.run(variation, {.frames = horizon_, .stopWhenSolved = false, .trace = true}, observer);
    if (result.fault || stopped) {
        outcome = {};
    }
    return outcome;
}

std::vector<SecondRuns::Outcome> SecondRuns::without(std::vector<Candidate> const& candidates,
                                                     std::vector<Set> const& sets, bool note) {
    std::vector<Outcome> outcomes(sets.size());
    sideBySide(sets.size(), threads_, [&](std::size_t i) {
        if (stops()) {
            return;
        }
        Outcome outcome = without(candidates, sets[i]);
        if (!stops() && (!note || noteRun(sets.size()))) {
            outcomes[i] = std::move(outcome);
        }
    });
    return outcomes;
}

std::size_t SecondRuns::firstPreventing(std::vector<Candidate> const& candidates,
                                        std::vector<Set> const& sets, Outcome& outcome) {
    auto const many = static_cast<std::size_t>(threads_);
    for (std::size_t begin = 0; begin < sets.size() && complete_; begin += many) {
        std::size_t const end = std::min(sets.size(), begin + many);
        std::vector<Set> const some(sets.begin() + static_cast<std::ptrdiff_t>(begin),
                                    sets.begin() + static_cast<std::ptrdiff_t>(end));
        std::vector<Outcome> outcomes = without(candidates, some, false);
        for (std::size_t i = 0; i < outcomes.size() && complete_; ++i) {
            noteRun(done_ + sets.size() - begin - i); // sequential runs would not have begun the later sets
            if (outcomes[i].kind == Outcome::Kind::prevented) {
                outcome = std::move(outcomes[i]);
                return begin + i;
            }
        }
    }
    return sets.size();
}

void SecondRuns::makeSmallest(std::vector<Candidate> const& candidates, Set& set, Outcome& outcome) {
    std::size_t parts = 2;
    while (set.size() >= 2 && complete_) {
        std::size_t const size = (set.size() + parts - 1) / parts;
        std::vector<Set> rests;
        for (std::size_t begin = 0; begin < set.size(); begin += size) {
            Set& rest = rests.emplace_back();
            for (std::size_t i = 0; i < set.size(); ++i) {
                if (i < begin || i >= begin + size) {
                    rest.push_back(set[i]);
                }
            }
        }
        std::size_t const found = firstPreventing(candidates, rests, outcome);
        if (found < rests.size()) {
            set = std::move(rests[found]);
            parts = std::max<std::size_t>(2, parts - 1);
        } else if (size == 1) {
            break;
        } else {
            parts = std::min(set.size(), parts * 2);
        }
    }
}

void SecondRuns::noteVanished(Tested& tested, std::vector<std::size_t> const& from, Outcome const& outcome,
                              Proof proof) const {
    std::vector<Step> const& steps = target_.story.steps;
    std::vector<bool> follows(steps.size());
    for (std::size_t const i : from) {
        follows[i] = true;
    }
    std::set<std::size_t> effects; // that no step of the trace connects with the cause
    for (std::size_t i = 0; i < steps.size(); ++i) {
        bool const after =
            effects.contains(i) || std::any_of(steps[i].because.begin(), steps[i].because.end(),
                                               [&](std::size_t cause) { return follows[cause]; });
        if (follows[i] || after) {
            if (auto const effect = tested.effects.find(i); effect != tested.effects.end()) {
                effects.insert(effect->second);
            }
        }
        if (follows[i] || !after) {
            continue;
        }
        follows[i] = true;
        bool const vanished = i < outcome.steps.size() && !outcome.steps[i];
        if ((vanished || i == target_.story.asked) && tested.proofs[i] == Proof::traced) {
            tested.proofs[i] = proof;
        }
    }
}

void SecondRuns::note(Tested& tested, std::vector<std::size_t> const& steps, Outcome const& outcome,
                      Proof proof) {
    Story const& story = target_.story;
    for (std::size_t const step : steps) {
        tested.proofs[step] = proof;
        if (story.steps[step].traced) {
            continue;
        }
        std::size_t effect = step + 1;
        while (effect < story.asked &&
               (!story.steps[effect].traced || story.steps[effect].bridge || outcome.steps[effect] ||
                tested.proofs[effect] == Proof::refuted || isGranted(story.steps[effect], facts_))) {
            ++effect;
        }
        tested.effects[bridgeFor(tested, step, effect, outcome).value_or(step)] = effect;
    }
    noteVanished(tested, steps, outcome, proof);
}

void SecondRuns::testTogether(Tested& tested, std::vector<Candidate> const& candidates, Set some) {
    if (some.size() < 2 || !complete_) {
        return;
    }
    Outcome outcome = without(candidates, some);
    noteRun(done_ + 1);
    if (outcome.kind != Outcome::Kind::prevented) {
        return;
    }
    makeSmallest(candidates, some, outcome);
    std::vector<std::size_t> steps;
    for (std::size_t const i : some) {
        steps.insert(steps.end(), candidates[i].steps.begin(), candidates[i].steps.end());
    }
    note(tested, steps, outcome, Proof::together);
}

SecondRuns::Tested SecondRuns::test(std::vector<Candidate> const& candidates) {
    std::vector<Step> const& steps = target_.story.steps;
    Tested tested{std::vector<Proof>(steps.size(), Proof::traced), {}};
    std::vector<Set> alone;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        alone.push_back({i});
    }
    std::vector<Outcome> const outcomes = without(candidates, alone, true);
    Set refuted;
    Set deeds; // among them
    bool deedKnown = false;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        bool const deed = isDeed(steps[candidates[i].steps.front()].kind);
        if (outcomes[i].kind == Outcome::Kind::happens) {
            for (std::size_t const step : candidates[i].steps) {
                tested.proofs[step] = Proof::refuted;
            }
            refuted.push_back(i);
            if (deed) {
                deeds.push_back(i);
            }
        } else if (outcomes[i].kind == Outcome::Kind::prevented) {
            deedKnown = deedKnown || deed;
        }
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (outcomes[i].kind == Outcome::Kind::prevented) {
            note(tested, candidates[i].steps, outcomes[i], Proof::confirmed);
        }
    }
    if (!deedKnown) {
        testTogether(tested, candidates, deeds);
    }
    if (deedKnown || deeds.size() < refuted.size()) {
        testTogether(tested, candidates, refuted);
    }
    return tested;
}

} // namespace trembler::insight
