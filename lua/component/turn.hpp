// The Lua side of a scripted interaction: its state, with the tables by which a script sees objects and makes
// calls.
#pragma once

#include "lua/attach/scripts_property.hpp"
#include "lua/binding/script.hpp"
#include "lua/component/script_store.hpp"
#include "runtime/component/component.hpp"
#include "runtime/property/column.hpp"
#include "runtime/property/slot.hpp"
#include "runtime/world/store.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler::lua {

/// Where a declared property is stored: exactly one of the two is set.
struct Home {
    ColumnBase const* column = nullptr;
    SlotBase const* slot = nullptr;

    [[nodiscard]] std::uint64_t const* versionPlace() const {
        return column != nullptr ? column->versionPlace() : slot->versionPlace();
    }
};

/// One application of the script: to an object, to a pair, or, with neither, to the world.
struct Target {
    ObjectId first;
    ObjectId second;
    ScriptUse const* use = nullptr; ///< the settings of `first`; nullptr: the script's defaults
    EventId cause;                  ///< the event that caused it
};

/// The data of one turn of a script.
struct TurnContext {
    Store const& store;
    std::vector<Home> const& homes; ///< of the script's reads
    ScriptStore& kept;
    OpenSource& source;
    EventSink* sink = nullptr;
    double duration = 0;      ///< s, since the last turn
    bool sameTargets = false; ///< as in the last turn, in columns with the same rows
    bool sameFrame = false;   ///< as the last turn: limits hold for all turns of a frame together
    std::function<void(std::string const&)> log;
};

/// The resources that a script has used in a frame, in all of its turns, and its limits.
struct TurnUsage {
    std::uint64_t instructions = 0;
    std::uint64_t mostInstructions = 0; ///< for all the objects, or pairs, that it was applied to
    std::size_t bytes = 0;              ///< allocated at the end of the last turn
    std::size_t mostBytes = 0;
    std::size_t targets = 0; ///< the objects, or pairs, that it was applied to in the last turn
};

/// A Lua state in which one script has its turns. Used by one thread at a time.
class Turns {
public:
    explicit Turns(std::shared_ptr<Script const> script);
    ~Turns();
    Turns(Turns const&) = delete;
    Turns& operator=(Turns const&) = delete;

    /// Why the script cannot run at all; nothing if it can.
    [[nodiscard]] std::optional<ScriptError> const& broken() const;
    /// Applies the script to every target, in order.
    [[nodiscard]] std::optional<ScriptError> run(TurnContext const& context,
                                                 std::vector<Target> const& targets);
    /// The usage in the frame of the last turn; all zero before the first turn.
    [[nodiscard]] TurnUsage usage() const;

private:
    class Binding;
    std::unique_ptr<Binding> binding_;
};

} // namespace trembler::lua
