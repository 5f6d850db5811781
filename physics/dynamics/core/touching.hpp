// The pairs of bodies that touch, from the touches of pieces that an engine reports.
#pragma once

#include "physics/dynamics/core/engine.hpp"
#include "physics/dynamics/properties/contacts.hpp"

namespace trembler {

/// Counts, for each pair of objects, the pairs of pieces that touch.
class TouchBook {
public:
    /// Applies the changes and empties the list. The result of changed() must be marked as seen before the
    /// next call.
    void take(std::vector<TouchChange>& changes);
    /// Writes the contacts that follow `before` into `next`: the pairs that touch now, and the pairs that
    /// began and ended to touch since. Works with any `before`, so also after a change of engines. Events are
    /// copied.
    void compare(Contacts const& before, Contacts& next) const;
    [[nodiscard]] bool changed() const { return changed_; }
    /// Whether any pair touches.
    [[nodiscard]] bool any() const { return !counts_.empty(); }
    void markSeen() {
        changed_ = false;
        brief_.clear();
    }

private:
    struct Count {
        ObjectId a;
        ObjectId b;
        int pieces = 0;
    };
    std::vector<Count> counts_; // ascending by pair, above 0
    std::vector<Count> merged_; // a member to reuse its memory
    std::vector<TouchingPair> brief_;
    bool changed_ = true;
};

} // namespace trembler
