#include "insight/run/level_runs.hpp"

#include "insight/run/contacts_left_out.hpp"
#include "insight/run/devices_left_out.hpp"
#include "insight/run/dips_left_out.hpp"
#include "insight/run/reduced_level.hpp"
#include "lua/attach/live_script.hpp"
#include "lua/attach/register.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/session/playback.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace trembler::insight {
namespace {

constexpr std::uint64_t minute = 3600; // frames

/// The entries that are left out of a running world.
class LeftOutLater {
public:
    explicit LeftOutLater(std::vector<LeftOut> const& wanted) : wanted_(wanted) {}

    /// Leaves out the entries that are due in the next frame.
    void beforeFrame(LevelRun& run) {
        std::uint64_t const next = run.world().frame() + 1;
        std::vector<Dip> dips;
        std::vector<ObjectId> stilled;
        std::vector<ObjectId> held;
        bool contacts = false;
        for (; done_ < wanted_.size() && wanted_[done_].from <= next; ++done_) {
            LeftOut const& one = wanted_[done_];
            bool const isPair = one.kind == LeftOut::Kind::dip || one.kind == LeftOut::Kind::contact;
            Store const& store = run.world().store();
            ObjectPair const pair{store.find(one.a), isPair ? store.find(one.b) : ObjectId{}};
            if (!pair.first.valid() || (isPair && !pair.second.valid())) {
                continue; // it does not exist in this run
            }
            if (one.kind == LeftOut::Kind::dip) {
                dips.push_back(pair);
            } else if (one.kind == LeftOut::Kind::device) {
                stilled.push_back(pair.first);
            } else if (one.kind == LeftOut::Kind::switching) {
                held.push_back(pair.first);
            } else {
                pairs_.push_back(pair);
                contacts = true;
            }
        }
        if (!dips.empty()) {
            run.alter("dips are left out", [&](World& world) { leaveOutDips(world, dips); });
        }
        if (contacts) {
            run.alter("contacts are left out", [&](World& world) { leaveOutContacts(world, pairs_); });
        }
        if (!stilled.empty()) {
            run.alter("devices are left out", [&](World& world) { stillDevices(world, stilled); });
        }
        if (!held.empty()) {
            run.alter("magnets are not switched", [&](World& world) { holdMagnets(world, held); });
        }
    }

private:
    std::vector<LeftOut> const& wanted_; // ascending by their first frame
    std::size_t done_ = 0;
    std::vector<ObjectPair> pairs_;
};

} // namespace

LevelRuns::LevelRuns(GameData const& data, LevelFile level, std::map<std::string, std::string> const& detail)
    : LevelRuns(data.registry, data.parts, std::move(level)) {
    data_ = &data;
    for (auto const& [effect, name] : detail) {
        level_.detail[effect] = name;
    }
}

LevelRuns::LevelRuns(Registry const& registry, PartLibrary const& parts, LevelFile level)
    : registry_(registry), parts_(parts), data_(nullptr), level_(std::move(level)) {
    // Every run copies the level.
    level_.solutions.clear();
    level_.hints.clear();
    level_.teaching.clear();
    level_.texts = {};
    level_.editor = nullptr;
}

std::uint64_t LevelRuns::framesFor(Solution const& solution) {
    return solution.frames ? static_cast<std::uint64_t>(*solution.frames) : minute;
}

void LevelRuns::carryOver(lua::LiveScripts const& to, Problems& problems) const {
    if (data_->scripts == nullptr) {
        return;
    }
    for (auto const& live : data_->scripts->all()) {
        lua::LiveScript* const own = to.find(live->name());
        if (own == nullptr) {
            continue;
        }
        std::string const& text = live->script().manifest.source;
        if (text != own->script().manifest.source) {
            if (auto version = to.read(*own, text, problems)) {
                own->publish(std::move(version));
            }
        }
        own->setOn(live->on());
    }
}

Registry const& LevelRuns::registryWithout(std::set<std::string> const& effects) const {
    if (effects.empty()) {
        return registry_;
    }
    std::scoped_lock const lock(registriesMutex_);
    auto& made = registries_[effects];
    if (made == nullptr) {
        auto registry = std::make_unique<Registry>();
        registerEffects(*registry, effects);
        if (data_ != nullptr) {
            Problems problems;
            auto const scripts = lua::registerMods(*registry, data_->mods, data_->scriptLog, problems);
            problems.throwIfAny(); // a script calls the effect
            carryOver(*scripts, problems);
            problems.throwIfAny();
        }
        made = std::move(registry);
    }
    return *made;
}

RunResult LevelRuns::run(Variation const& variation, RunLimits const& limits,
                         RunObserver const& observer) const {
    RunResult result;
    try {
        ReducedLevel const left = reduced(level_, variation);
        WorldOptions options;
        options.detail = left.level.detail;
        options.trace = limits.trace;
        LevelRun run(registryWithout(left.effects), parts_, left.level, left.solution.placements, options,
                     left.solution.wires);
        Playback const playback(left.solution.inputs, left.solution.changes);
        LeftOutLater later(left.later);
        if (observer.begin) {
            observer.begin(run);
        }
        run.begin();
        if (variation.handStrength) {
            run.alter("hands of another strength", [&](World& world) {
                ObjectId const owner = world.store().find("world");
                world.store().column<Hands>().set(owner, {*variation.handStrength});
            });
        }
        bool goesOn = true;
        while (goesOn && run.world().frame() < limits.frames &&
               !(limits.stopWhenSolved && run.judge().solved())) {
            later.beforeFrame(run);
            playback.feed(run);
            run.step();
            goesOn = !observer.frame || observer.frame(run);
        }
        result.frames = run.world().frame();
        result.solved = run.judge().solved();
        result.solvedFrame = run.judge().solvedFrame();
        result.goals = run.judge().status();
        result.stateHash = run.world().stateHash();
        if (observer.end) {
            observer.end(run);
        }
    } catch (InputError const& error) {
        result = {};
        result.fault =
            error.diagnostics().empty() ? std::string(error.what()) : error.diagnostics().front().message;
    } catch (std::exception const& error) { // the world of this run cannot go on
        result = {};
        result.fault = error.what();
    }
    return result;
}

} // namespace trembler::insight
