#include "insight/ablation/needs.hpp"

#include "insight/run/reduced_level.hpp"
#include "insight/trial/solution_text.hpp"
#include "insight/trial/trial.hpp"
#include "puzzle/data/effects.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>

namespace trembler::insight {
namespace {

/// A placement, wire or deed, which can be left out of a solution as a whole.
struct Entry {
    std::string words;
    std::vector<LeftOut> parts;
};

std::vector<Entry> entriesOf(Solution const& solution) {
    std::vector<Entry> entries;
    // Deeds and wires first, as they name placed parts; later placements before earlier ones.
    for (Deed const& deed : deedsOf(solution)) {
        Entry entry{deed.what, {}};
        for (std::size_t const input : deed.inputs) {
            entry.parts.push_back(withoutInput(input));
        }
        entries.push_back(std::move(entry));
    }
    for (std::size_t i = 0; i < solution.wires.size(); ++i) {
        entries.push_back(
            {fmt::format("wire {}, {}", solution.wires[i].a, solution.wires[i].b), {withoutWire(i)}});
    }
    for (std::size_t i = solution.placements.size(); i-- > 0;) {
        entries.push_back({solution.placements[i].part, {withoutPlacement(i)}});
    }
    return entries;
}

std::vector<LeftOut> together(std::vector<LeftOut> all, std::vector<LeftOut> const& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

std::set<std::string> dispensableAtWork(LevelRuns const& runs, Solution const& solution, RunLimits limits) {
    std::set<std::string> atWork;
    RunObserver observer;
    observer.end = [&](LevelRun const& run) {
        for (ComponentStatus const& status : run.world().status()) {
            if (status.activity != Activity::absent) {
                atWork.emplace(status.info->text.effect);
            }
        }
    };
    (void)runs.run({solution, {}}, limits, observer);
    std::set<std::string> found;
    std::set<std::string> const dispensable = dispensableGameEffects();
    std::set_intersection(atWork.begin(), atWork.end(), dispensable.begin(), dispensable.end(),
                          std::inserter(found, found.end()));
    return found;
}

void describeLeast(Needs& needs) {
    std::set<std::string> parts;
    for (Placement const& placement : needs.least.placements) {
        parts.insert(placement.part);
    }
    needs.parts.assign(parts.begin(), parts.end());
    for (Deed const& deed : deedsOf(needs.least)) {
        needs.deeds.push_back(deed.what);
    }
}

} // namespace

std::vector<Deed> deedsOf(Solution const& solution) {
    using Kind = PlayerInput::Kind;
    std::vector<Deed> deeds;
    std::array<std::optional<std::size_t>, 2> held; // by hand, the deed that has begun
    for (std::size_t i = 0; i < solution.inputs.size(); ++i) {
        RecordedInput const& input = solution.inputs[i];
        if (input.kind == Kind::cut) {
            deeds.push_back({fmt::format("cut {}, {}", input.object, input.other), {i}});
            continue;
        }
        if (input.kind == Kind::remove) {
            deeds.push_back({fmt::format("remove {}", input.object), {i}});
            continue;
        }
        std::optional<std::size_t>& hand = held[input.hand == 1 ? 1 : 0];
        if (input.kind == Kind::grab) {
            hand = deeds.size();
            deeds.push_back({fmt::format("grab {}", input.object), {i}});
        } else if (hand) {
            deeds[*hand].inputs.push_back(i);
        }
        if (input.kind == Kind::release) {
            hand.reset();
        }
    }
    return deeds;
}

Needs needsOf(LevelRuns const& runs, Solution const& solution, std::uint64_t frames, EffectsToo effects) {
    Needs needs;
    RunResult const whole = runs.run({solution, {}}, {.frames = frames});
    needs.solves = whole.solved;
    needs.frame = whole.solvedFrame.value_or(0);
    if (!needs.solves) {
        return needs;
    }
    needs.leastFrame = needs.frame;
    RunLimits const limits{.frames = patience(needs.frame, frames)};
    std::vector<LeftOut> gone;
    std::vector<Entry> entries = entriesOf(solution);
    // An entry that was needed at first may become superfluous later, so all are tried until nothing changes.
    for (bool changed = true; changed;) {
        changed = false;
        for (auto entry = entries.begin(); entry != entries.end();) {
            std::vector<LeftOut> const more = together(gone, entry->parts);
            RunResult const rest = runs.run({solution, more}, limits);
            if (!rest.solved) {
                ++entry;
                continue;
            }
            gone = more;
            needs.leastFrame = rest.solvedFrame.value_or(0);
            needs.superfluous.push_back(entry->words);
            entry = entries.erase(entry);
            changed = true;
        }
    }
    needs.least = reducedSolution(runs.level(), solution, gone);
    describeLeast(needs);
    if (effects == EffectsToo::no) {
        return needs;
    }
    for (std::string const& effect : dispensableAtWork(runs, needs.least, limits)) {
        bool const needed = !runs.run({needs.least, {withoutEffect(effect)}}, limits).solved;
        (needed ? needs.effects : needs.idleEffects).push_back(effect);
    }
    return needs;
}

std::string toText(Needs const& needs) {
    return nlohmann::json{{"solves", needs.solves},           {"frame", needs.frame},
                          {"least", toText(needs.least)},     {"least_frame", needs.leastFrame},
                          {"superfluous", needs.superfluous}, {"effects", needs.effects},
                          {"idle", needs.idleEffects}}
        .dump();
}

Needs needsFrom(std::string const& text, Solution const& solution) {
    nlohmann::json const all = nlohmann::json::parse(text);
    Needs needs;
    needs.solves = all.at("solves").get<bool>();
    needs.frame = all.at("frame").get<std::uint64_t>();
    needs.least = solutionFrom(all.at("least").get<std::string>());
    needs.least.changes = solution.changes;
    needs.leastFrame = all.at("least_frame").get<std::uint64_t>();
    needs.superfluous = all.at("superfluous").get<std::vector<std::string>>();
    needs.effects = all.at("effects").get<std::vector<std::string>>();
    needs.idleEffects = all.at("idle").get<std::vector<std::string>>();
    if (needs.solves) {
        describeLeast(needs);
    }
    return needs;
}

} // namespace trembler::insight
