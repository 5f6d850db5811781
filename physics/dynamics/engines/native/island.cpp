#include "physics/dynamics/engines/native/island.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace trembler::native {
namespace {

constexpr std::uint32_t noGroup = std::numeric_limits<std::uint32_t>::max();

// Sorts items by group, keeping their order within it, and returns where each group begins.
template <class Item, class GroupOf>
std::vector<std::size_t> sortedByGroup(std::size_t items, std::size_t groups, GroupOf const& groupOf,
                                       std::vector<Item>& sorted) {
    std::vector<std::size_t> begin(groups + 1, 0);
    for (std::size_t i = 0; i < items; ++i) {
        if (std::uint32_t const group = groupOf(i); group != noGroup) {
            ++begin[group + 1];
        }
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    sorted.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < items; ++i) {
        if (std::uint32_t const group = groupOf(i); group != noGroup) {
            sorted[next[group]++] = static_cast<Item>(i);
        }
    }
    return begin;
}

} // namespace

void Islands::clear(std::size_t slots) {
    parents_.resize(slots);
    std::iota(parents_.begin(), parents_.end(), SlotIndex{0});
}

SlotIndex Islands::rootOf(SlotIndex slot) {
    while (parents_[slot] != slot) {
        slot = parents_[slot] = parents_[parents_[slot]];
    }
    return slot;
}

void Islands::unite(SlotIndex a, SlotIndex b) {
    SlotIndex const x = rootOf(a);
    SlotIndex const y = rootOf(b);
    parents_[std::max(x, y)] = std::min(x, y);
}

void Islands::sort(std::span<std::uint8_t const> awake, std::span<SlotIndex const> slotOfContact,
                   std::span<SlotIndex const> slotOfJoint) {
    groupOf_.assign(parents_.size(), noGroup);
    std::uint32_t groups = 0;
    for (SlotIndex slot = 0; slot < parents_.size(); ++slot) {
        if (awake[slot] != 0) {
            SlotIndex const root = rootOf(slot);
            if (groupOf_[root] == noGroup) {
                groupOf_[root] = groups++;
            }
        }
    }
    auto const groupOfSlot = [&](SlotIndex slot) {
        return slot == noSlot ? noGroup : groupOf_[rootOf(slot)];
    };
    auto const bodies = sortedByGroup(
        parents_.size(), groups,
        [&](std::size_t i) { return awake[i] != 0 ? groupOfSlot(static_cast<SlotIndex>(i)) : noGroup; },
        bodies_);
    auto const contacts = sortedByGroup(
        slotOfContact.size(), groups, [&](std::size_t i) { return groupOfSlot(slotOfContact[i]); },
        contacts_);
    auto const joints = sortedByGroup(
        slotOfJoint.size(), groups, [&](std::size_t i) { return groupOfSlot(slotOfJoint[i]); }, joints_);
    groups_.resize(groups);
    for (std::size_t i = 0; i < groups; ++i) {
        groups_[i].bodies = std::span(bodies_).subspan(bodies[i], bodies[i + 1] - bodies[i]);
        groups_[i].contacts = std::span(contacts_).subspan(contacts[i], contacts[i + 1] - contacts[i]);
        groups_[i].joints = std::span(joints_).subspan(joints[i], joints[i + 1] - joints[i]);
    }
}

} // namespace trembler::native
