#include "insight/why/runs/question_target.hpp"

#include "insight/why/story/deed_steps.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/trace/tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace trembler::insight {
namespace {

/// Whether a step says something about the state of an object.
bool tellsState(StepKind kind) {
    return kind != StepKind::goal && kind != StepKind::other;
}

Event const& eventNumbered(std::span<Event const> events, std::uint64_t number) {
    if (number < 1 || number > events.size()) {
        throw std::invalid_argument(fmt::format("--event {}: the run has the events 1 to {}; `trembler run "
                                                "--trace FILE` lists them",
                                                number, events.size()));
    }
    return events[number - 1];
}

Event const& eventOf(std::span<Event const> events, std::string const& object, double seconds,
                     SceneFacts const& facts, World const& world) {
    if (!world.store().find(object).valid() && !facts.places.contains(object)) {
        std::vector<std::string> names;
        for (auto const& [name, place] : facts.places) {
            names.push_back(name);
        }
        throw std::invalid_argument(
            fmt::format("--object {}: there is no such object{}", object, didYouMean(object, names)));
    }
    auto const last = static_cast<std::uint64_t>(std::llround(seconds / frameDuration));
    Event const* found = nullptr;
    for (Event const& event : events) {
        auto const kind = kindOf(event);
        // A pull is about the object, not about its magnet.
        auto const end =
            kind && isPull(*kind) && !event.objects.empty() ? event.objects.begin() + 1 : event.objects.end();
        if (event.frame <= last && kind && tellsState(*kind) &&
            std::find(event.objects.begin(), end, object) != end) {
            found = &event;
        }
    }
    if (found == nullptr) {
        throw NothingHappened(
            fmt::format("--object {}: nothing has happened to it by {} s", object, seconds));
    }
    return *found;
}

/// The last event up to the frame that may be what was seen.
Event const& eventOf(std::span<Event const> events, SightedEvent const& seen) {
    Event const* found = nullptr;
    for (Event const& event : events) {
        auto const kind = kindOf(event);
        bool const named = std::all_of(seen.objects.begin(), seen.objects.end(), [&](auto const& name) {
            return std::find(event.objects.begin(), event.objects.end(), name) != event.objects.end();
        });
        if (event.frame <= seen.frame && named && kind &&
            std::find(seen.kinds.begin(), seen.kinds.end(), *kind) != seen.kinds.end()) {
            found = &event;
        }
    }
    if (found == nullptr) {
        throw NothingHappened(fmt::format("no such event has happened by frame {}", seen.frame));
    }
    return *found;
}

std::vector<std::string> goalIds(RunResult const& result) {
    std::vector<std::string> ids;
    for (GoalStatus const& goal : result.goals) {
        ids.push_back(goal.id);
    }
    return ids;
}

/// The goal that is asked about: the one stated, or the first that was not met, or the last that was.
std::string chosenGoal(RunResult const& result, Question const& question) {
    if (result.goals.empty()) {
        throw std::invalid_argument("the level has no goals; ask with --event or --object");
    }
    if (question.goal) {
        std::vector<std::string> const ids = goalIds(result);
        if (std::find(ids.begin(), ids.end(), *question.goal) == ids.end()) {
            throw std::invalid_argument(
                fmt::format("--goal {}: there is no such goal; expected {}", *question.goal, listed(ids)));
        }
        return *question.goal;
    }
    GoalStatus const* last = nullptr;
    for (GoalStatus const& goal : result.goals) {
        if (!goal.frame) {
            return goal.id;
        }
        last = last == nullptr || *goal.frame >= *last->frame ? &goal : last;
    }
    return last->id;
}

Event const& askedEvent(std::span<Event const> events, Question const& question, SceneFacts const& facts,
                        World const& world) {
    if (question.event) {
        return eventNumbered(events, *question.event);
    }
    return question.sighted ? eventOf(events, *question.sighted)
                            : eventOf(events, *question.object, question.at, facts, world);
}

/// Whether nothing that happens later matters to the question.
bool isDecided(LevelRun const& run, Question const& question) {
    if (question.object) {
        return run.world().time() >= question.at;
    }
    if (question.sighted) {
        return run.world().frame() >= question.sighted->frame;
    }
    std::vector<GoalStatus> const& goals = run.judge().status();
    return question.goal && std::any_of(goals.begin(), goals.end(), [&](GoalStatus const& goal) {
               return goal.id == *question.goal && goal.frame.has_value();
           });
}

void describe(Target& target, std::span<Event const> events, Event const& event, SceneFacts const& facts,
              Solution const& solution) {
    target.event = event.id;
    target.component = event.component;
    target.what = event.event;
    target.objects = event.objects;
    target.frame = event.frame;
    target.times = std::max<std::size_t>(1, timesIn(events, target, event.frame));
    target.story = withDeeds(storyOf(events, event.id, facts), solution, facts, events);
}

} // namespace

