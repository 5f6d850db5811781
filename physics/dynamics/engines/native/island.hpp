// Groups of bodies that touch or are joined.
#pragma once

#include "physics/dynamics/engines/native/contact.hpp"
#include "physics/dynamics/engines/substepped/joint_rows.hpp"

#include <memory>
#include <span>
#include <vector>

namespace trembler::native {

struct JointEntry {
    bool used = false;
    bool restless = false;
    bool collide = true;
    bool weld = false;
    SlotIndex a = noSlot;
    SlotIndex b = noSlot;
    std::unique_ptr<JointRows> rows;
    double last = 0; ///< s, length of the last substep
    Vec2 force;      ///< N, mean over the last step()
};

/// One group, each list ascending.
struct Island {
    std::span<SlotIndex const> bodies;
    std::span<std::uint32_t const> contacts;
    std::span<SlotIndex const> joints;
};

/// The groups of the movable, awake bodies. Fixed bodies connect nothing.
class Islands {
public:
    /// Starts a partition of so many slots, each by itself.
    void clear(std::size_t slots);
    void unite(SlotIndex a, SlotIndex b);
    [[nodiscard]] SlotIndex rootOf(SlotIndex slot);
    /// Sorts bodies, contacts and joints by groups. `rootOfContact` and `rootOfJoint` state a slot of the
    /// group of each, or noSlot for those that belong to none.
    void sort(std::span<std::uint8_t const> awake, std::span<SlotIndex const> slotOfContact,
              std::span<SlotIndex const> slotOfJoint);
    [[nodiscard]] std::span<Island> groups() { return groups_; }

private:
    std::vector<SlotIndex> parents_;
    std::vector<std::uint32_t> groupOf_; // by root
    std::vector<SlotIndex> bodies_;
    std::vector<std::uint32_t> contacts_;
    std::vector<SlotIndex> joints_;
    std::vector<Island> groups_;
};

} // namespace trembler::native
