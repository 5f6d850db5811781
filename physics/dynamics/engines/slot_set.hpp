// A set of slots of an engine, such as those of its fixed bodies.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <vector>

namespace trembler {

/// A set whose members are contiguous. insert(), erase() and contains() take constant time (insert() on
/// average, as it may allocate memory); a visit of all members takes time in proportion to their number.
/// Their order depends on the calls alone, but is not that of the slots: results must not depend on it.
class SlotSet {
public:
    /// No effect if it is a member. Not for noSlot.
    void insert(SlotIndex slot) {
        if (contains(slot)) {
            return;
        }
        if (places_.size() <= slot) {
            places_.resize(slot + std::size_t{1}, noSlot);
        }
        places_[slot] = static_cast<SlotIndex>(members_.size());
        members_.push_back(slot);
    }
    /// No effect if it is not a member. The last member takes its place.
    void erase(SlotIndex slot) {
        if (!contains(slot)) {
            return;
        }
        SlotIndex const last = members_.back();
        members_[places_[slot]] = last;
        places_[last] = places_[slot];
        places_[slot] = noSlot;
        members_.pop_back();
    }
    [[nodiscard]] bool contains(SlotIndex slot) const {
        return slot < places_.size() && places_[slot] != noSlot;
    }
    [[nodiscard]] std::vector<SlotIndex> const& members() const { return members_; }

private:
    std::vector<SlotIndex> members_;
    std::vector<SlotIndex> places_; // by slot: its place among the members, or noSlot
};

} // namespace trembler
