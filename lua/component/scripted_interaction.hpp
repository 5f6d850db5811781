// An interaction whose apply() is a Lua function.
#pragma once

#include "lua/binding/script.hpp"
#include "lua/component/script_log.hpp"
#include "lua/component/script_store.hpp"
#include "lua/component/turn.hpp"
#include "runtime/component/component.hpp"

#include <memory>
#include <vector>

namespace trembler {
struct Contacts;
}

namespace trembler::lua {

/// Like any other interaction it is applied when what it reads has changed, and its held calls stand until
/// then. A script that fails is switched off: its calls are taken back, and it is not applied again in this
/// world. That is part of the world's state, as all of it follows from the state: instructions and bytes are
/// counted, not time.
class ScriptedInteraction final : public Component {
public:
    ScriptedInteraction(std::shared_ptr<Script const> script, std::shared_ptr<ScriptLog> log);
    ~ScriptedInteraction() override;

    void bind(Store& store, Channels& channels) override;
    [[nodiscard]] bool hasWork() const override;
    [[nodiscard]] std::size_t workload() const override;
    void run(FrameContext const& context) override;
    void hashState(StateHash& hash) const override;
    /// Instructions and bytes of its last turn; zeros before it had one. Between frames.
    [[nodiscard]] TurnCost cost() const { return turns_ ? turns_->cost() : TurnCost{}; }

private:
    void findTargets(FrameContext const& context);
    void findEach();
    void findPairs();
    void findTouching();
    void findNear();
    [[nodiscard]] std::vector<ObjectId> havingAll(std::vector<std::size_t> const& needed,
                                                  bool attached) const;
    [[nodiscard]] bool hasAll(ObjectId id, std::vector<std::size_t> const& needed, bool attached) const;
    [[nodiscard]] ScriptUse const* useOf(ObjectId id) const;
    [[nodiscard]] double reachOf(ScriptUse const* use) const;
    [[nodiscard]] bool targetsStand();
    void switchOff(FrameContext const& context, ScriptError const& failed);

    // What hasWork() looks at comes first, and so lies together.
    std::vector<Home> homes_;         // of script_->reads
    std::vector<std::uint64_t> seen_; // their versions
    bool restless_ = false;
    bool first_ = true;
    bool off_ = false;
    std::shared_ptr<Script const> script_;
    std::shared_ptr<ScriptLog> log_;
    std::unique_ptr<OpenSource> source_;
    ScriptStore kept_;
    std::unique_ptr<Turns> turns_; // the Lua state; made for the first turn
    std::vector<Target> targets_;  // of the turn under way, or of the last one: they point into a column
    std::vector<std::uint64_t> targetsOf_; // the state of the columns by which they were found
    Store const* store_ = nullptr;
};

} // namespace trembler::lua
