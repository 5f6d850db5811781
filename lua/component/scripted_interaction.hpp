// An interaction whose apply() is a Lua function.
#pragma once

#include "lua/binding/script.hpp"
#include "lua/component/script_log.hpp"
#include "lua/component/script_store.hpp"
#include "lua/component/script_targets.hpp"
#include "lua/component/turn.hpp"
#include "runtime/component/component.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace trembler::lua {

/// Like any other interaction it is applied when a property that it reads has changed, and its held calls
/// stay in effect until then. A script that fails is switched off: its calls are taken back, and it is not
/// applied again in this world. A failure is part of the world's state and follows from it alone, as
/// instructions and bytes are counted, not time.
class ScriptedInteraction : public Component {
public:
    ScriptedInteraction(std::shared_ptr<Script const> script, std::shared_ptr<ScriptLog> log);
    ~ScriptedInteraction() override;

    void bind(Store& store, Channels& channels) override;
    [[nodiscard]] bool hasWork() const override;
    [[nodiscard]] std::size_t workload() const override;
    void run(FrameContext const& context) override;
    void hashState(StateHash& hash) const override;

    // For scripts that are changed while a world runs, between frames (scripted_interaction_changes.cpp):

    /// `info` must outlive it, and may have changed since `script` was declared.
    ScriptedInteraction(ComponentInfo const& info, std::shared_ptr<Script const> script,
                        std::shared_ptr<ScriptLog> log);
    /// Continues with another version, which calls the same resolver. `store` is the one given to bind(). The
    /// fields of its store that both versions declare with the same kind keep their values. The held calls of
    /// the old version stay in effect until the first turn of the new one, which is in the next frame.
    void replace(Store& store, std::shared_ptr<Script const> script);
    /// Off: takes back its calls and applies it no more. On: applies it again.
    void setOn(bool on);
    /// Whether it was switched off because it failed.
    [[nodiscard]] bool failed() const { return off_; }
    /// The usage in the frame of its last turn; nothing before the first turn and after a failure.
    [[nodiscard]] std::optional<TurnUsage> usage() const;

private:
    void applyScript(FrameContext const& context);
    void switchOff(FrameContext const& context, ScriptError const& failed);

    void bindReads(Store& store);
    void sleep();

    std::vector<Home> homes_;    // of script_->reads
    std::vector<Watch> watches_; // of homes_
    bool restless_ = false;
    bool first_ = true;
    bool applied_ = false; // it has been applied to something; noted once
    bool off_ = false;
    bool resting_ = false; // see setOn()
    // The frame of the last turn of turns_. It is no state: limits hold within a frame.
    std::optional<std::uint64_t> frame_;
    std::shared_ptr<Script const> script_;
    std::shared_ptr<ScriptLog> log_;
    std::unique_ptr<OpenSource> source_;
    ScriptStore kept_;
    std::unique_ptr<Turns> turns_; // the Lua state; made for the first turn
    ScriptTargets targets_;
    Store const* store_ = nullptr;
};

} // namespace trembler::lua
