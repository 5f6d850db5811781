// What happens to a scripted interaction between two frames, when its file is saved or a player changes it.
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
    targets_.clear();
    targetsOf_.clear();
    restless_ = script->manifest.restless;
    script_ = std::move(script);
    homes_.clear();
    for (DeclaredProperty const& property : script_->reads) {
        Home home;
        if (property.ofObjects()) {
            home.column = &store.column(*property.info);
        } else {
            home.slot = &store.slot(*property.info);
        }
        homes_.push_back(home);
    }
    seen_.assign(homes_.size(), 0);
    first_ = true;
    off_ = false;
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
}

std::optional<TurnUsage> ScriptedInteraction::usage() const {
    return turns_ ? std::optional(turns_->usage()) : std::nullopt;
}

} // namespace trembler::lua
