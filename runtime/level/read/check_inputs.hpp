// Whether what a solution recorded can happen in its level.
#pragma once

#include "runtime/level/model/level.hpp"

#include <set>
#include <string>
#include <utility>

namespace trembler {

/// Knows what a level's solutions may speak of; made once for all of them. The level must outlive it.
class InputCheck {
public:
    explicit InputCheck(LevelFile const& level);

    /// Complains about the inputs of a solution that name what neither the level has, nor the solution
    /// places, nor such objects may bring forth; that cut where the level lays no wire, or cut one wire
    /// twice; and about inputs and changes after the solution's last frame. `document` is where the solution
    /// stands.
    void check(Solution const& solution, JsonDocument const& document, Problems& problems) const;

private:
    LevelFile const& level_;
    std::set<std::string> names_;
    std::set<std::pair<std::string, std::string>> wires_; ///< each in ascending order
};

} // namespace trembler
