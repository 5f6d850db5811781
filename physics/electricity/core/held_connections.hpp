// The connections that interactions hold, as the changes of their counts.
#pragma once

#include "runtime/component/caller_id.hpp"
#include "runtime/object/object_id.hpp"
#include "runtime/property/state_hash.hpp"
#include "runtime/trace/event.hpp"

#include <vector>

namespace trembler {

/// A held call is received in every turn, but a counted set is changed by differences. This class remembers
/// which held connections have been counted and finds the differences. Not thread-safe.
class HeldConnections {
public:
    struct Held {
        ObjectId a; ///< a < b
        ObjectId b;
        CallerId caller;
        EventId event; ///< of the call; it does not distinguish connections
    };
    /// A difference from the last turn: a connection, and by how much its caller's count changes, 1 or -1.
    struct Difference {
        Held held;
        int delta = 0;
    };

    /// The connections that are held now, in any order; the same one may occur several times. Returns the
    /// differences from the last turn, in an order that depends on the held connections only.
    [[nodiscard]] std::vector<Difference> replace(std::vector<Held> now);
    [[nodiscard]] bool empty() const { return held_.empty(); }
    /// Adds nothing to the hash while nothing is held.
    void hash(StateHash& hash) const;

private:
    std::vector<Held> held_; // as of the last turn, ascending, each once
};

} // namespace trembler
