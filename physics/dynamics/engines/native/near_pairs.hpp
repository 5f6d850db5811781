// The pairs of pieces that are near each other, kept from step to step.
#pragma once

#include "physics/dynamics/engines/native/convex.hpp"

#include <box2d/b2_dynamic_tree.h>

#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace trembler::native {

/// A box along the axes, in m.
struct Bounds {
    Vec2 low;
    Vec2 high;
};

/// The box around a piece.
[[nodiscard]] Bounds boundsOf(Convex const& piece, Pose const& pose);

/// Names a piece: its body's slot and its index there.
[[nodiscard]] constexpr std::uint32_t nameOf(SlotIndex slot, std::uint32_t piece) {
    return slot << 8 | piece; // maximumPieces is 256
}
[[nodiscard]] constexpr SlotIndex slotOf(std::uint32_t name) {
    return name >> 8;
}
[[nodiscard]] constexpr std::uint32_t pieceOf(std::uint32_t name) {
    return name & 0xff;
}
/// Names a pair of pieces; the lower name comes first.
[[nodiscard]] constexpr std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
}
[[nodiscard]] constexpr std::uint32_t firstOf(std::uint64_t key) {
    return static_cast<std::uint32_t>(key >> 32);
}
[[nodiscard]] constexpr std::uint32_t secondOf(std::uint64_t key) {
    return static_cast<std::uint32_t>(key);
}

/// Finds pairs with Box2D's dynamic tree. Its boxes are in single precision, but are rounded outwards, so
/// that no pair is missed however far from the origin; it only reports too many there.
class NearPairs {
public:
    void add(std::uint32_t name, Bounds const& box);
    void remove(std::uint32_t name);
    /// The box that the piece covers in the coming step.
    void move(std::uint32_t name, Bounds const& box);

    using Filter = std::function<bool(SlotIndex, SlotIndex)>;
    /// Updates the list after moves: adds the pairs of moved pieces that have come near, for which `mayTouch`
    /// is true (it is called with the lower slot first), and removes those that are no longer. The keys of
    /// the removed and the added ones are put into `gone` and `come`, ascending.
    void update(Filter const& mayTouch, std::vector<std::uint64_t>& gone, std::vector<std::uint64_t>& come);
    /// All pairs, ascending by key.
    [[nodiscard]] std::span<std::uint64_t const> pairs() const { return pairs_; }
    /// Removes all pairs of a body, for example because what it can collide with has changed; they are found
    /// again by the next update().
    void forget(SlotIndex slot, std::vector<std::uint64_t>& gone);

private:
    [[nodiscard]] std::int32_t proxyOf(std::uint32_t name) const;

    b2DynamicTree tree_;
    std::vector<std::vector<std::int32_t>> proxies_; // by slot and piece
    std::vector<std::uint32_t> moved_;               // pieces whose fattened boxes have changed
    std::vector<std::uint8_t> movedMarks_;           // by slot
    std::vector<std::uint64_t> pairs_;
    std::vector<std::uint64_t> merged_;
};

} // namespace trembler::native
