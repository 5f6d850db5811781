// What lay across a gap of a circuit and carried no current.
#pragma once

#include "insight/miss/miss.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <string>
#include <utility>

namespace trembler::insight {

/// The movable objects of one run that touched two conductors at the same time and do not conduct. A miss is
/// often of a moment before they fell into their place. Not thread-safe.
class Insulators {
public:
    /// To be called after every frame.
    void look(World const& world);
    /// Names, at each gap of the miss and of those besides it that a touch would close, the first that
    /// touched both of its sides.
    void tell(Miss& miss) const;

private:
    std::map<std::pair<ObjectId, ObjectId>, std::string> across_; // names; the lesser id first
};

} // namespace trembler::insight
