#include "insight/why/runs/goal_runs.hpp"

#include "insight/why/runs/side_by_side.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/electricity/properties/electrical.hpp"

#include <algorithm>
#include <memory>

namespace trembler::insight {
namespace goal_runs {
namespace {

constexpr double clearlyNearer = 0.9; // of the measure

/// False for no pairs.
bool allTouch(World const& world, std::vector<std::pair<std::string, std::string>> const& pairs) {
    Contacts const* const contacts = world.find<Contacts>();
    return contacts != nullptr && !pairs.empty() &&
           std::all_of(pairs.begin(), pairs.end(), [&](auto const& pair) {
               ObjectId const a = world.store().find(pair.first);
               ObjectId const b = world.store().find(pair.second);
               return std::any_of(contacts->current.begin(), contacts->current.end(),
                                  [&](TouchingPair const& one) {
                                      return (one.a == a && one.b == b) || (one.a == b && one.b == a);
                                  });
           });
}

} // namespace
} // namespace goal_runs

std::vector<GoalRun> GoalRuns::run(std::vector<Variation> const& variations, GoalWatch const& watch) {
    auto const stopped = [&] { return options_.stop && options_.stop(); };
    if (!answer_.complete || stopped()) {
        answer_.complete = false;
        return {};
    }
    std::vector<GoalRun> results(variations.size());
    sideBySide(variations.size(), threadsFor(options_.threads),
               [&](std::size_t i) { results[i] = one(variations[i], watch); });
    answer_.runs += variations.size();
    bool const goesOn = !options_.progress || options_.progress(answer_.runs, answer_.runs);
    if (!goesOn || stopped()) {
        answer_.complete = false;
        return {};
    }
    return results;
}

GoalRun GoalRuns::one(Variation const& variation, GoalWatch const& watch) const {
    GoalRun result;
    std::unique_ptr<MissMeter> meter;
    std::uint64_t touching = 0; // frames in a row
    RunObserver observer;
    observer.begin = [&](LevelRun const& run) {
        meter = std::make_unique<MissMeter>(runs_.level(), run.world());
    };
    observer.frame = [&](LevelRun const& run) {
        World const& world = run.world();
        meter->look(world);
        if (auto const* const state = world.find<ElectricalState>(); state != nullptr) {
            ObjectId const id = world.store().find(watch.device);
            result.deviceWasOn = result.deviceWasOn || (id.valid() && state->isOn(id));
        }
        touching = goal_runs::allTouch(world, watch.pairs) ? touching + 1 : 0;
        result.touched = result.touched || touching >= Aftermath::bounce;
        return !(options_.stop && options_.stop());
    };
    observer.end = [&](LevelRun const&) {
        for (GoalMiss const& goal : meter->result().goals) {
            if (goal.id == goal_) {
                result.met = goal.met.has_value();
                result.nearer = result.met || goal.nearest.measure < goal_runs::clearlyNearer * measure_;
            }
        }
    };
    RunResult const ran =
        runs_.run(variation, {.frames = options_.frames, .stopWhenSolved = true, .trace = false}, observer);
    return ran.fault ? GoalRun{} : result;
}

void addWhatCameNearer(LevelRuns const& runs, AskOptions const& options, Answer& answer,
                       std::vector<Variation> const& variations,
                       std::function<Miss(std::size_t index)> const& missOf) {
    if (variations.empty()) {
        return;
    }
    Miss& nearest = answer.nearest->nearest;
    GoalRuns again(runs, answer.nearest->id, nearest.measure, options, answer);
    std::vector<GoalRun> const tested = again.run(variations, {});
    for (std::size_t i = 0; i < tested.size(); ++i) {
        if (tested[i].nearer) {
            Miss miss = missOf(i);
            miss.ifClosed = tested[i].shown();
            nearest.besides.push_back(std::move(miss));
        }
    }
}

} // namespace trembler::insight
