// The largest current of a network whose objects have capacities (7.3.2).
#pragma once

#include "physics/electricity/core/network_members.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace trembler {

/// Currents are whole microamperes, so that sums are exact. An object that can carry any current has
/// `unlimited`.
using Microamperes = std::int64_t;
inline constexpr Microamperes unlimited = 4'000'000'000'000'000;

struct MaxFlow {
    Microamperes total =
        0; ///< from source to return; `unlimited` if a path has no limit: then the other results are empty
    /// The current through a vertex of the circuit, in one of the flows of that total.
    struct Through {
        std::uint32_t vertex = 0;
        Microamperes current = 0;
        friend bool operator==(Through const&, Through const&) = default;
    };
    std::vector<Through> through; ///< of the network's vertices that can carry current, in order of ids
    /// The minimum cut: vertices without which no current could flow. Of all such sets with the least
    /// capacity, the one nearest the source.
    std::vector<std::uint32_t> bottleneck;
};

/// The maximum flow from the source node to the return node of one network in a circuit (Boykov and
/// Kolmogorov 2004, by the Boost Graph Library), and the minimum cut. Total and bottleneck depend on the
/// circuit alone; the distribution of the flow among parallel paths also depends on the order of the ids.
/// `members` is that of the circuit, `capacities` by vertex. Visits only plain conductors and the network's
/// own vertices, so that the cost does not depend on the other networks.
[[nodiscard]] MaxFlow maxFlow(Circuit const& circuit, NetworkMembers const& members, std::string_view network,
                              std::span<Microamperes const> capacities);

} // namespace trembler
