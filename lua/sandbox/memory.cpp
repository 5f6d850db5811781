#include "lua/sandbox/memory.hpp"

#include "lua/sandbox/limits.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

namespace trembler::lua {

namespace {

// LuaJIT's table of all strings of a state, which doubles as their number grows. It is its only new block of
// such a size: strings of that length are refused (see longestString), and arrays of that length have one
// element more.
bool mayBeTableOfStrings(std::size_t before, std::size_t wanted) {
    return before == 0 && wanted <= largestTableOfStrings && std::has_single_bit(wanted);
}

} // namespace

bool Memory::refuses(std::size_t before, std::size_t wanted) const {
    if (wanted <= before || collecting_) {
        return false;
    }
    std::size_t const more = wanted - before;
    auto const allocated = static_cast<std::size_t>(std::max<std::ptrdiff_t>(allocated_, 0));
    if (more > cap_ - std::min(used_, cap_) || more > mostAllocated_ - std::min(allocated, mostAllocated_)) {
        return true;
    }
    return !host_ && wanted > (before == 0 ? largestNewBlock : largestGrownBlock) &&
           !mayBeTableOfStrings(before, wanted);
}

bool Memory::worthCollecting() const {
    return used_ >= live_ + std::max(leastGarbage, live_ / 4);
}

// NOLINTBEGIN(cppcoreguidelines-no-malloc): Lua asks for realloc's behaviour
Memory::~Memory() {
    while (slabs_ != nullptr) {
        std::free(std::exchange(slabs_, slabs_->next));
    }
}

void* Memory::take(std::size_t size) {
    if (size > largestSmall) {
        return std::malloc(size);
    }
    std::size_t const list = (size + step - 1) / step;
    if (Free* const first = free_[list]) {
        free_[list] = first->next;
        return first;
    }
    std::size_t const bytes = list * step;
    if (slabLeft_ < bytes) { // the rest of the last one is lost: less than one small block
        void* const slab = std::malloc(slabSize);
        if (slab == nullptr) {
            return nullptr;
        }
        slabs_ = new (slab) Slab{slabs_};
        slabLeft_ = slabSize - sizeof(Slab);
    }
    slabLeft_ -= bytes;
    return reinterpret_cast<char*>(slabs_) + sizeof(Slab) + slabLeft_; // NOLINT(*-reinterpret-cast)
}

void Memory::give(void* block, std::size_t size) {
    if (size > largestSmall) {
        std::free(block);
        return;
    }
    std::size_t const list = (size + step - 1) / step;
    free_[list] = new (block) Free{free_[list]};
}

void* Memory::move(void* block, std::size_t before, std::size_t wanted) {
    if (before > largestSmall && wanted > largestSmall) {
        return std::realloc(block, wanted);
    }
    if (before <= largestSmall && wanted <= largestSmall &&
        (before + step - 1) / step == (wanted + step - 1) / step) {
        return block;
    }
    void* const moved = take(wanted);
    if (moved == nullptr) { // a small block may stay where it is: it is given back as one of its new size
        return wanted <= before && before <= largestSmall ? block : nullptr;
    }
    std::memcpy(moved, block, std::min(before, wanted));
    give(block, before);
    return moved;
}
// NOLINTEND(cppcoreguidelines-no-malloc)

void* Memory::allocate(void* self, void* block, std::size_t before, std::size_t wanted) {
    Memory& memory = *static_cast<Memory*>(self);
    if (block == nullptr) {
        before = 0;
    }
    if (wanted == 0) {
        if (block != nullptr) {
            memory.give(block, before);
        }
        memory.used_ -= before;
        if (!memory.collecting_) {
            memory.allocated_ -= static_cast<std::ptrdiff_t>(before);
        }
        return nullptr;
    }
    if (memory.refuses(before, wanted)) {
        if (!std::exchange(memory.exhausted_, true) && memory.onRefusal_ != nullptr) {
            memory.onRefusal_(memory.owner_);
        }
        return nullptr;
    }
    void* const moved = block == nullptr ? memory.take(wanted) : memory.move(block, before, wanted);
    if (moved == nullptr) {
        return nullptr;
    }
    memory.used_ += wanted - before;
    if (!memory.collecting_) {
        memory.allocated_ += static_cast<std::ptrdiff_t>(wanted) - static_cast<std::ptrdiff_t>(before);
    }
    return moved;
}

} // namespace trembler::lua
