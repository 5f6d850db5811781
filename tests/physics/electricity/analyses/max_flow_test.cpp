// Flows and bottlenecks, compared with minimum cuts found by testing every set of objects.
#include "physics/electricity/analyses/max_flow.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace trembler {
namespace max_flow_test {
namespace {

/// A random circuit of at most 9 objects, and the answers by brute force.
struct Sample {
    Circuit circuit;
    std::vector<Microamperes> capacities;

    [[nodiscard]] std::uint32_t subsets() const { return 1U << circuit.size(); }
    /// The objects that current reaches from the sources, without those in `removed`.
    [[nodiscard]] std::uint32_t reachable(std::uint32_t removed) const {
        std::uint32_t reached = 0;
        for (auto const& source : circuit.sources) {
            reached |= (1U << source.vertex) & ~removed;
        }
        for (std::uint32_t before = ~reached; before != reached;) {
            before = reached;
            for (std::uint32_t v = 0; v < circuit.size(); ++v) {
                for (std::uint32_t const w : circuit.neighboursOf(v)) {
                    reached |= ((reached >> v) & 1U) << w & ~removed;
                }
            }
        }
        return reached;
    }
    [[nodiscard]] bool separates(std::uint32_t removed) const {
        std::uint32_t const reached = reachable(removed);
        return std::none_of(circuit.returns.begin(), circuit.returns.end(),
                            [&](auto const& t) { return ((reached >> t.vertex) & 1U) != 0; });
    }
    [[nodiscard]] Microamperes capacity(std::uint32_t set) const {
        Microamperes sum = 0;
        for (std::uint32_t v = 0; v < circuit.size(); ++v) {
            sum += ((set >> v) & 1U) != 0 ? capacities[v] : 0;
        }
        return std::min(sum, unlimited);
    }
};

int below(int bound) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, bound));
}

Sample randomSample() {
    Sample sample;
    auto const count = static_cast<std::uint32_t>(2 + below(8));
    std::vector<std::vector<std::uint32_t>> neighbours(count);
    for (int i = below(3 * static_cast<int>(count)); i > 0; --i) {
        auto const a = static_cast<std::uint32_t>(below(static_cast<int>(count)));
        auto const b = static_cast<std::uint32_t>(below(static_cast<int>(count)));
        if (a != b && std::find(neighbours[a].begin(), neighbours[a].end(), b) == neighbours[a].end()) {
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        }
    }
    sample.circuit.offsets.push_back(0);
    for (std::uint32_t v = 0; v < count; ++v) {
        sample.circuit.objects.push_back({(v * 7) % 11, 0}); // ids in a different order from the vertices
        sample.circuit.networks.emplace_back();
        sample.circuit.neighbours.insert(sample.circuit.neighbours.end(), neighbours[v].begin(),
                                         neighbours[v].end());
        sample.circuit.offsets.push_back(static_cast<std::uint32_t>(sample.circuit.neighbours.size()));
        sample.capacities.push_back(below(4) == 0 ? unlimited : below(6));
        if (below(4) == 0) {
            sample.circuit.sources.push_back({"", v});
        }
        if (below(4) == 0) {
            sample.circuit.returns.push_back({"", v});
        }
    }
    return sample;
}

