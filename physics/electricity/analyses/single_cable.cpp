#include "physics/electricity/analyses/single_cable.hpp"

#include "physics/electricity/core/network_members.hpp"

#include <algorithm>
#include <utility>

namespace trembler {

namespace {

// Marks all vertices that can be reached from the sources, in a circuit of one network.
void markReached(Circuit const& circuit, std::vector<std::uint8_t>& on) {
    std::vector<std::uint32_t> reached;
    for (Circuit::Terminal const& source : circuit.sources) {
        on[source.vertex] = 1;
        reached.push_back(source.vertex);
    }
    for (std::size_t open = 0; open < reached.size(); ++open) {
        for (std::uint32_t const v : circuit.neighboursOf(reached[open])) {
            if (on[v] == 0 && circuit.takesPart(v, circuit.sources.front().network)) {
                on[v] = 1;
                reached.push_back(v);
            }
        }
    }
}

/// Marks the vertices of networks that share plain conductors. Connected plain conductors are one region,
/// which a network reaches as a whole. So all networks together take O(n log n) for the n vertices and
/// connections of the circuit.
class SingleCableNetworks {
public:
    SingleCableNetworks(Circuit const& circuit, std::vector<std::uint8_t>& on)
        : circuit_(circuit), members_(circuit), on_(on), regions_(circuit.size(), none) {
        for (std::uint32_t const seed : members_.plain()) {
            if (regions_[seed] == none) {
                findRegion(seed);
            }
        }
        reachedBy_.assign(regionCount_, none);
        wasReached_.assign(regionCount_, 0);
    }
    /// `number` is different for every network.
    void mark(std::string_view network, std::uint32_t number) {
        toOwn_.clear();
        for (std::uint32_t const v : members_.own(network)) {
            for (std::uint32_t const w : members_.plainNeighboursOf(v)) {
                toOwn_.emplace_back(regions_[w], v);
            }
        }
        std::sort(toOwn_.begin(), toOwn_.end());
        number_ = number;
        for (Circuit::Terminal const& source : terminalsOf(circuit_.sources, network)) {
            reach(source.vertex);
        }
        while (!open_.empty()) {
            std::uint32_t const v = open_.back();
            open_.pop_back();
            for (std::uint32_t const w : members_.plainNeighboursOf(v)) {
                reach(w);
            }
            for (std::uint32_t const w : members_.ownNeighboursOf(v, network)) {
                reach(w);
            }
        }
    }
    void markRegions() {
        for (std::uint32_t const v : members_.plain()) {
            if (wasReached_[regions_[v]] != 0) {
                on_[v] = 1;
            }
        }
    }

private:
    static constexpr std::uint32_t none = 0xffffffffU;

    void findRegion(std::uint32_t seed) {
        regions_[seed] = regionCount_;
        open_.push_back(seed);
        while (!open_.empty()) {
            std::uint32_t const v = open_.back();
            open_.pop_back();
            for (std::uint32_t const w : members_.plainNeighboursOf(v)) {
                if (regions_[w] == none) {
                    regions_[w] = regionCount_;
                    open_.push_back(w);
                }
            }
        }
        ++regionCount_;
    }
    // Reaches a plain conductor with its region, or one of the network's own vertices, which are in no other
    // network.
    void reach(std::uint32_t v) {
        if (!members_.isPlain(v)) {
            if (on_[v] == 0) {
                on_[v] = 1;
                open_.push_back(v);
            }
            return;
        }
        std::uint32_t const region = regions_[v];
        if (reachedBy_[region] == number_) {
            return;
        }
        reachedBy_[region] = number_;
        wasReached_[region] = 1;
        auto at = std::lower_bound(toOwn_.begin(), toOwn_.end(), std::pair(region, std::uint32_t{0}));
        for (; at != toOwn_.end() && at->first == region; ++at) {
            reach(at->second);
        }
    }

    Circuit const& circuit_;
    NetworkMembers members_;
    std::vector<std::uint8_t>& on_;
    std::vector<std::uint32_t> regions_; // by vertex, none: not plain
    std::uint32_t regionCount_ = 0;
    std::vector<std::uint32_t> reachedBy_; // by region: the number of the last network
    std::vector<std::uint8_t> wasReached_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> toOwn_; // region, own vertex beside it; ascending
    std::vector<std::uint32_t> open_;
    std::uint32_t number_ = 0;
};

} // namespace

void markSingleCable(Circuit const& circuit, std::vector<std::uint8_t>& on) {
    if (circuit.sources.empty()) {
        return;
    }
    if (circuit.sources.front().network == circuit.sources.back().network) { // the usual case
        markReached(circuit, on);
        return;
    }
    SingleCableNetworks networks(circuit, on);
    std::uint32_t number = 0;
    for (auto source = circuit.sources.begin(); source != circuit.sources.end(); ++number) {
        std::string_view const network = source->network;
        networks.mark(network, number);
        source += static_cast<std::ptrdiff_t>(terminalsOf(circuit.sources, network).size());
    }
    networks.markRegions();
}

bool SingleCableElectricity::faithful(Store const& store) {
    return isFaithful(ElectricalLevel::singleCable, store);
}

bool SingleCableElectricity::suits(Store const& store) {
    return sufficientLevel(store).level == ElectricalLevel::singleCable;
}

} // namespace trembler
