// The objects, or pairs of objects, to which a script is applied in a turn.
#pragma once

#include "lua/binding/script.hpp"
#include "lua/component/turn.hpp"

#include <cstdint>
#include <vector>

namespace trembler::lua {

/// Always in the order of objects. They point into a column of the store.
class ScriptTargets {
public:
    /// Of a turn that begins. `homes`: of the script's reads. Returns whether they are those of the last
    /// turn. More than `mostPairs` pairs are not all found.
    bool update(Script const& script, std::vector<Home> const& homes);
    /// The next turn finds them again, as the store has other columns.
    void forget() { foundBy_.clear(); }
    [[nodiscard]] std::vector<Target> const& all() const { return targets_; }

private:
    std::vector<Target> targets_;        // of the turn under way, or of the last one
    std::vector<std::uint64_t> foundBy_; // the state of the columns by which they were found
};

} // namespace trembler::lua
