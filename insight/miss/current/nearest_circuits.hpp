// How nearly the circuits of electromagnets were closed while something else was missing.
#pragma once

#include "insight/miss/miss.hpp"

#include <cstdint>
#include <map>

namespace trembler::insight {

/// Looks at every electromagnet of one world in every frame. At the moment in which an object came nearest to
/// its goal, a circuit may have been open at places that were closed later: the gaps that count are those at
/// the circuit's own best moment. Not thread-safe.
class NearestCircuits {
public:
    /// To be called after every frame.
    void look(World const& world, CircuitSight& circuits);
    /// Forgets all moments so far, as when a new step of a sequence begins.
    void clear() { coils_.clear(); }
    /// For a miss of that frame: puts in the place of the gaps of each electromagnet in `besides` its gaps at
    /// the moment when they were least, with that moment. Leaves out an electromagnet whose circuit was
    /// closed then or later, as a current was not what was missing. A circuit that was closed only earlier
    /// stays as it is.
    void judge(Miss& miss, std::uint64_t frame) const;

private:
    struct Coil {
        double cost = 0;          ///< m, of the gaps of `best`; of no gaps, if it has none
        Miss best{};              ///< with names and its frame
        std::uint64_t closed = 0; ///< the last frame in which its circuit was closed; 0: never
    };
    std::map<ObjectId, Coil> coils_;
};

} // namespace trembler::insight
