// Small numbers for objects, reused when their objects no longer exist.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <algorithm>
#include <functional>

namespace trembler {

class SlotBook {
public:
    /// Assigns the lowest free slot to the object.
    SlotIndex take(ObjectId object) {
        SlotIndex slot = static_cast<SlotIndex>(objects_.size());
        if (free_.empty()) {
            objects_.push_back(object);
        } else {
            slot = free_.front();
            std::pop_heap(free_.begin(), free_.end(), std::greater<>{});
            free_.pop_back();
            objects_[slot] = object;
        }
        if (byIndex_.size() <= object.index) {
            byIndex_.resize(object.index + std::size_t{1}, noSlot);
        }
        byIndex_[object.index] = slot;
        return slot;
    }
    void release(SlotIndex slot) {
        byIndex_[objects_[slot].index] = noSlot;
        objects_[slot] = {};
        free_.push_back(slot);
        std::push_heap(free_.begin(), free_.end(), std::greater<>{});
    }
    /// The object's slot, or noSlot.
    [[nodiscard]] SlotIndex find(ObjectId object) const {
        if (object.index >= byIndex_.size()) {
            return noSlot;
        }
        SlotIndex const slot = byIndex_[object.index];
        return slot != noSlot && objects_[slot] == object ? slot : noSlot;
    }
    /// The object in every slot; invalid for a free slot.
    [[nodiscard]] std::span<ObjectId const> objects() const { return objects_; }

private:
    std::vector<ObjectId> objects_;
    std::vector<SlotIndex> free_; // a heap, the lowest in front
    std::vector<SlotIndex> byIndex_;
};

} // namespace trembler
