#include "lua/component/scripted_interaction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace trembler::lua {

ScriptedInteraction::ScriptedInteraction(std::shared_ptr<Script const> script, std::shared_ptr<ScriptLog> log)
    : Component(*script->info), restless_(script->manifest.restless), script_(std::move(script)),
      log_(std::move(log)), source_(script_->role->open()), kept_(script_->manifest) {}

ScriptedInteraction::~ScriptedInteraction() = default;

void ScriptedInteraction::bind(Store& store, Channels& channels) {
    store_ = &store;
    bindReads(store);
    targets_.forget();
    source_->attach(channels, caller());
    sleep();
}

void ScriptedInteraction::bindReads(Store& store) {
    homes_.clear();
    watches_.resize(script_->reads.size());
    for (DeclaredProperty const& property : script_->reads) {
        Home home;
        if (property.ofObjects()) {
            home.column = &store.column(*property.info);
        } else {
            home.slot = &store.slot(*property.info);
        }
        watches_[homes_.size()].version = home.versionPlace();
        homes_.push_back(home);
    }
}

/// Lets the world skip the component while hasWork() is false. To be called after every change of data on
/// which hasWork() depends.
void ScriptedInteraction::sleep() {
    if (off_ || resting_) {
        waitFor({});
    } else if (first_ || restless_) {
        wake();
    } else {
        waitFor(watches_);
    }
}

bool ScriptedInteraction::hasWork() const {
    if (off_ || resting_) {
        return false;
    }
    if (first_ || restless_) {
        return true;
    }
    return std::any_of(watches_.begin(), watches_.end(), [](Watch const& w) { return w.changed(); });
}

std::size_t ScriptedInteraction::workload() const {
    std::size_t rows = 0;
    for (Home const& home : homes_) {
        rows += home.column == nullptr ? 0 : home.column->size();
    }
    return rows;
}

void ScriptedInteraction::run(FrameContext const& context) {
    openSinks(context, Phase::interaction);
    source_->begin();
    try {
        applyScript(context);
    } catch (...) { // of the host: errors of the script are results
        source_->fail();
        sinks_.clear();
        throw;
    }
    source_->end();
    for (Watch& watch : watches_) {
        watch.seen = *watch.version;
    }
    first_ = false;
    sleep();
}

void ScriptedInteraction::applyScript(FrameContext const& context) {
    bool const same = targets_.update(*script_, homes_);
    std::vector<Target> const& targets = targets_.all();
    if (!targets.empty() && !std::exchange(applied_, true)) {
        log_->noteApplied(script_->manifest.name);
    }
    std::optional<ScriptError> failed;
    if (targets.size() > mostPairs && script_->manifest.application == Application::pairs) {
        failed = ScriptError{
            fmt::format("the script is applied to more than {} pairs of objects in a turn", mostPairs),
            {},
            true};
    } else if (!targets.empty() && !turns_) {
        turns_ = std::make_unique<Turns>(script_);
        failed = turns_->broken();
    }
    if (!failed && !targets.empty()) {
        kept_.keepOnly([this](ObjectId id) { return store_->alive(id); });
        TurnContext turn{.store = *store_,
                         .homes = homes_,
                         .kept = kept_,
                         .source = *source_,
                         .sink = sinks_.empty() ? nullptr : &sinks_.front(),
                         .duration = context.duration,
                         .sameTargets = same,
                         .sameFrame = frame_ == context.when.frame,
                         .log = [&](std::string const& line) {
                             log_->add({.script = script_->manifest.name,
                                        .frame = context.when.frame,
                                        .error = false,
                                        .text = line,
                                        .traceback = {}});
                         }};
        frame_ = context.when.frame;
        failed = turns_->run(turn, targets);
    }
    if (failed) {
        switchOff(context, *failed);
    }
}

void ScriptedInteraction::switchOff(FrameContext const& context, ScriptError const& failed) {
    source_->withdraw();
    off_ = true;
    turns_.reset();
    if (!sinks_.empty()) {
        (void)sinks_.front().record("switched off: " + failed.message, {}, {});
    }
    log_->add({.script = script_->manifest.name,
               .frame = context.when.frame,
               .error = true,
               .text = failed.message,
               .traceback = failed.traceback});
}

void ScriptedInteraction::hashState(StateHash& hash) const {
    hash.value(off_ || resting_);
    kept_.hash(hash);
}

} // namespace trembler::lua
