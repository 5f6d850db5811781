// The allocator of one Lua state: it counts bytes and refuses what is beyond the limits.
#pragma once

#include <cstddef>

namespace trembler::lua {

class Memory {
public:
    /// `owner` is what owner() returns.
    explicit Memory(void* owner = nullptr) : owner_(owner) {}
    [[nodiscard]] void* owner() const { return owner_; }
    /// Bytes that are allocated now.
    [[nodiscard]] std::size_t used() const { return used_; }
    /// Bytes that were allocated since beginTurn().
    [[nodiscard]] std::size_t allocated() const { return allocated_; }
    /// Whether something was refused since beginTurn().
    [[nodiscard]] bool exhausted() const { return exhausted_; }

    void setCap(std::size_t bytes) { cap_ = bytes; }
    void beginTurn(std::size_t mostAllocated) {
        allocated_ = 0;
        mostAllocated_ = mostAllocated;
        exhausted_ = false;
    }
    /// While true, single blocks may have any size: the host makes them, or the compiler of the script's
    /// text.
    void setHost(bool host) { host_ = host; }
    [[nodiscard]] bool host() const { return host_; }

    /// The function of type lua_Alloc; `self` is a Memory. Never refuses to shrink a block.
    static void* allocate(void* self, void* block, std::size_t before, std::size_t wanted);

private:
    [[nodiscard]] bool refuses(std::size_t before, std::size_t wanted) const;

    void* owner_;
    std::size_t used_ = 0;
    std::size_t allocated_ = 0;
    std::size_t cap_ = static_cast<std::size_t>(-1);
    std::size_t mostAllocated_ = static_cast<std::size_t>(-1);
    bool exhausted_ = false;
    bool host_ = true;
};

} // namespace trembler::lua
