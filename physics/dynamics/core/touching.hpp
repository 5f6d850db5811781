// Which bodies touch, from the beginnings and ends that an engine reports piece by piece.
#pragma once

#include "physics/dynamics/core/engine.hpp"
#include "physics/dynamics/properties/contacts.hpp"

namespace trembler {

/// Counts, for each pair of objects, the pairs of pieces that touch.
class TouchBook {
public:
    /// Takes the changes in and empties the list. What changed() after it must be marked as seen before the
    /// next call.
    void take(std::vector<TouchChange>& changes);
    /// Writes into `next` how the world's contacts go on from `before`: the pairs that touch now, and those
    /// that began and ended since. Works from any `before`, so that it holds across a change of engines.
    /// Events are carried over.
    void compare(Contacts const& before, Contacts& next) const;
    [[nodiscard]] bool changed() const { return changed_; }
    /// Whether anything touches anything.
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
    std::vector<Count> merged_; // kept for its memory
    std::vector<TouchingPair> brief_;
    bool changed_ = true;
};

} // namespace trembler
