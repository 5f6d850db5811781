// The objects that exist: assigns and frees ids.
#pragma once

#include "runtime/object/object_id.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trembler {

/// Ids depend only on the order of create() and destroy(). Not thread-safe: used only by the Population
/// resolver and when a world is built, before its first frame.
class ObjectTable {
public:
    /// A new id with the lowest free index, so that the table stays small in a world that creates and
    /// destroys objects for hours.
    [[nodiscard]] ObjectId create();
    /// Frees the id. Returns false, and does nothing, if no object has it.
    bool destroy(ObjectId id);
    [[nodiscard]] bool alive(ObjectId id) const {
        return id.index < slots_.size() && slots_[id.index].alive &&
               slots_[id.index].generation == id.generation;
    }
    [[nodiscard]] std::size_t size() const { return living_; }
    /// One past the highest index ever used.
    [[nodiscard]] std::size_t indexBound() const { return slots_.size(); }
    /// The object that has an index now, or an invalid id.
    [[nodiscard]] ObjectId at(std::uint32_t index) const {
        return index < slots_.size() && slots_[index].alive ? ObjectId{index, slots_[index].generation}
                                                            : ObjectId{};
    }

    /// Calls f(index, generation) for every free index, ascending. These determine the ids of the next
    /// objects.
    template <class F>
    void forFree(F&& f) const {
        for (std::uint32_t index = 0; index < slots_.size() && !free_.empty(); ++index) {
            if (!slots_[index].alive) {
                f(index, slots_[index].generation);
            }
        }
    }

private:
    struct Slot {
        std::uint32_t generation = 0;
        bool alive = false;
    };
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_; // a heap, lowest index on top
    std::size_t living_ = 0;
};

} // namespace trembler
