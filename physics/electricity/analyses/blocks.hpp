// The blocks (biconnected components) of a graph.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace trembler {

using BlockEdge = std::pair<std::uint32_t, std::uint32_t>; ///< from, to: vertices

/// Marks one of the two listings of an edge, see blocksOf().
inline constexpr std::size_t noBlock = std::numeric_limits<std::size_t>::max();

/// The block of every edge, numbered from 0 (Hopcroft and Tarjan 1973, by the Boost Graph Library). Every
/// edge is listed twice, once from each end, ordered by `from`; one of the two listings gets its block, the
/// other `noBlock`. The first edge from vertex 0 has a block. There are no loops and no parallel edges.
/// Linear, without recursion.
[[nodiscard]] std::vector<std::size_t> blocksOf(std::vector<BlockEdge> const& edges, std::size_t vertices);

} // namespace trembler
