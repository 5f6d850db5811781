#include "physics/dynamics/engines/native/solving_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace trembler::native {
namespace {

constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
// Contacts of a body on one level beyond this number come last, in their own order.
constexpr std::size_t mostColours = 32;

} // namespace

// Breadth first from what is fixed.
void SolvingOrder::findLevels(Island const& island, std::span<Contact const> contacts,
                              std::span<BodyEntry const> bodies) {
    for (SlotIndex const slot : island.bodies) {
        level_[slot] = unknown;
        begin_[slot] = 0;
    }
    queue_.clear();
    for (std::uint32_t const i : used_) {
        Contact const& contact = contacts[i];
        bool const fixedA = bodies[contact.a].fixed;
        bool const fixedB = bodies[contact.b].fixed;
        if (fixedA != fixedB) {
            SlotIndex const slot = fixedA ? contact.b : contact.a;
            if (level_[slot] == unknown) {
                level_[slot] = 0;
                queue_.push_back(slot);
            }
        } else {
            ++begin_[contact.a];
            ++begin_[contact.b];
        }
    }
    if (queue_.empty()) { // it floats
        for (SlotIndex const slot : island.bodies) {
            level_[slot] = 0;
        }
        return;
    }
    std::uint32_t sum = 0;
    for (SlotIndex const slot : island.bodies) {
        begin_[slot] = sum += begin_[slot];
    }
    neighbours_.resize(sum);
    for (std::uint32_t const i : used_) {
        Contact const& contact = contacts[i];
        if (bodies[contact.a].fixed == bodies[contact.b].fixed) {
            neighbours_[--begin_[contact.a]] = contact.b;
            neighbours_[--begin_[contact.b]] = contact.a;
        }
    }
    for (std::size_t n = 0; n < queue_.size(); ++n) {
        SlotIndex const slot = queue_[n];
        auto const position = std::lower_bound(island.bodies.begin(), island.bodies.end(), slot);
        std::uint32_t const end = position + 1 == island.bodies.end() ? sum : begin_[*(position + 1)];
        for (std::uint32_t i = begin_[slot]; i < end; ++i) {
            SlotIndex const other = neighbours_[i];
            if (level_[other] == unknown) {
                level_[other] = level_[slot] + 1;
                queue_.push_back(other);
            }
        }
    }
}

std::span<std::uint32_t const> SolvingOrder::of(Island const& island, std::span<Contact const> contacts,
                                                std::span<BodyEntry const> bodies) {
    used_.clear();
    for (std::uint32_t const i : island.contacts) {
        if (contacts[i].used) {
            used_.push_back(i);
        }
    }
    if (used_.size() < 2) {
        return used_;
    }
    level_.resize(bodies.size());
    begin_.resize(bodies.size());
    taken_.resize(bodies.size());
    findLevels(island, contacts, bodies);
    auto const levelOf = [&](std::uint32_t i) {
        Contact const& contact = contacts[i];
        std::uint32_t const a = bodies[contact.a].fixed ? unknown : level_[contact.a];
        std::uint32_t const b = bodies[contact.b].fixed ? unknown : level_[contact.b];
        // Those with what is fixed, then those of a level with itself or the next one. What is held by joints
        // only has no level and comes last.
        bool const fixed = bodies[contact.a].fixed || bodies[contact.b].fixed;
        return std::min(std::min(a, b), static_cast<std::uint32_t>(island.bodies.size())) + (fixed ? 0 : 1);
    };
    ofLevel_.assign(island.bodies.size() + 3, 0);
    for (std::uint32_t const i : used_) {
        ++ofLevel_[levelOf(i) + 1];
    }
    std::size_t levels = 0;
    for (std::size_t n = 1; n < ofLevel_.size(); ++n) {
        levels = ofLevel_[n] > 0 ? n : levels;
        ofLevel_[n] += ofLevel_[n - 1];
    }
    byLevel_.resize(used_.size());
    for (std::uint32_t const i : used_) {
        byLevel_[ofLevel_[levelOf(i)]++] = i;
    }
    order_.resize(used_.size());
    std::size_t first = 0;
    for (std::size_t level = 0; level < levels; ++level) {
        std::size_t const last = ofLevel_[level];
        for (std::size_t n = first; n < last; ++n) {
            taken_[contacts[byLevel_[n]].a] = taken_[contacts[byLevel_[n]].b] = 0;
        }
        std::array<std::uint32_t, mostColours + 1> next{};
        colours_.clear();
        for (std::size_t n = first; n < last; ++n) {
            Contact const& contact = contacts[byLevel_[n]];
            std::uint32_t const ofA = bodies[contact.a].fixed ? 0 : taken_[contact.a];
            std::uint32_t const ofB = bodies[contact.b].fixed ? 0 : taken_[contact.b];
            int const colour = std::countr_one(ofA | ofB);
            if (static_cast<std::size_t>(colour) < mostColours) {
                taken_[contact.a] |= 1U << static_cast<unsigned>(colour);
                taken_[contact.b] |= 1U << static_cast<unsigned>(colour);
            }
            colours_.push_back(static_cast<std::uint8_t>(colour));
            ++next[static_cast<std::size_t>(colour)];
        }
        std::uint32_t sum = static_cast<std::uint32_t>(first);
        for (std::uint32_t& begin : next) {
            std::uint32_t const count = begin;
            begin = sum;
            sum += count;
        }
        for (std::size_t n = first; n < last; ++n) {
            order_[next[colours_[n - first]]++] = byLevel_[n];
        }
        first = last;
    }
    return order_;
}

} // namespace trembler::native
