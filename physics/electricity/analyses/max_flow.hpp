// The largest current that a network lets through, where objects have capacities (7.3.2).
#pragma once

#include "physics/electricity/core/circuit.hpp"

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
        0; ///< from source to return; `unlimited` if some way has no limit, and then nothing else is found
    std::vector<Microamperes> through; ///< by vertex of the circuit, in one of the flows that reach the total
    /// Vertices that let no more through and without which nothing could flow: of all such sets with the
    /// least capacity the one nearest the source.
    std::vector<std::uint32_t> bottleneck;
};

/// The maximum flow from the source node to the return node of one network in a circuit (Boykov and
/// Kolmogorov 2004, by the Boost Graph Library), and the minimum cut. Total and bottleneck are determined by
/// the circuit alone; how the flow shares itself among ways side by side is not, and depends on the order of
/// the ids. `capacities` by vertex.
[[nodiscard]] MaxFlow maxFlow(Circuit const& circuit, std::string_view network,
                              std::span<Microamperes const> capacities);

} // namespace trembler
