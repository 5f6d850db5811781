#include "physics/electricity/core/network_members.hpp"

#include <algorithm>

namespace trembler {

NetworkMembers::NetworkMembers(Circuit const& circuit)
    : circuit_(circuit), names_(circuit.networks), rank_(circuit.size()) {
    names_.emplace_back(); // that of plain conductors, even if there are none
    std::sort(names_.begin(), names_.end());
    names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
    begins_.assign(names_.size() + 1, 0);
    for (std::uint32_t v = 0; v < circuit.size(); ++v) {
        auto const at = std::lower_bound(names_.begin(), names_.end(), circuit.networks[v]);
        rank_[v] = static_cast<std::uint32_t>(at - names_.begin());
        ++begins_[rank_[v] + 1];
    }
    for (std::size_t rank = 1; rank < begins_.size(); ++rank) {
        begins_[rank] += begins_[rank - 1];
    }
    byRank_.resize(circuit.size());
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    for (std::uint32_t v = 0; v < circuit.size(); ++v) {
        byRank_[next[rank_[v]]++] = v;
    }
    // Each vertex is entered into its neighbours' rows, in order of ranks, so every row is in that order.
    neighbours_.resize(circuit.neighbours.size());
    next.assign(circuit.offsets.begin(), circuit.offsets.end() - 1);
    for (std::uint32_t const v : byRank_) {
        for (std::uint32_t const w : circuit.neighboursOf(v)) {
            neighbours_[next[w]++] = v;
        }
    }
}

std::uint32_t NetworkMembers::rankOf(std::string_view network) const {
    auto const at = std::lower_bound(names_.begin(), names_.end(), network);
    return network.empty() || at == names_.end() || *at != network
               ? noRank // the common network has no vertices of its own
               : static_cast<std::uint32_t>(at - names_.begin());
}

std::span<std::uint32_t const> NetworkMembers::withRank(std::uint32_t rank) const {
    return rank == noRank ? std::span<std::uint32_t const>{}
                          : std::span(byRank_).subspan(begins_[rank], begins_[rank + 1] - begins_[rank]);
}

std::span<std::uint32_t const> NetworkMembers::neighboursWithRank(std::uint32_t vertex,
                                                                  std::uint32_t rank) const {
    std::span<std::uint32_t const> const row =
        std::span(neighbours_)
            .subspan(circuit_.offsets[vertex], circuit_.offsets[vertex + 1] - circuit_.offsets[vertex]);
    auto const first =
        std::partition_point(row.begin(), row.end(), [&](std::uint32_t w) { return rank_[w] < rank; });
    auto const last =
        std::partition_point(first, row.end(), [&](std::uint32_t w) { return rank_[w] == rank; });
    return row.subspan(static_cast<std::size_t>(first - row.begin()), static_cast<std::size_t>(last - first));
}

std::span<Circuit::Terminal const> terminalsOf(std::vector<Circuit::Terminal> const& all,
                                               std::string_view network) {
    auto const from = std::partition_point(all.begin(), all.end(), [&](Circuit::Terminal const& terminal) {
        return terminal.network < network;
    });
    auto const to = std::partition_point(
        from, all.end(), [&](Circuit::Terminal const& terminal) { return terminal.network == network; });
    return {from, to};
}

} // namespace trembler
