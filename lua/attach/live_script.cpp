#include "lua/attach/live_script.hpp"

#include "lua/attach/parameter_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace trembler::lua {

/// A component that is registered with its script for as long as it exists.
class LiveScript::Instance final : public ScriptedInteraction {
public:
    Instance(std::shared_ptr<LiveScript> live)
        : ScriptedInteraction(live->info_, live->script_, live->log_), live_(std::move(live)) {
        if (!live_->on_) {
            setOn(false);
        }
        std::lock_guard const lock(live_->mutex_);
        live_->instances_.push_back(this);
    }
    ~Instance() override {
        std::lock_guard const lock(live_->mutex_);
        std::erase(live_->instances_, this);
    }

    void bind(Store& store, Channels& channels) override {
        store_ = &store;
        ScriptedInteraction::bind(store, channels);
    }
    void swapTo(std::shared_ptr<Script const> script) {
        if (store_ != nullptr) {
            replace(*store_, std::move(script));
        }
    }

private:
    std::shared_ptr<LiveScript> live_;
    Store* store_ = nullptr; // of the component's world
};

LiveScript::LiveScript(std::shared_ptr<Script const> script, std::shared_ptr<ScriptLog> log)
    : script_(std::move(script)), log_(std::move(log)), name_(script_->manifest.name), mod_(script_->effect),
      info_(*script_->info) {
    setInfo();
}

void LiveScript::setInfo() {
    text_ = std::string(script_->info->text.work);
    info_ = *script_->info;
    info_.text.name = name_;
    info_.text.effect = mod_;
    info_.text.work = text_;
}

std::unique_ptr<Component> LiveScript::make() {
    return std::make_unique<Instance>(shared_from_this());
}

void LiveScript::publish(std::shared_ptr<Script const> script) {
    script_ = std::move(script);
    setInfo();
}

bool LiveScript::swapIn() {
    std::lock_guard const lock(mutex_);
    for (Instance* const instance : instances_) {
        instance->swapTo(script_);
    }
    return !instances_.empty();
}

void LiveScript::setOn(bool on) {
    std::lock_guard const lock(mutex_);
    on_ = on;
    for (Instance* const instance : instances_) {
        instance->setOn(on);
    }
}

std::optional<TurnUsage> LiveScript::usage() const {
    std::lock_guard const lock(mutex_);
    return instances_.empty() ? std::nullopt : instances_.back()->usage();
}

bool LiveScript::failed() const {
    std::lock_guard const lock(mutex_);
    return !instances_.empty() && instances_.back()->failed();
}

LiveScript* LiveScripts::find(std::string_view name) const {
    auto const at =
        std::find_if(all_.begin(), all_.end(), [&](auto const& script) { return script->name() == name; });
    return at == all_.end() ? nullptr : at->get();
}

std::shared_ptr<Script const> LiveScripts::read(LiveScript const& script, std::string text,
                                                Problems& problems) const {
    std::size_t const before = problems.count();
    Manifest manifest = readManifest(std::move(text), script.file().string(), problems);
    if (problems.count() != before) {
        return nullptr;
    }
    if (manifest.name != script.name()) {
        problems.add(manifest.problem(
            "name", fmt::format("the interaction was '{}' and is '{}' now", script.name(), manifest.name),
            "the name that it had; another one counts when the level is opened again"));
        return nullptr;
    }
    manifest.trust = script.script().manifest.trust; // the player's decision, not the file's
    auto made = declare(std::move(manifest), script.mod(), vocabulary_, problems);
    return problems.count() == before && made->info ? made : nullptr;
}

std::shared_ptr<Script const> LiveScripts::with(Script const& script,
                                                std::map<std::string, Value> const& defaults) const {
    Manifest manifest = script.manifest;
    for (Parameter& parameter : manifest.parameters) {
        auto const stated = defaults.find(parameter.name);
        if (stated != defaults.end() && !faultOf(parameter, stated->second)) {
            parameter.initial = stated->second;
        }
    }
    Problems none;
    return declare(std::move(manifest), script.effect, vocabulary_, none);
}

} // namespace trembler::lua