std::size_t timesIn(std::span<Event const> events, Target const& target, std::uint64_t frame,
                    PlacedNames const& names) {
    // A goal that is met is the same goal whatever objects meet it, as one that counts.
    bool const isGoal = target.goal.has_value();
    return static_cast<std::size_t>(std::count_if(events.begin(), events.end(), [&](Event const& event) {
        return event.frame <= frame && event.event == target.what && event.component == target.component &&
               (isGoal || std::equal(event.objects.begin(), event.objects.end(), target.objects.begin(),
                                     target.objects.end(), [&](auto const& here, auto const& wanted) {
                                         return names.inWhole(here) == wanted;
                                     }));
    }));
}

Target findTarget(LevelRuns const& runs, Solution const& solution, Question const& question,
                  AskOptions const& options, Answer& answer) {
    Target target;
    std::unique_ptr<MissMeter> meter;
    bool const aboutGoal = !question.event && !question.object && !question.sighted;
    bool stopped = false;
    std::optional<std::string> nothing;
    std::string fault;
    RunObserver observer;
    observer.begin = [&](LevelRun const& run) {
        answer.facts = factsOf(run);
        if (aboutGoal) {
            meter = std::make_unique<MissMeter>(runs.level(), run.world(), MissMeter::For::explanation);
        }
    };
    observer.frame = [&](LevelRun const& run) {
        target.places.look(run.world());
        answer.facts.pulls.look(run.world(), answer.facts.tied);
        if (meter != nullptr) {
            meter->look(run.world());
        }
        stopped = options.stop && options.stop();
        return !stopped && !isDecided(run, question);
    };
    observer.end = [&](LevelRun const& run) {
        if (stopped) {
            answer.complete = false;
            return;
        }
        Tracer const* const tracer = run.world().tracer();
        std::span<Event const> const events = tracer->events();
        for (Event const& event : events) {
            if (kindOf(event) == StepKind::contact) {
                answer.facts.firstTouch.emplace(event.objects, event.frame);
            }
        }
        if (!aboutGoal) {
            try {
                describe(target, events, askedEvent(events, question, answer.facts, run.world()),
                         answer.facts, solution);
            } catch (NothingHappened const& error) { // no fault of the run
                nothing = error.what();
            }
            return;
        }
        RunResult now;
        now.goals = run.judge().status();
        now.solved = run.judge().solved();
        target.goal = chosenGoal(now, question);
        answer.goal = *target.goal;
        auto const met = std::find_if(events.begin(), events.end(), [&](Event const& event) {
            return event.phase == Phase::goal && event.event == "goal met: " + *target.goal;
        });
        if (met != events.end()) {
            describe(target, events, *met, answer.facts, solution);
        }
        for (std::size_t i = 0; i < meter->result().goals.size(); ++i) {
            if (meter->result().goals[i].id == *target.goal && met == events.end()) {
                answer.nearest = meter->explained(i);
            }
        }
    };
    RunLimits limits;
    limits.frames = options.frames;
    limits.stopWhenSolved = aboutGoal;
    limits.trace = true;
    RunResult const result = runs.run({solution}, limits, observer);
    if (result.fault) {
        throw std::invalid_argument(*result.fault);
    }
    if (nothing) {
        throw NothingHappened(*nothing);
    }
    answer.frames = result.frames;
    return target;
}

} // namespace trembler::insight
