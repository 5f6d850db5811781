// The order in which the contacts of an island are solved.
#pragma once

#include "physics/dynamics/engines/native/contact.hpp"
#include "physics/dynamics/engines/native/island.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace trembler::native {

/// Upwards from what is fixed, so that what bears is solved before what it bears, whichever was created
/// first. Contacts that are equally far from what is fixed are ordered by colour: those of a colour share no
/// movable body, so a processor works at several of them at a time, where one after the other would wait for
/// each result.
class SolvingOrder {
public:
    /// The indices, into `contacts`, of those of the island's contacts that are used. The answer lasts until
    /// the next call.
    [[nodiscard]] std::span<std::uint32_t const> of(Island const& island, std::span<Contact const> contacts,
                                                    std::span<BodyEntry const> bodies);

private:
    void findLevels(Island const& island, std::span<Contact const> contacts,
                    std::span<BodyEntry const> bodies);

    // By slot; only the entries of the island's bodies mean something.
    std::vector<std::uint32_t> level_; // contacts between it and what is fixed
    std::vector<std::uint32_t> begin_; // of its neighbours
    std::vector<std::uint32_t> taken_; // colours of its contacts on the level at hand
    std::vector<SlotIndex> neighbours_;
    std::vector<SlotIndex> queue_;
    std::vector<std::uint32_t> used_;
    std::vector<std::uint32_t> byLevel_;
    std::vector<std::uint32_t> ofLevel_; // where each level begins
    std::vector<std::uint8_t> colours_;
    std::vector<std::uint32_t> order_;
};

} // namespace trembler::native
