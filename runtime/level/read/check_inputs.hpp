// Whether what a solution recorded can happen in its level.
#pragma once

#include "runtime/level/model/level.hpp"

#include <set>
#include <string>
#include <utility>

namespace trembler {

/// Knows the objects and wires of a level; made once for all of its solutions. The level must outlive it.
class InputCheck {
public:
    explicit InputCheck(LevelFile const& level);

    /// Complains about the inputs of a solution that name an object which the level does not have, the
    /// solution does not place and the run cannot create (isBirthName()); about those that cut where the
    /// level lays no wire, or cut one wire twice; and about inputs and changes after the solution's last
    /// frame. `document` is the file in which the solution stands.
    void check(Solution const& solution, JsonDocument const& document, Problems& problems) const;

private:
    LevelFile const& level_;
    std::set<std::string> names_;
    std::set<std::pair<std::string, std::string>> wires_; ///< each in ascending order
};

} // namespace trembler
