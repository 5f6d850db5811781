#include "lua/sandbox/memory.hpp"

#include "lua/sandbox/limits.hpp"

#include <cstdlib>

namespace trembler::lua {

bool Memory::refuses(std::size_t before, std::size_t wanted) const {
    if (wanted <= before) {
        return false;
    }
    if (wanted - before > cap_ - (used_ < cap_ ? used_ : cap_) || wanted > mostAllocated_ ||
        allocated_ > mostAllocated_ - wanted) {
        return true;
    }
    return !host_ && wanted > (before == 0 ? largestNewBlock : largestGrownBlock);
}

void* Memory::allocate(void* self, void* block, std::size_t before, std::size_t wanted) {
    Memory& memory = *static_cast<Memory*>(self);
    if (block == nullptr) {
        before = 0;
    }
    if (wanted == 0) {
        std::free(block); // NOLINT(cppcoreguidelines-no-malloc): Lua asks for realloc's behaviour
        memory.used_ -= before;
        return nullptr;
    }
    if (memory.refuses(before, wanted)) {
        memory.exhausted_ = true;
        return nullptr;
    }
    void* const moved = std::realloc(block, wanted); // NOLINT(cppcoreguidelines-no-malloc)
    if (moved == nullptr) {
        return wanted <= before ? block : nullptr;
    }
    memory.used_ += wanted - before;
    if (wanted > before) {
        memory.allocated_ += wanted;
    }
    return moved;
}

} // namespace trembler::lua
