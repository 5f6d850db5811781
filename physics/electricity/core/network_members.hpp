// The vertices of a circuit by network, so that the work for a network grows with its own size and not with
// the number of networks in the circuit.
#pragma once

#include "physics/electricity/core/circuit.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace trembler {

/// Plain conductors take part in every network, other vertices in their own. Made in O(n log n) for the n
/// vertices of the circuit, and linear in its connections; refers to the circuit, which must not change
/// meanwhile.
class NetworkMembers {
public:
    explicit NetworkMembers(Circuit const& circuit);

    /// The vertices that take part in every network, ascending.
    [[nodiscard]] std::span<std::uint32_t const> plain() const { return withRank(0); }
    /// The vertices that take part in this network only, ascending; none if it has no such vertices.
    [[nodiscard]] std::span<std::uint32_t const> own(std::string_view network) const {
        return withRank(rankOf(network));
    }
    [[nodiscard]] bool isPlain(std::uint32_t vertex) const { return rank_[vertex] == 0; }
    /// The neighbours of a vertex that take part in every network.
    [[nodiscard]] std::span<std::uint32_t const> plainNeighboursOf(std::uint32_t vertex) const {
        return neighboursWithRank(vertex, 0);
    }
    /// The neighbours of a vertex that take part in this network only. O(log n).
    [[nodiscard]] std::span<std::uint32_t const> ownNeighboursOf(std::uint32_t vertex,
                                                                 std::string_view network) const {
        return neighboursWithRank(vertex, rankOf(network));
    }

private:
    static constexpr std::uint32_t noRank = 0xffffffffU;

    [[nodiscard]] std::uint32_t rankOf(std::string_view network) const;
    [[nodiscard]] std::span<std::uint32_t const> withRank(std::uint32_t rank) const;
    [[nodiscard]] std::span<std::uint32_t const> neighboursWithRank(std::uint32_t vertex,
                                                                    std::uint32_t rank) const;

    Circuit const& circuit_;
    std::vector<std::string_view> names_;   // ascending; the first one is empty: plain
    std::vector<std::uint32_t> rank_;       // by vertex: the place of its network in names_
    std::vector<std::uint32_t> byRank_;     // vertices by rank, ascending within each
    std::vector<std::uint32_t> begins_;     // by rank, one more at the end: places in byRank_
    std::vector<std::uint32_t> neighbours_; // as in the circuit, but those of a vertex by rank
};

/// The terminals of one network, out of a circuit's list of all terminals. O(log n).
[[nodiscard]] std::span<Circuit::Terminal const> terminalsOf(std::vector<Circuit::Terminal> const& all,
                                                             std::string_view network);

} // namespace trembler
