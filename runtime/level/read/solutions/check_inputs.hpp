// Checks whether the recorded inputs of a solution are possible in its level.
#pragma once

#include "runtime/level/build/piece_names.hpp"
#include "runtime/level/model/level.hpp"

#include <set>
#include <string>
#include <utility>

namespace trembler {

/// Has the objects and wires of a level; made once for all of its solutions. The level must outlive it.
class InputCheck {
public:
    explicit InputCheck(LevelFile const& level);

    /// Complains about the inputs of a solution that name an object which the level does not have, the
    /// solution does not place, the run cannot create (isBirthName()) and no composite part can have (which
    /// is known only from a world, see Session::load()); about inputs that cut a wire that the level does not
    /// have, or cut a wire twice; and about inputs and changes after the solution's last frame. `document` is
    /// the solution's file.
    void check(Solution const& solution, JsonDocument const& document, Problems& problems) const;

private:
    LevelFile const& level_;
    std::set<std::string> names_;
    PieceNames pieces_;
    std::set<std::pair<std::string, std::string>> wires_; ///< each in ascending order
};

} // namespace trembler
