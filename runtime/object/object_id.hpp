// The identity of an object in a running world.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

namespace trembler {

/// Index and generation: an index is used again after its object is destroyed, with the next generation,
/// so an id kept for too long is found to be stale instead of identifying another object. Ordered by index
/// first.
struct ObjectId {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t index = none;
    std::uint32_t generation = 0;

    [[nodiscard]] constexpr bool valid() const { return index != none; }
    friend constexpr bool operator==(ObjectId, ObjectId) = default;
    /// With a single comparison: lists of pairs of objects are sorted and merged in every frame.
    friend constexpr std::strong_ordering operator<=>(ObjectId x, ObjectId y) {
        return x.rank() <=> y.rank();
    }

private:
    [[nodiscard]] constexpr std::uint64_t rank() const { return std::uint64_t{index} << 32U | generation; }
};

/// Both halves in one number, for hashing and for keys.
[[nodiscard]] constexpr std::uint64_t packed(ObjectId id) {
    return (static_cast<std::uint64_t>(id.generation) << 32U) | id.index;
}

} // namespace trembler