TEST(MaxFlow, IsTheMinimumCutOverAllSetsOfObjects) {
    EXPECT_TRUE(rc::check("maximum flow is minimum cut", [] {
        Sample const sample = randomSample();
        MaxFlow const found = maxFlow(sample.circuit, NetworkMembers(sample.circuit), "", sample.capacities);
        std::vector<Microamperes> through(sample.circuit.size(), 0);
        for (auto const& [vertex, current] : found.through) {
            through[vertex] = current;
        }
        Microamperes least = unlimited;
        for (std::uint32_t set = 0; set < sample.subsets(); ++set) {
            if (sample.separates(set)) {
                least = std::min(least, sample.capacity(set));
            }
        }
        RC_ASSERT(found.total == least);
        RC_CLASSIFY(least > 0 && least < unlimited, "limited");
        if (least >= unlimited) {
            RC_ASSERT(found.bottleneck.empty());
            return;
        }
        // The bottleneck is a cut of that capacity, its objects carry their full capacity, and no object
        // carries more than its capacity.
        std::uint32_t cut = 0;
        for (std::uint32_t const v : found.bottleneck) {
            cut |= 1U << v;
            RC_ASSERT(through[v] == sample.capacities[v]);
            RC_ASSERT(through[v] > 0);
        }
        for (std::uint32_t v = 0; v < sample.circuit.size(); ++v) {
            RC_ASSERT(through[v] >= 0);
            RC_ASSERT(through[v] <= sample.capacities[v]);
        }
        std::uint32_t barred = 0; // objects of zero capacity belong to no bottleneck, but carry no current
        for (std::uint32_t v = 0; v < sample.circuit.size(); ++v) {
            barred |= sample.capacities[v] == 0 ? 1U << v : 0;
        }
        RC_ASSERT(sample.capacity(cut) == least);
        RC_ASSERT(sample.separates(cut | barred));
        // Of all minimum cuts it is the one nearest the source.
        std::uint32_t const side = sample.reachable(cut | barred);
        for (std::uint32_t set = 0; set < sample.subsets(); ++set) {
            if (sample.separates(set | barred) && sample.capacity(set) == least) {
                RC_ASSERT((side & ~(sample.reachable(set | barred) | set)) == 0U);
            }
        }
    }));
}

/// The part of a circuit that takes part in one network, as a circuit of its own, without its other
/// terminals. `vertices` are those of the whole circuit.
Circuit partOf(Circuit const& whole, std::string_view network, std::vector<std::uint32_t>& vertices) {
    Circuit part;
    part.offsets.push_back(0);
    std::vector<std::uint32_t> place(whole.size(), whole.size());
    for (std::uint32_t v = 0; v < whole.size(); ++v) {
        if (whole.takesPart(v, network)) {
            place[v] = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(v);
        }
    }
    for (std::uint32_t const v : vertices) {
        part.objects.push_back(whole.objects[v]);
        part.networks.emplace_back();
        for (std::uint32_t const w : whole.neighboursOf(v)) {
            if (place[w] < whole.size()) {
                part.neighbours.push_back(place[w]);
            }
        }
        part.offsets.push_back(static_cast<std::uint32_t>(part.neighbours.size()));
    }
    for (auto const& [from, to] :
         {std::pair(&whole.sources, &part.sources), std::pair(&whole.returns, &part.returns)}) {
        for (Circuit::Terminal const& terminal : *from) {
            if (terminal.network == network) {
                to->push_back({"", place[terminal.vertex]});
            }
        }
    }
    return part;
}

TEST(MaxFlow, OfANetworkIsThatOfItsPartOfTheCircuitAlone) {
    EXPECT_TRUE(rc::check("other networks have no influence", [] {
        Sample sample = randomSample();
        static constexpr std::array<std::string_view, 4> names{"", "a", "b", "c"};
        Circuit& circuit = sample.circuit;
        for (std::string_view& network : circuit.networks) {
            network = names[static_cast<std::size_t>(below(4))];
        }
        for (auto* const terminals : {&circuit.sources, &circuit.returns}) {
            for (Circuit::Terminal& terminal : *terminals) {
                std::string_view const only = circuit.networks[terminal.vertex];
                terminal.network = only.empty() ? names[static_cast<std::size_t>(below(4))] : only;
            }
            std::sort(terminals->begin(), terminals->end());
        }
        NetworkMembers const members(circuit);
        for (std::string_view const network : names) {
            std::vector<std::uint32_t> vertices;
            Circuit const part = partOf(circuit, network, vertices);
            std::vector<Microamperes> capacities;
            for (std::uint32_t const v : vertices) {
                capacities.push_back(sample.capacities[v]);
            }
            MaxFlow const found = maxFlow(circuit, members, network, sample.capacities);
            MaxFlow alone = maxFlow(part, NetworkMembers(part), "", capacities);
            for (auto& through : alone.through) {
                through.vertex = vertices[through.vertex];
            }
            for (std::uint32_t& v : alone.bottleneck) {
                v = vertices[v];
            }
            RC_ASSERT(found.total == alone.total);
            RC_ASSERT(found.through == alone.through);
            RC_ASSERT(found.bottleneck == alone.bottleneck);
            RC_CLASSIFY(found.total > 0 && found.total < unlimited, "limited");
        }
    }));
}

} // namespace
} // namespace max_flow_test
} // namespace trembler
