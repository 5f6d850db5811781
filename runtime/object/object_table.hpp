// Which objects exist: hands out ids and takes them back.
#pragma once

#include "runtime/object/object_id.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trembler {

/// Ids depend on nothing but the order of create() and destroy(). Not thread-safe: only the Population
/// resolver and whoever builds a world before its first frame use it.
class ObjectTable {
public:
    /// A new id: the lowest free index, so that a world that creates and destroys for hours stays small.
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

    /// What ids will be given next follows from this: calls f(index, generation) for every free index,
    /// ascending.
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
