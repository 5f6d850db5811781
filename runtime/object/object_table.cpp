#include "runtime/object/object_table.hpp"

#include <algorithm>
#include <functional>

namespace trembler {

ObjectId ObjectTable::create() {
    ++living_;
    if (!free_.empty()) {
        std::pop_heap(free_.begin(), free_.end(), std::greater<>{});
        std::uint32_t const index = free_.back();
        free_.pop_back();
        slots_[index].alive = true;
        return {index, slots_[index].generation};
    }
    slots_.push_back({0, true});
    return {static_cast<std::uint32_t>(slots_.size() - 1), 0};
}

bool ObjectTable::destroy(ObjectId id) {
    if (!alive(id)) {
        return false;
    }
    Slot& slot = slots_[id.index];
    slot.alive = false;
    ++slot.generation;
    free_.push_back(id.index);
    std::push_heap(free_.begin(), free_.end(), std::greater<>{});
    --living_;
    return true;
}

} // namespace trembler
