// The allocator of one Lua state: it counts bytes and refuses to allocate beyond the limits.
#pragma once

#include <array>
#include <cstddef>

namespace trembler::lua {

class Memory {
public:
    /// `owner` is returned by owner(). `onRefusal`, which may be nullptr, is called with it where something
    /// is refused for the first time since beginTurn(); it must not use the state's memory.
    explicit Memory(void* owner = nullptr, void (*onRefusal)(void*) = nullptr)
        : owner_(owner), onRefusal_(onRefusal) {}
    Memory(Memory const&) = delete;
    Memory& operator=(Memory const&) = delete;
    ~Memory();
    [[nodiscard]] void* owner() const { return owner_; }
    /// Bytes that are allocated now.
    [[nodiscard]] std::size_t used() const { return used_; }
    /// Bytes, the sum over all that was allocated since beginTurn(), less the old sizes of blocks that were
    /// made larger or smaller.
    [[nodiscard]] std::size_t allocated() const {
        return allocated_ < 0 ? 0 : static_cast<std::size_t>(allocated_);
    }
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
    /// Between these, nothing is refused: the collector makes a smaller table of strings before it gives the
    /// larger one back, and an error there would end the program.
    void beginCollection() { collecting_ = true; }
    void endCollection() {
        collecting_ = false;
        live_ = used_;
    }
    /// Whether enough memory was used since the last collection to make another one worth its time.
    [[nodiscard]] bool worthCollecting() const;

    /// The function of type lua_Alloc; `self` is a Memory. Never refuses to shrink a block.
    static void* allocate(void* self, void* block, std::size_t before, std::size_t wanted);

private:
    // Small blocks come from slabs and go back to a list for their size, as scripts make and drop very many
    // of them.
    static constexpr std::size_t step = 16;
    static constexpr std::size_t largestSmall = 256;
    static constexpr std::size_t slabSize = std::size_t{32} << 10U;
    struct Free {
        Free* next;
    };
    struct alignas(step) Slab {
        Slab* next;
    };
    [[nodiscard]] bool refuses(std::size_t before, std::size_t wanted) const;
    [[nodiscard]] void* take(std::size_t size);
    void give(void* block, std::size_t size);
    [[nodiscard]] void* move(void* block, std::size_t before, std::size_t wanted);

    std::array<Free*, largestSmall / step + 1> free_{};
    Slab* slabs_ = nullptr;
    std::size_t slabLeft_ = 0; // bytes at the beginning of the last one, behind its header
    void* owner_;
    void (*onRefusal_)(void*);
    std::size_t used_ = 0;
    // Since beginTurn(), less the old sizes of blocks that were made larger or smaller: how often a table is
    // made again depends on where the random hashes put its keys.
    std::ptrdiff_t allocated_ = 0;
    std::size_t cap_ = static_cast<std::size_t>(-1);
    std::size_t mostAllocated_ = static_cast<std::size_t>(-1);
    bool exhausted_ = false;
    bool host_ = true;
    bool collecting_ = false;
    std::size_t live_ = 0; // used after the last collection
};

} // namespace trembler::lua
