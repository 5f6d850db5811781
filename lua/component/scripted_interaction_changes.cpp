// Changes of a scripted interaction between two frames: its file is saved, or a player switches it or sets
// its parameters.
#include "lua/component/scripted_interaction.hpp"

#include <utility>

namespace trembler::lua {

ScriptedInteraction::ScriptedInteraction(ComponentInfo const& info, std::shared_ptr<Script const> script,
                                         std::shared_ptr<ScriptLog> log)
    : Component(info), restless_(script->manifest.restless), script_(std::move(script)), log_(std::move(log)),
      source_(script_->role->open()), kept_(script_->manifest) {}

void ScriptedInteraction::replace(Store& store, std::shared_ptr<Script const> script) {
    ScriptStore kept(script->manifest);
    kept.adopt(kept_);
    kept_ = std::move(kept);
    turns_.reset();
    frame_.reset();
    targets_ = {};
    restless_ = script->manifest.restless;
    script_ = std::move(script);
    bindReads(store);
    first_ = true;
    off_ = false;
    sleep();
}

void ScriptedInteraction::setOn(bool on) {
    if (on == !resting_) {
        return;
    }
    resting_ = !on;
    first_ = true;
    if (resting_) {
        source_->begin(); // as in a turn without calls
        source_->withdraw();
        source_->end();
    }
    sleep();
}

std::optional<TurnUsage> ScriptedInteraction::usage() const {
    return turns_ ? std::optional(turns_->usage()) : std::nullopt;
}

} // namespace trembler::lua
